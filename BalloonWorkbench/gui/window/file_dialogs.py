# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks for a picture or another drawing, in the folder where FreeCAD has opened or saved a file last."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

_PICTURES = ("png", "jpg", "jpeg", "bmp")
_LINES = ("svg", "dxf", "json")
_BODIES = ("stl", "obj", "ply", "3mf", "step", "stp", "brep", "brp", "iges", "igs")


def ask_for_drawing(parent) -> str | None:
    """The path of a picture, SVG, DXF or JSON file; None where the user does not choose one."""
    kinds = f"{_kind(translate('Drawings'), _PICTURES + _LINES)};;{_kind(translate('Pictures'), _PICTURES)}"
    return _ask(parent, translate("Choose a drawing"), kinds)


def ask_for_lines(parent, *endings: str) -> str | None:
    """The path of a file of lines, SVG, DXF or JSON where no endings are given; None for none."""
    return _ask(parent, translate("Choose a drawing"), _kind(translate("Drawings"), endings or _LINES))


def ask_for_body(parent) -> str | None:
    """The path of a mesh or of a file with a solid; None where the user does not choose one."""
    return _ask(parent, translate("Choose a body"), _kind(translate("Bodies"), _BODIES))


def ask_for_card(parent) -> str | None:
    """The path of the file of a test card; None where the user does not choose one."""
    return _ask(parent, translate("Choose a test card"), _kind(translate("Test cards"), ("json",)))


def ask_for_remnant(parent) -> str | None:
    """The path of a file of what is left of film; None where the user does not choose one."""
    return _ask(parent, translate("Choose a remnant"), _kind(translate("Remnants"), ("json",)))


def ask_for_picture(parent, *more: str) -> str | None:
    """The path of a picture, also with more endings; None where the user does not choose one."""
    return _ask(parent, translate("Choose a picture"), _kind(translate("Pictures"), _PICTURES + more))


def ask_where_to_write(parent, title: str, doc, name: str, kinds: Mapping[str, str]) -> str | None:
    """The path of a file to be written, first offered in the folder of a document's exports; None where the
    user does not choose one.

    kinds  by their endings, such as "gif", what they are called; a name without one of these endings gets
           that of the kind that was chosen
    Raises ExportError where the file is there then: the dialog has asked about another name.
    """
    lines, first = {f"{kind} (*.{ending})": ending for ending, kind in kinds.items()}, next(iter(kinds))
    offered = str(preferences.export_folder(doc) / f"{name}.{first}")
    path, line = QtWidgets.QFileDialog.getSaveFileName(parent, title, offered, ";;".join(lines))
    if not path or Path(path).suffix.lower().lstrip(".") in kinds:
        return path or None
    path += "." + lines.get(line, first)
    if Path(path).exists():
        raise ExportError(translate("{} is there already: give another name.").format(Path(path).name))
    return path


def _ask(parent, title: str, kinds: str) -> str | None:
    pictures = QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.PicturesLocation)
    folder = preferences.open_folder() or pictures
    path, _ = QtWidgets.QFileDialog.getOpenFileName(parent, title, folder, kinds)
    if not path:
        return None
    preferences.put_open_folder(os.path.dirname(path))
    return path


def _kind(title: str, endings: tuple[str, ...]) -> str:
    """A line of the chooser's list; cameras write their endings in capitals."""
    return f"{title} ({' '.join(f'*.{ending} *.{ending.upper()}' for ending in endings)})"
