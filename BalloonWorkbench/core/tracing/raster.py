# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions and distances in pixel masks by OpenCV, else by SciPy, with the same numbers."""

from __future__ import annotations

from functools import lru_cache
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.types import Bools, Ints

Pixels = NDArray[np.float32]


@lru_cache(maxsize=1)
def opencv() -> ModuleType | None:
    """OpenCV if it imports and works, else None.

    Builds against another NumPy and repackaged ones fail in several ways at import or at the first call.
    """
    try:
        import cv2
    except (ImportError, AttributeError, RecursionError, OSError, SystemError):
        return None
    dots = np.full((2, 2, 3), 7, np.uint8)
    try:
        _, packed = cv2.imencode(".png", dots)
        return cv2 if np.array_equal(cv2.imdecode(packed, cv2.IMREAD_UNCHANGED), dots) else None
    except (cv2.error, AttributeError, TypeError, SystemError):
        return None


def ndimage() -> Any:
    """The package scipy.ndimage, where OpenCV is missing. Raises MissingPackageError."""
    try:
        import scipy.ndimage as package
    except ImportError as error:
        raise MissingPackageError(
            "Pictures need OpenCV or SciPy: install the package python3-opencv or python3-scipy."
        ) from error
    return package


def label(mask: Bools) -> tuple[Ints, int]:
    """Number the regions of a mask (h, w), 4-connected: labels (h, w) from 1, 0 outside; and how many.

    Which region has which number depends on the package in use.
    """
    if cv2 := opencv():
        count, labels = cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)
        return labels, count - 1
    labels, count = ndimage().label(mask)
    return labels.astype(np.int32), count


def distance(mask: Bools) -> Pixels:
    """Distance (h, w) px of each set pixel's centre to the nearest unset one's; 0 on unset pixels."""
    if mask.all():
        return np.full(mask.shape, np.hypot(mask.shape[0], mask.shape[1]), dtype=np.float32)
    if cv2 := opencv():
        return np.asarray(cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE))
    return np.asarray(ndimage().distance_transform_edt(mask), dtype=np.float32)


def grow(mask: Bools, radius: float) -> Bools:
    """The mask and all pixels within `radius` of it."""
    return distance(~mask) <= radius if mask.any() else mask


def highest_neighbour(values: NDArray[np.float32]) -> NDArray[np.intp]:
    """Flat index (h, w) of the highest of each pixel and its eight neighbours; its own among equals."""
    height, width = values.shape
    padded = np.pad(values, 1, constant_values=-np.inf)
    index = np.arange(values.size, dtype=np.intp).reshape(values.shape)
    best, where = values.copy(), index.copy()
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            other = padded[1 + dy : 1 + dy + height, 1 + dx : 1 + dx + width]
            higher = other > best
            best[higher] = other[higher]
            where[higher] = (index + dy * width + dx)[higher]
    return where


def neighbours(mask: Bools) -> Bools:
    """The mask and the eight neighbours of its pixels."""
    padded = np.pad(mask, 1)
    rows = padded[:-2] | padded[1:-1] | padded[2:]
    return np.asarray(rows[:, :-2] | rows[:, 1:-1] | rows[:, 2:])
