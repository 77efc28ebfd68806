# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is behind a balloon that is shown to others: a colour, a photograph or nothing."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.artwork.picture import Pixels, covering
from BalloonWorkbench.core.artwork.sample import sampled
from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.options.making import TRANSPARENT
from BalloonWorkbench.core.tracing.picture import shrunk
from BalloonWorkbench.core.types import Floats

#: Pixels (h, w, 4) that cover what is behind, one of them for a colour; None is nothing.
Ground = Pixels | None
WHITE: Pixels = np.full((1, 1, 4), 255, np.uint8)
_COLOUR = re.compile("#[0-9a-fA-F]{6}")
_PNG, _JPEG, _DPI = "image/png", "image/jpeg", 96.0
#: Of a photograph on a page: its longer side [pixels], its file [bytes], qualities that are tried in turn.
_LONGEST, _LARGEST, _QUALITIES = 1400, 450_000, (85, 70, 55, 40, 25, 10)


def read_ground(text: str | None, default: Ground, read: Callable[[Path], Pixels]) -> Ground:
    """The ground that a user asks for; read: pixels (h, w, 4) of a picture file.

    Raises InputError for what is no colour, and what read raises.
    """
    if not text:
        return default
    if text == TRANSPARENT:
        return None
    if _COLOUR.fullmatch(text):
        return np.array([[[*bytes.fromhex(text[1:]), 255]]], np.uint8)
    if text.startswith("#") and not Path(text).exists():
        raise InputError(f'"{text}" is no colour: give one such as "#cc294d".')
    return shrunk(read(Path(text)))


def laid_on(picture: Floats, ground: Pixels) -> NDArray[np.uint8]:
    """Pixels (height, width, 3) of a picture (height, width, 4), values 0 to 1, laid on a ground.

    The ground covers the picture in its own proportions, its middle in the middle.
    """
    behind = _covering(ground, *picture.shape[:2]).astype(np.float64)
    behind = 255.0 + behind[..., 3:] / 255.0 * (behind[..., :3] - 255.0)  # what is clear in it is on white
    share = picture[..., 3:]
    return np.rint(255.0 * share * picture[..., :3] + behind * (1.0 - share)).astype(np.uint8)


def image_file(ground: Pixels) -> tuple[str, bytes]:
    """Media type and content of the file in which a page has a ground: exact for a colour, else small.

    Raises MissingPackageError.
    """
    if ground.shape[:2] == (1, 1):
        return _PNG, png_bytes(ground, _DPI)
    try:
        from PIL import Image  # type: ignore[import-untyped]
    except ImportError as error:
        raise MissingPackageError(
            "A photograph on a page needs Pillow: install it with pip install pillow."
        ) from error
    image = Image.fromarray(laid_on(ground / 255.0, WHITE))
    image.thumbnail((_LONGEST, _LONGEST))
    for quality in _QUALITIES:
        file = io.BytesIO()
        image.save(file, "JPEG", quality=quality)
        if file.tell() <= _LARGEST:
            break
    return _JPEG, file.getvalue()


def _covering(ground: Pixels, height: int, width: int) -> Pixels:
    if ground.shape[:2] == (1, 1):
        return ground
    large = covering(ground, np.zeros(2), np.array([width, height], float))
    x, y = np.meshgrid(np.arange(width) + 0.5, height - np.arange(height) - 0.5)
    return sampled(large.pixels, *large.columns_rows(np.stack([x, y], axis=-1)))
