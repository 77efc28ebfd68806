# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is behind a balloon: colours, photographs of any size that cover it, nothing."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.options.making import TRANSPARENT
from BalloonWorkbench.core.scenes.ground import WHITE, image_file, laid_on, read_ground


def none(path: Path) -> np.ndarray:
    raise AssertionError(f"{path} was read")


def photograph(height: int, width: int) -> np.ndarray:
    """Red left, blue right, its upper tenth green."""
    pixels = np.full((height, width, 4), (200, 0, 0, 255), np.uint8)
    pixels[:, width // 2 :] = (0, 0, 200, 255)
    pixels[: height // 10] = (0, 180, 0, 255)
    return pixels


def clear(height: int = 60, width: int = 80) -> np.ndarray:
    return np.zeros((height, width, 4))


def test_what_a_user_may_ask_for() -> None:
    assert read_ground(None, WHITE, none) is WHITE
    assert read_ground("", None, none) is None
    assert read_ground(TRANSPARENT, WHITE, none) is None
    colour = read_ground("#Ff8000", None, none)
    assert colour is not None
    assert colour.tolist() == [[[255, 128, 0, 255]]]
    for wrong in ("#ff800", "#ff80000", "#gg0000", "# ff8000"):
        with pytest.raises(InputError, match="is no colour"):
            read_ground(wrong, WHITE, none)


def test_a_picture_may_be_named_like_a_colour(tmp_path: Path) -> None:
    path = tmp_path / "#room.png"
    path.touch()
    taken = read_ground(str(path), WHITE, lambda _path: photograph(20, 30))
    assert taken is not None
    assert taken.shape == (20, 30, 4)


@pytest.mark.parametrize("size", [(60, 80), (600, 800), (30, 40), (3000, 4000), (60, 400), (900, 80), (1, 2)])
def test_a_photograph_covers_the_picture(size: tuple[int, int]) -> None:
    """In its proportions, its middle in the middle; a wide one loses its sides, a high one its top."""
    ground = read_ground("room.jpg", WHITE, lambda _path: photograph(*size))
    assert ground is not None
    pixels = laid_on(clear(), ground).astype(int)
    assert pixels.shape == (60, 80, 3)
    assert pixels[30, 4].tolist() == [200, 0, 0]
    assert pixels[30, -5].tolist() == [0, 0, 200]
    high = size[0] / size[1] > 0.76
    assert (pixels[1, 4].tolist() == [0, 180, 0]) == (not high and size[0] >= 10)


def test_the_balloon_hides_its_ground() -> None:
    """Whole, half and not at all; what is clear in the ground is white."""
    picture = clear(1, 3)
    picture[0, :2, 0] = 1.0
    picture[0, :, 3] = (1.0, 0.5, 0.0)
    green = np.array([[[0, 100, 0, 255]]], np.uint8)
    assert laid_on(picture, green)[0].tolist() == [[255, 0, 0], [128, 50, 0], [0, 100, 0]]
    assert laid_on(picture, WHITE)[0].tolist() == [[255, 0, 0], [255, 128, 128], [255, 255, 255]]
    assert laid_on(picture, np.zeros((1, 1, 4), np.uint8))[0, 2].tolist() == [255, 255, 255]


def test_a_photograph_on_a_page_is_small() -> None:
    """The most noise that there is, upright; what is clear in it is white."""
    noise = np.random.default_rng(3).integers(0, 256, (3000, 2000, 4), dtype=np.uint8)
    kind, content = image_file(noise)
    assert (kind, len(content) <= 450_000) == ("image/jpeg", True)
    assert Image.open(io.BytesIO(content)).size == (933, 1400)
    clear = Image.open(io.BytesIO(image_file(np.zeros((2, 2, 4), np.uint8))[1]))
    assert np.asarray(clear).min() == 255


def test_a_colour_on_a_page_is_exact() -> None:
    kind, content = image_file(np.array([[[16, 96, 192, 255]]], np.uint8))
    assert kind == "image/png"
    assert Image.open(io.BytesIO(content)).convert("RGB").getpixel((0, 0)) == (16, 96, 192)


def test_without_pillow_a_sentence_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(MissingPackageError, match="needs Pillow"):
        image_file(np.zeros((2, 2, 4), np.uint8))
