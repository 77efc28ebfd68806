# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours as eyes see them, with all cones or without one kind; how far two are apart, how one stands out."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from BalloonWorkbench.core.types import Floats

#: How linear colours look without one kind of cone: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A
#: physiologically-based model for simulation of color vision deficiency", IEEE TVCG 15 (2009), severity 1.
EYES = {
    "all": np.eye(3),
    "no red": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "no green": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "no blue": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
_TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
_WHITE = np.array([0.9505, 1.0, 1.089])


def rgb(colour: str) -> Floats:
    """Red, green and blue (3,) from 0 to 1 of a colour written like #ff0000."""
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)]) / 255.0


def _linear(colours: ArrayLike) -> Floats:
    values = np.asarray(colours, dtype=np.float64)
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def lab(colours: ArrayLike, eye: str = "all") -> Floats:
    """CIELAB (..., 3) of sRGB colours (..., 3) from 0 to 1, as an eye sees them."""
    parts = np.clip(_linear(colours) @ EYES[eye].T, 0.0, 1.0) @ _TO_XYZ.T / _WHITE
    f = np.where(parts > 216 / 24389, np.cbrt(parts), (24389 / 27 * parts + 16) / 116)
    light, green, blue = f[..., 1], f[..., 0] - f[..., 1], f[..., 1] - f[..., 2]
    return np.stack([116 * light - 16, 500 * green, 200 * blue], axis=-1)


def apart(one: ArrayLike, other: ArrayLike, eye: str) -> float:
    """How different two colours look: their distance in CIELAB."""
    return float(np.linalg.norm(lab(one, eye) - lab(other, eye)))


def nearest(colours: Iterable[ArrayLike], eye: str) -> float:
    """The two of some colours that look most alike: how different they are."""
    return min(apart(one, other, eye) for one, other in combinations(colours, 2))


def contrast(colours: ArrayLike, other: ArrayLike) -> Floats:
    """Of colours (..., 3) and one more, from 1 to 21, as in the Web Content Accessibility Guidelines 2.1."""
    first, second = (_linear(each) @ _TO_XYZ[1] + 0.05 for each in (colours, other))
    return np.maximum(first / second, second / first)
