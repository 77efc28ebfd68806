# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview picture: looked at through its pixels."""

from __future__ import annotations

import io

import numpy as np
import pytest
from drawn_shapes import NAMED
from inflated import designed
from matplotlib import image

from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pictures.cards import PreviewCard, cards_png
from BalloonWorkbench.core.pictures.preview import preview_png
from BalloonWorkbench.core.pictures.render import balloon_picture, surface_picture

PAPER = np.array([0xEE, 0xF0, 0xF4]) / 255.0


def pixels_of(content: bytes) -> np.ndarray:
    return image.imread(io.BytesIO(content), format="png")[..., :3]


def near(pixels: np.ndarray, red: float, green: float, blue: float, tolerance: float = 0.12) -> np.ndarray:
    return np.abs(pixels - [red, green, blue]).max(axis=-1) < tolerance


@pytest.mark.parametrize("name", ["heart", "ring", "L", "neck"])
def test_cards_hold_what_they_say(name: str) -> None:
    design = designed(NAMED[name], 600)
    pixels = pixels_of(preview_png([design], [build_pattern(design.pattern, 0.005)]))
    assert pixels.shape == (1000, 1800, 3)
    # Between and around the cards nothing is drawn: no text runs over.
    for gap in (
        pixels[:, :24],
        pixels[:, 508:524],
        pixels[:, 1068:1084],
        pixels[:, 1778:],
        pixels[:22],
        pixels[980:],
    ):
        assert near(gap, *PAPER, tolerance=0.02).all()
    drawing, inflated = pixels[80:440, 40:500], pixels[560:900, 40:500]
    pattern, balloon = pixels[80:900, 530:1060], pixels[80:900, 1090:1770]
    assert near(drawing, 0.224, 0.259, 0.310).mean() > 0.08
    assert near(inflated, 0.953, 0.735, 0.775).mean() > 0.08
    assert near(pattern, 1.0, 0.0, 0.0).sum() > 800  # the cut
    assert near(pattern, 1.0, 0.0, 1.0, tolerance=0.3).sum() > 200  # the weld
    reddish = (balloon[..., 0] > 0.3) & (balloon[..., 0] > 2.0 * balloon[..., 2])
    assert reddish.mean() > 0.05
    assert np.ptp(balloon[reddish][:, 0]) > 0.4  # shaded, not flat


def test_same_design_same_bytes() -> None:
    design = designed(NAMED["star"], 400)
    pattern = build_pattern(design.pattern, 0.005)
    assert preview_png([design], [pattern]) == preview_png([design], [pattern])


def test_balloon_picture_shows_the_shape() -> None:
    """Opaque where the balloon is, with the hole of a ring open, over a shadow that fades out."""
    ring = balloon_picture([designed(NAMED["ring"], 600).inflation], 0.005, 300, 400)
    assert ring.shape == (400, 300, 4)
    assert ring.min() >= 0.0
    assert ring.max() <= 1.0
    opaque = ring[..., 3] > 0.99
    rows, columns = np.nonzero(opaque)
    middle = (rows.min() + rows.max()) // 2, (columns.min() + columns.max()) // 2
    assert not opaque[middle]
    shadow = (ring[..., 3] > 0.02) & (ring[..., 3] < 0.4)
    assert shadow[rows.max() + 4 :].any()
    assert ring[[0, -1], :, 3].max() < 0.02
    assert ring[:, [0, -1], 3].max() < 0.02


def test_a_surface_without_normals_is_drawn_in_numbers() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    image = surface_picture(
        (corners, np.array([[0, 1, 2]], np.int32), np.zeros((3, 3)), np.ones((3, 3))), 80, 80
    )
    assert np.isfinite(image).all()
    assert image[..., 3].max() == 1.0


def test_a_long_caption_stays_on_its_card() -> None:
    """It is written smaller rather than cut off at the next card."""
    texts = "Short", "worst: 12.34 mm (1.23 %) off, 56.78 mm at most; yellow: missed; violet: may crease"
    inked = []
    for text in texts:
        pixels = pixels_of(
            cards_png(lambda canvas, text=text: PreviewCard(canvas, 26, 26, 480, 464, "T").caption(text))
        )
        rows, columns = np.nonzero((pixels[930:965, 32:500] < 0.8).any(axis=2))
        assert 32 + columns.max() <= 26 + 480 - 20
        inked.append((np.ptp(columns), np.ptp(rows)))
    assert inked[1][0] > 400
    assert inked[1][1] < inked[0][1]
