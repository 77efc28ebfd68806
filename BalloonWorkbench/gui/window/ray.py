# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line of sight through a pixel of the 3D view."""

from __future__ import annotations

import FreeCAD as App
import numpy as np

from BalloonWorkbench.gui.qt import position


def pixel_of(event, window) -> tuple[int, int]:
    """Where an event of the mouse is, counted as the view of a window does: from the lower left."""
    at, ratio = position(event), window.devicePixelRatioF()
    return round(at.x() * ratio), round((window.viewport().height() - 1 - at.y()) * ratio)


def ray(view, pixel: tuple[int, int], placement) -> tuple[np.ndarray, np.ndarray]:
    """A point (3,) mm and the direction (3,) of sight through a pixel, seen from an object's placement."""
    from pivy import coin

    point, camera, ahead = view.getPoint(*pixel), view.getCameraNode(), view.getViewDirection()
    if camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
        ahead = point - App.Vector(*camera.position.getValue().getValue())
    back = placement.inverse()
    ahead = back.Rotation.multVec(ahead)
    return np.array(back.multVec(point)), np.array(ahead) / ahead.Length


def pixel_size(view, pixel: tuple[int, int], place: np.ndarray, placement) -> float:
    """How many mm wide a pixel is at a place (3,) mm under it."""
    start, ahead = ray(view, pixel, placement)
    beside, turned = ray(view, (pixel[0] + 1, pixel[1]), placement)
    deep = float((place - start) @ ahead)
    return float(np.linalg.norm(beside + deep * turned - start - deep * ahead))
