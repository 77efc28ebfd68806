# SPDX-License-Identifier: LGPL-2.1-or-later
"""Photographs of a shape that is known, drawn by Pillow: turned, blurred, noisy, with a shadow and a glare."""

from __future__ import annotations

from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

_FINE = 6
RED, SILVER, PAPER = (190, 30, 50), (150, 152, 155), (225, 222, 215)


def photograph(
    loops: list[np.ndarray],
    *,
    pixel: float = 0.0005,
    turn: float = 0.0,
    mirror: bool = False,
    at: tuple[float, float] = (0.5, 0.5),
    size: tuple[int, int] = (700, 600),
    blur: float = 1.0,
    noise: float = 0.0,
    shadow: tuple[float, float] | None = None,
    glare: tuple[float, float] | None = None,
    colour: tuple[int, int, int] = RED,
    paper: Any = PAPER,
    uneven: float = 0.0,
) -> np.ndarray:
    """Pixels (h, w, 4) uint8 of loops (n, 2) m, the first one outer.

    pixel   its size [m]; turn: of the shape, degrees counter-clockwise; mirror: before it, left to right
    at      its middle, in parts of the picture
    shadow  how far it lies from the shape [px]; glare: where a spot of light lies, from the middle [px]
    uneven  how much darker the left side of the paper is
    """
    width, height = size
    middle = 0.5 * (loops[0].min(axis=0) + loops[0].max(axis=0))
    angle = np.radians(turn)
    matrix = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    if mirror:
        matrix = matrix @ np.diag([-1.0, 1.0])
    placed = []
    for loop in loops:
        points = (loop - middle) @ matrix.T / pixel
        placed.append(np.column_stack([points[:, 0] + at[0] * width, at[1] * height - points[:, 1]]))
    shape = _soft(placed, size, blur)
    light = np.full((height, width), 1.0)
    light -= uneven * (1.0 - np.linspace(0.0, 1.0, width))[None, :]
    if shadow is not None:
        light *= 1.0 - 0.35 * _soft([loop + np.array(shadow) for loop in placed], size, 8.0)
    picture = np.array(paper)[None, None, :] * light[..., None]
    picture = picture + shape[..., None] * (np.array(colour) - picture)
    if glare is not None:
        y, x = np.mgrid[:height, :width]
        spot = np.hypot(x - at[0] * width - glare[0], y - at[1] * height - glare[1])
        picture = picture + np.exp(-((spot / 25.0) ** 4))[..., None] * (np.array(paper) + 20.0 - picture)
    picture = picture + np.random.default_rng(1).normal(0.0, noise, picture.shape)
    pixels = np.clip(np.rint(picture), 0, 255).astype(np.uint8)
    return np.dstack([pixels, np.full((height, width), 255, np.uint8)])


def _soft(loops: list[np.ndarray], size: tuple[int, int], blur: float) -> np.ndarray:
    """How much of each pixel is inside the first loop and outside the others (h, w)."""
    mask = Image.new("L", (size[0] * _FINE, size[1] * _FINE), 0)
    for number, loop in enumerate(loops):
        # Pillow's pixels have their centres at whole numbers
        ImageDraw.Draw(mask).polygon([tuple(at) for at in loop * _FINE - 0.5], fill=0 if number else 255)
    return np.asarray(mask.reduce(_FINE).filter(ImageFilter.GaussianBlur(blur)), dtype=float) / 255.0
