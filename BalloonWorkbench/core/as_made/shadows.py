# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shadows on the background of a photograph: darker, but of its colour, so they are told from a balloon."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.tracing.background import background_colours

#: A shadow leaves so much of the light at least, and changes the colour by so much at most, in RGB, 0 to 441.
_DARKEST, _TINGE = 0.35, 30.0


def without_shadows(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The picture (h, w, 4) with what is background in a shadow as bright as the rest of the background.

    Grey things on a grey background look as a shadow does and are gone, too: compare with the picture itself.
    """
    colours = rgba[..., :3].astype(np.float32)
    background = background_colours(colours, rgba[..., 3] < 128)
    light = (colours * background).sum(axis=2) / np.maximum((background**2).sum(axis=2), 1.0)
    tinge = np.linalg.norm(colours - light[..., None] * background, axis=2)
    shaded = np.clip((1.0 - tinge / _TINGE) / 0.5, 0.0, 1.0) * ((light > _DARKEST) & (light < 1.05))
    bright = colours + shaded[..., None] * (background - colours)
    return np.dstack([np.rint(bright), rgba[..., 3]]).astype(np.uint8)
