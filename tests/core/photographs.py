# SPDX-License-Identifier: LGPL-2.1-or-later
"""Photographs of a shape that is known, drawn by Pillow: turned, blurred, noisy, with shadow and glare."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

_FINE = 6
RED, SILVER, PAPER = (190, 30, 50), (150, 152, 155), (225, 222, 215)


@dataclass(frozen=True)
class Scene:
    """How a shape is photographed.

    pixel   its size [m]; turn: of the shape, degrees counter-clockwise; mirror: before it, left to right
    at      its middle, in parts of the picture
    shadow  how far it lies from the shape [px]; glare: where a spot of light lies, from the middle [px]
    uneven  how much darker the left side of the paper is
    """

    pixel: float = 0.0005
    turn: float = 0.0
    mirror: bool = False
    at: tuple[float, float] = (0.5, 0.5)
    size: tuple[int, int] = (600, 500)
    blur: float = 1.0
    noise: float = 0.0
    shadow: tuple[float, float] | None = None
    glare: tuple[float, float] | None = None
    colour: tuple[int, int, int] = RED
    paper: tuple[int, int, int] = PAPER
    uneven: float = 0.0


def photograph(loops: list[np.ndarray], **scene: Any) -> np.ndarray:
    """Pixels (h, w, 4) uint8 of loops (n, 2) m, the first one outer, in a Scene."""
    chosen = Scene(**scene)
    placed = _placed(loops, chosen)
    (width, height), at = chosen.size, chosen.at
    shape = _soft(placed, chosen.size, chosen.blur)
    light = np.ones((height, width)) - chosen.uneven * (1.0 - np.linspace(0.0, 1.0, width))[None, :]
    if chosen.shadow is not None:
        light *= 1.0 - 0.35 * _soft([loop + np.array(chosen.shadow) for loop in placed], chosen.size, 8.0)
    picture = np.array(chosen.paper)[None, None, :] * light[..., None]
    picture = picture + shape[..., None] * (np.array(chosen.colour) - picture)
    if chosen.glare is not None:
        y, x = np.mgrid[:height, :width]
        spot = np.hypot(x - at[0] * width - chosen.glare[0], y - at[1] * height - chosen.glare[1])
        picture = picture + np.exp(-((spot / 25.0) ** 4))[..., None] * (
            np.array(chosen.paper) + 20.0 - picture
        )
    picture = picture + np.random.default_rng(1).normal(0.0, chosen.noise, picture.shape)
    pixels = np.clip(np.rint(picture), 0, 255).astype(np.uint8)
    return np.dstack([pixels, np.full((height, width), 255, np.uint8)])


def _placed(loops: list[np.ndarray], scene: Scene) -> list[np.ndarray]:
    """The loops in pixels, y downward."""
    middle = 0.5 * (loops[0].min(axis=0) + loops[0].max(axis=0))
    angle = np.radians(scene.turn)
    matrix = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    if scene.mirror:
        matrix = matrix @ np.diag([-1.0, 1.0])
    turned = [(loop - middle) @ matrix.T / scene.pixel for loop in loops]
    corner = np.array(scene.at) * scene.size
    return [corner + points * [1.0, -1.0] for points in turned]


def _soft(loops: list[np.ndarray], size: tuple[int, int], blur: float) -> np.ndarray:
    """How much of each pixel is inside the first loop and outside the others (h, w)."""
    mask = Image.new("L", (size[0] * _FINE, size[1] * _FINE), 0)
    for number, loop in enumerate(loops):
        # Pillow's pixels have their centres at whole numbers
        ImageDraw.Draw(mask).polygon([tuple(at) for at in loop * _FINE - 0.5], fill=0 if number else 255)
    return np.asarray(mask.reduce(_FINE).filter(ImageFilter.GaussianBlur(blur)), dtype=float) / 255.0
