# SPDX-License-Identifier: LGPL-2.1-or-later
"""Telling a drawing from its background: how much of each pixel is drawn on."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import PictureError
from BalloonWorkbench.core.tracing.raster import Pixels, highest_neighbour, neighbours
from BalloonWorkbench.core.types import Bools

# A picture is cut out by its transparency where this part of its border is transparent; less than that are
# the round corners of a screenshot.
_CLEAR_BORDER = 0.25
# Colour differences are distances in RGB, 0 to 441.
_SAME_COLOUR = 14.0  # two colours nearer than this are one, even in a picture without noise
_SHADE = 40.0  # the background may differ from its own smooth model by this much
_STILL_NOISE = 70.0  # no noise makes a difference above this count as background
_PLAIN_BORDER = 0.5  # this part of the border must fit one smooth background


def coverage(rgba: NDArray[np.uint8], threshold: float = 0.0) -> Pixels:
    """Part of each pixel, 0 to 1, that is drawn on, for a picture (h, w, 4); (h, w).

    threshold  how far what is drawn is from the background, of the greatest difference; 0 finds it

    By transparency where the picture has some, else by difference from a plain or softly shaded background,
    which is learnt from the border. PictureError where neither shows a shape.
    """
    alpha = rgba[..., 3].astype(np.float32) / 255
    clear = alpha < 0.5
    if clear.all():
        raise PictureError(
            "The picture is empty: all of it is transparent. Choose a picture that shows a shape."
        )
    border = np.concatenate([clear[0], clear[-1], clear[:, 0], clear[:, -1]])
    if border.mean() >= _CLEAR_BORDER:
        opaque = np.float32(np.percentile(alpha[~clear], 95) * (2.0 * threshold or 1.0))
        return np.minimum(alpha / opaque, 1)
    colours = rgba[..., :3].astype(np.float32)
    background = background_colours(colours, clear)
    difference = np.linalg.norm(colours - background, axis=2).astype(np.float32)
    difference[clear] = 0
    highest = float(difference.max())
    if highest < _SAME_COLOUR:
        raise PictureError("The picture has a single colour. Choose one that shows a shape on a background.")
    return _soften(difference, threshold * highest or _threshold(difference, highest))


def background_colours(colours: NDArray[np.float32], clear: Bools) -> NDArray[np.float32]:
    """Colour of the background at each pixel (h, w, 3): a smooth model of what most of the border shows."""
    height, width = clear.shape
    rim = max(1, round(0.004 * min(height, width)))
    ring = np.ones(clear.shape, dtype=np.bool_)
    ring[rim:-rim, rim:-rim] = False
    ring &= ~clear
    samples = colours[ring].astype(np.float64)
    # The most frequent colour, in boxes of 16 levels, then the middle of what lies near it.
    boxes = (samples // 16).astype(np.int64) @ np.array([1, 16, 256])
    centre = samples[boxes == np.bincount(boxes).argmax()].mean(axis=0)
    near = np.linalg.norm(samples - centre, axis=1) < _SHADE
    colour = np.median(samples[near], axis=0)
    away = np.linalg.norm(samples - colour, axis=1)
    if (away < _SAME_COLOUR).mean() > 0.98 or (away[away < _SHADE] < _SAME_COLOUR / 2).all():
        plain = float((away < _SHADE).mean())
        model = np.broadcast_to(colour.astype(np.float32), colours.shape)
    else:
        # Paper in uneven light: a quadratic surface, refitted while it takes in more of the border.
        y, x = np.mgrid[-1 : 1 : height * 1j, -1 : 1 : width * 1j]
        basis = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1)
        for _ in range(6):
            surface = np.linalg.lstsq(basis[ring][near], samples[near], rcond=None)[0]
            near = np.linalg.norm(samples - basis[ring] @ surface, axis=1) < _SHADE
        plain = float(near.mean())
        model = (basis @ surface).astype(np.float32)
    if plain < _PLAIN_BORDER:
        raise PictureError(
            "The picture has no plain background around the shape. Use one with a background of one colour "
            "or a transparent one."
        )
    return model


def _threshold(difference: Pixels, highest: float) -> float:
    """Difference above which a pixel is drawn on: above the noise that compression or a camera left.

    Compression leaves its ripples within eight pixels of strong edges, so there the noise is measured.
    """
    strong = difference > 0.5 * highest
    inner = strong
    for _ in range(2):
        inner = neighbours(inner)
    outer = inner
    for _ in range(6):
        outer = neighbours(outer)
    weak = difference[outer & ~inner & (difference < 0.25 * highest)]
    noise = float(np.median(weak)) if len(weak) else 0.0
    return float(np.clip(8 * noise, _SAME_COLOUR, min(_STILL_NOISE, 0.5 * highest)))


def _soften(difference: Pixels, threshold: float) -> Pixels:
    """Coverage from colour difference: at a soft edge, the difference relative to that of the shape behind.

    Only pixels on a slope that rises from the background count as soft edge. A pale part of the shape is not
    one, also where it is next to a dark part.
    """
    drawn = difference > threshold
    uphill = highest_neighbour(difference).ravel()
    flat = difference.ravel()
    # A step up of a few levels is noise of a plain area, not the slope of an edge.
    uphill = np.where(flat[uphill] > 1.06 * flat + 4, uphill, np.arange(flat.size))
    top = uphill
    for _ in range(3):
        top = uphill[top]
    part = difference / np.maximum(flat[top].reshape(difference.shape), 1e-6)
    background = ~drawn
    outside = background
    for _ in range(4):
        outside = background | (neighbours(outside) & (part < 0.5))
    part = np.where(background, np.minimum(part, difference / np.float32(2 * threshold)), part)
    return np.where(neighbours(outside), np.minimum(part, 1), 1).astype(np.float32)
