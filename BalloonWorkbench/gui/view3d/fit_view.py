# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits what is shown into the free part of the 3D view.

FreeCAD 1.1 lays panels over the view, and its own fit does not know of them; nor does a ball around
everything fill a narrow view.
"""

from __future__ import annotations

import math
from contextlib import contextmanager

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds, extent
from BalloonWorkbench.gui.window.overlays import covered

_AROUND = 1.1  # of what is seen
_SLACK = 0.02  # of the view that counts as nothing
_LEAST = 0.2  # of the view's width and height, that panels leave free


def fit_all(document=None) -> None:
    """Let all that is visible in a Gui document, by default the active one, fill its view."""
    view = view_of(document or Gui.ActiveDocument)
    if view is None:
        return
    corners = _corners(view, document or Gui.ActiveDocument)
    if len(corners):
        _aim(view, corners, _AROUND)
    else:
        view.fitAll()


def is_whole(document) -> bool:
    """All that is visible in a Gui document can be seen in the free part of its view."""
    view = view_of(document)
    corners = () if view is None or min(view.getSize()) < 1 else _corners(view, document)
    if not len(corners):
        return False
    low, high = _seen(view, corners)
    return not _is_hidden(view, low, high)


@contextmanager
def fit_kept(document):
    """What comes or grows meanwhile is brought into a view that had shown everything."""
    was_whole = is_whole(document)
    yield
    if was_whole and not is_whole(document):
        fit_all(document)


def keep_in_sight(document) -> None:
    """Fit anew when a panel hides some of what was in the view as a whole."""
    view = view_of(document)
    corners = () if view is None or min(view.getSize()) < 1 else _corners(view, document)
    if len(corners):
        low, high = _seen(view, corners)
        was_whole = min(low) > -_SLACK and max(high) < 1.0 + _SLACK
        if was_whole and _is_hidden(view, low, high):
            _aim(view, corners, _AROUND)


def _is_hidden(view, low, high) -> bool:
    """Some of a box, in parts of the view, lies beside its free part."""
    left, right, bottom, top = free_part(view)
    at_sides = low[0] < left - _SLACK or high[0] > right + _SLACK
    return bool(at_sides or low[1] < bottom - _SLACK or high[1] > top + _SLACK)


def fit_points(view, points, around: float = _AROUND) -> None:
    """Let points (n, 3) of the scene fill the free part of a view, and leave room around them."""
    _aim(view, points @ axes(*view.getCameraNode().orientation.getValue().getValue()).T, around)


def view_of(document):
    """The 3D view of a Gui document; None without one, as while it is being closed."""
    view = document.activeView() if document is not None else None
    if view is None or not hasattr(view, "getSceneGraph"):
        views = document.mdiViewsOfType("Gui::View3DInventor") if document is not None else []
        view = views[0] if views else None
    return view


def free_part(view) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of what panels leave free, in parts of the view's width and height."""
    if not hasattr(view, "graphicsView"):
        return 0.0, 1.0, 0.0, 1.0
    window = view.graphicsView()
    width, height = max(window.width(), 1), max(window.height(), 1)
    over_left, over_top, over_right, over_bottom = covered(window)
    left = max(_legends(view), over_left) / width
    right = 1.0 - over_right / width
    bottom, top = over_bottom / height, 1.0 - over_top / height
    if right - left < _LEAST or top - bottom < _LEAST:
        return 0.0, 1.0, 0.0, 1.0
    return left, right, bottom, top


def _legends(view) -> float:
    """The width in Qt's pixels that legends take at the left of a view."""
    from BalloonWorkbench.gui.view3d.legend_row import width_of_row

    active = Gui.ActiveDocument
    if active is None or view_of(active) != view:
        return 0.0
    return width_of_row(active.Document.Name) / view.graphicsView().devicePixelRatioF()


def _corners(view, document) -> np.ndarray:
    """Corners (n, 3) of all that is visible, along the camera's axes: right, up, backward."""
    from BalloonWorkbench.app.document.arrange import boxes

    frame = App.Placement(App.Vector(), App.Rotation(*view.getCameraNode().orientation.getValue().getValue()))
    visible = [obj for obj in document.Document.Objects if obj.Visibility and obj.ViewObject is not None]
    return np.array(
        [
            (x, y, z)
            for box in boxes(visible, frame)
            for x in (box.XMin, box.XMax)
            for y in (box.YMin, box.YMax)
            for z in (box.ZMin, box.ZMax)
        ]
    )


def _stretch(view) -> np.ndarray:
    """Half of the view's width and height, in halves of the smaller of them: Coin's height of a camera."""
    width, height = view.getSize()
    return np.array([width, height]) / min(width, height)


def _seen(view, corners) -> tuple[np.ndarray, np.ndarray]:
    """Lower left and upper right corner (2,) of points in a view, in parts of its width and height."""
    camera = view.getCameraNode()
    at = axes(*camera.orientation.getValue().getValue()) @ np.array(camera.position.getValue().getValue())
    if _is_parallel(camera):
        reach = 0.5 * camera.height.getValue()
    else:
        reach = np.maximum(at[2] - corners[:, 2:], 1e-9) * math.tan(0.5 * camera.heightAngle.getValue())
    places = 0.5 + 0.5 * (corners[:, :2] - at[:2]) / (reach * _stretch(view))
    return bounds(places)


def _is_parallel(camera) -> bool:
    from pivy import coin

    return camera.getTypeId() == coin.SoOrthographicCamera.getClassTypeId()


def _aim(view, seen, around: float) -> None:
    """Move the camera, and widen it where it sees in parallel, so that points (n, 3) are in the free part.

    seen  the points, along the camera's axes: right, up, backward
    """
    camera = view.getCameraNode()
    if min(view.getSize()) < 1:
        return
    left, right, bottom, top = free_part(view)
    low, high = 2.0 * np.array([left, bottom]) - 1.0, 2.0 * np.array([right, top]) - 1.0
    middle, half = 0.5 * (low + high), 0.5 * (high - low) / around
    low, high = (middle - half) * _stretch(view), (middle + half) * _stretch(view)
    across, depth = seen[:, :2], seen[:, 2:]
    size = max(extent(seen), 1e-3)
    if _is_parallel(camera):
        scale = max(float((np.ptp(across, axis=0) / (high - low)).max()), 1e-3 * size)
        place = 0.5 * (across.min(axis=0) + across.max(axis=0)) - 0.5 * scale * (low + high)
        away = float(depth.max()) + size
        camera.height.setValue(2.0 * scale)
    else:
        # a point is seen at (across - place) / (away - depth), and that has to be from low to high
        low, high = (side * math.tan(0.5 * camera.heightAngle.getValue()) for side in (low, high))
        nearest = ((across + high * depth).max(axis=0) - (across + low * depth).min(axis=0)) / (high - low)
        away = max(float(nearest.max()), float(depth.max()) + 0.01 * size)
        place = 0.5 * (
            (across - high * (away - depth)).max(axis=0) + (across - low * (away - depth)).min(axis=0)
        )
    turn = axes(*camera.orientation.getValue().getValue())
    camera.position.setValue(*(np.array([*place, away]) @ turn).tolist())
    camera.focalDistance.setValue(away - 0.5 * float(depth.min() + depth.max()))


def axes(x, y, z, w) -> np.ndarray:
    """Right, up and backward of a camera that was turned by a quaternion, as rows."""
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
            [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
            [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
