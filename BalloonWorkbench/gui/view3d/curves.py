# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawing against the silhouette of the balloon, as two coloured curves in the 3D view."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.app.document.kinds import is_outline
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.results.colour_map import distances
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.view3d.film_map import warnings_of
from BalloonWorkbench.gui.view3d.legend import BOTTOM, Legend, label_node
from BalloonWorkbench.gui.view3d.legend_row import legend_node, title
from BalloonWorkbench.gui.window.user_units import lengths_text

# two colours that stay apart for eyes that confuse red with green (Okabe and Ito)
DRAWING, SILHOUETTE = (0, 114, 178), (230, 159, 0)
_UNDER, _OVER, _HAIR = 6.0, 2.0, 1.0  # px: both curves are seen where they are one
_HAIRS = 4  # samples between two hairs
_SHORT = 0.05  # of the largest distance, below which a hair would be a dot


def curve_nodes(obj) -> list:
    """Nodes for a balloon object; none where there is no result. Raises BalloonError."""
    drawn = obj.Outline is not None and is_outline(obj.Outline) and bool(obj.Outline.LoopCounts)
    if not film_result.is_known(obj) or not drawn:
        return []
    inflation, _ = film_result.stored(obj)
    drawing = film_result.drawing(obj)
    measured = distances(inflation, drawing)
    place, _, largest = measured.largest
    texts = lengths_text(obj.ResidualMean.Value, obj.ResidualP95.Value, obj.ResidualMax.Value)
    legend = Legend(
        title(obj, translate("Drawing and silhouette")),
        entries=((DRAWING, translate("drawing")), (SILHOUETTE, translate("inflated"))),
        notes=(translate("apart {} in the mean, 95 % below {}, at most {}").format(*texts),),
        warnings=warnings_of(obj),
    )
    return [
        _curves([to_mm(loop) for loop in drawing.loops], DRAWING, _UNDER, closed=True),
        _curves([to_mm(loop) for loop in measured.loops], SILHOUETTE, _OVER, closed=True),
        _curves(_hairs(measured, largest), SILHOUETTE, _HAIR, closed=False),
        legend_node(obj, legend, BOTTOM),
        label_node((*to_mm(place), 0.0), lengths_text(largest)[0]),
    ]


def _hairs(measured, largest: float) -> list[np.ndarray]:
    """Short lines from the silhouette to the drawing, where they can be seen."""
    lines = []
    for loop, nearest, distance in zip(measured.loops, measured.nearest, measured.distances):
        seen = np.flatnonzero(distance > _SHORT * largest)
        seen = seen[seen % _HAIRS == 0]
        lines += [to_mm(np.stack([loop[at], nearest[at]])) for at in seen.tolist()]
    return lines


def _curves(lines, rgb, width: float, closed: bool):
    from pivy import coin

    front, style, light = coin.SoAnnotation(), coin.SoDrawStyle(), coin.SoLightModel()
    colour, pick = coin.SoBaseColor(), coin.SoPickStyle()
    pick.style.setValue(coin.SoPickStyle.UNPICKABLE)
    style.lineWidth.setValue(width)
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    colour.rgb.setValue(*(part / 255.0 for part in rgb))
    points, strips = coin.SoCoordinate3(), coin.SoLineSet()
    whole = [ring(line, closed) for line in lines]
    corners = [(x, y, 0.0) for line in whole for x, y in line.tolist()]
    points.point.setValues(0, len(corners), corners)
    strips.numVertices.setValues(0, len(whole), [len(line) for line in whole])
    if whole:
        for child in (pick, style, light, colour, points, strips):
            front.addChild(child)
    return front
