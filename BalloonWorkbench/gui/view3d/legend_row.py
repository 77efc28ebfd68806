# SPDX-License-Identifier: LGPL-2.1-or-later
"""Legends of several balloons in one view stand beside each other."""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.gui.qt import QtGui
from BalloonWorkbench.gui.view3d.legend import BOTTOM, TOP, Legend, corner_node, drawn, fill

#: The colour map of a balloon that shows none.
OFF = "Off"
_GAP = 8  # px between two legends
_rows: dict = {}  # by document and place, for each balloon: the node of its legend, and the picture of it


def legend_node(obj, legend: Legend, place: float):
    """A node with the legend of a balloon object; `arrange` puts it beside those that are there."""
    node, image = corner_node(legend, place)
    _rows.setdefault((obj.Document.Name, place), {})[obj.Name] = image, drawn(legend)
    return node


def title(obj, text: str) -> str:
    """The title of a legend, with the balloon's name where there are several."""
    balloons = [other for other in obj.Document.Objects if hasattr(other, "SolvedFor")]
    group = obj.getParentGroup()
    return f"{(group or obj).Label}: {text}" if len(balloons) > 1 else text


def arrange(document_name: str) -> None:
    """Let each legend of a document begin where the one before it ends."""
    document = App.listDocuments().get(document_name)
    for place in (TOP, BOTTOM):
        row = _rows.get((document_name, place), {})
        before = 0
        for name in sorted(row):
            if not _is_shown(document, name, place):
                del row[name]
                continue
            node, picture = row[name]
            fill(node, _moved(picture, before))
            before += picture.width() + _GAP


def width_of_row(document_name: str) -> int:
    """The width in pixels of the longer row of legends that a document shows."""
    document = App.listDocuments().get(document_name)
    widths = [
        sum(picture.width() + _GAP for name, (_, picture) in row.items() if _is_shown(document, name, place))
        for (owner, place), row in _rows.items()
        if owner == document_name
    ]
    return max(widths, default=0)


def _is_shown(document, name: str, place: float) -> bool:
    obj = document.getObject(name) if document is not None else None
    if obj is None or not obj.ViewObject.Visibility:
        return False
    return obj.ViewObject.ColourMap != OFF if place == TOP else obj.ViewObject.CompareOutlines


def _moved(picture, right: int):
    """A picture with so many empty pixels at its left."""
    if not right:
        return picture
    wider = QtGui.QImage(picture.width() + right, picture.height(), QtGui.QImage.Format_RGBA8888)
    wider.fill(0)
    painter = QtGui.QPainter(wider)
    painter.drawImage(right, 0, picture)
    painter.end()
    return wider
