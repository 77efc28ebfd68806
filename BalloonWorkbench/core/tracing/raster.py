# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions and distances in pixel masks by OpenCV, else SciPy, else NumPy alone, with the same numbers."""

from __future__ import annotations

from functools import lru_cache
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

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


@lru_cache(maxsize=1)
def ndimage() -> ModuleType | None:
    """scipy.ndimage if it imports, else None."""
    try:
        import scipy.ndimage
    except ImportError:
        return None
    return scipy.ndimage


def label(mask: Bools) -> tuple[Ints, int]:
    """Number the regions of a mask (h, w), 4-connected: labels (h, w) from 1, 0 outside; and how many.

    Which region has which number depends on the package in use.
    """
    if cv2 := opencv():
        count, labels = cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)
        return labels, count - 1
    if scipy := ndimage():
        labels, count = scipy.label(mask)
        return labels.astype(np.int32), count
    return _label_runs(mask)


def distance(mask: Bools, limit: float = np.inf) -> Pixels:
    """Distance of each set pixel's centre to the nearest unset pixel's centre, (h, w) px; 0 on unset pixels.

    limit  distances above it may come back as any number above it: the NumPy way is quicker then
    """
    if mask.all():
        return np.full(mask.shape, np.hypot(mask.shape[0], mask.shape[1]), dtype=np.float32)
    if cv2 := opencv():
        return np.asarray(cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE))
    if scipy := ndimage():
        return np.asarray(scipy.distance_transform_edt(mask), dtype=np.float32)
    return _distance(mask, limit)


def grow(mask: Bools, radius: float) -> Bools:
    """The mask and all pixels within `radius` of it."""
    return distance(~mask, radius + 1) <= radius if mask.any() else mask


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


def _label_runs(mask: Bools) -> tuple[Ints, int]:
    """Regions as unions of horizontal runs that touch in neighbouring rows."""
    height, width = mask.shape
    edges = np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(np.int8), axis=1).ravel()
    # Positions in rows of width + 1: a run is [start, stop).
    start, stop = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    # The runs of the row below that overlap: those that stop after my start and start before my stop.
    below = width + 1
    first = np.searchsorted(stop, start + below, side="right")
    last = np.searchsorted(start, stop + below, side="left")
    counts = np.maximum(last - first, 0)
    one = np.repeat(np.arange(len(start)), counts)
    two = np.repeat(first, counts) + np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    root = np.arange(len(start))
    while True:
        # Hook the larger root under the smaller, then shorten all ways to the root.
        a, b = root[one], root[two]
        if (a == b).all():
            break
        np.minimum.at(root, np.maximum(a, b), np.minimum(a, b))
        while (root[root] != root).any():
            root = root[root]
    names, number = np.unique(root, return_inverse=True)
    values = np.zeros(height * (width + 1) + 1, dtype=np.int64)
    values[start] = number + 1
    values[stop] -= number + 1
    labels = np.cumsum(values)[:-1].reshape(height, width + 1)[:, :width]
    return labels.astype(np.int32), len(names)


def _distance(mask: Bools, limit: float) -> Pixels:
    """Exact distances: along the columns, then the best of column distance and offset along each row."""
    height, width = mask.shape
    far = np.int64(2) * (height + width)
    rows = np.arange(height)[:, None]
    above = rows - np.maximum.accumulate(np.where(mask, -far, rows), axis=0)
    below = np.minimum.accumulate(np.where(mask, height + far, rows)[::-1], axis=0)[::-1] - rows
    column2 = (np.minimum(above, below).astype(np.float32)) ** 2
    best = column2.copy()
    for shift in range(1, width):
        step2 = np.float32(shift) ** 2
        if step2 > min(float(best.max()), limit**2):
            break
        np.minimum(best[:, shift:], column2[:, :-shift] + step2, out=best[:, shift:])
        np.minimum(best[:, :-shift], column2[:, shift:] + step2, out=best[:, :-shift])
    return np.asarray(np.sqrt(best), dtype=np.float32)
