# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exported pages in a real browser, from their files: the balloon is seen and turns under the mouse."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from browser import PROGRAM, Browser
from PIL import Image

pytestmark = pytest.mark.skipif(PROGRAM is None, reason="NOT TRIED: Chromium is not here")

PICTURES = Path(__file__).resolve().parents[2] / "build" / "web"
PHONE = {"width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": True}
Exported = Callable[[str], Path]


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    opened = Browser(tmp_path_factory.mktemp("browser"))
    yield opened
    opened.close()


@pytest.fixture
def phone(browser: Browser) -> Iterator[Browser]:
    browser.call("Emulation.setDeviceMetricsOverride", **PHONE)
    yield browser
    browser.call("Emulation.clearDeviceMetricsOverride")


def scene(browser: Browser) -> tuple[float, float, float, float]:
    """Left, top, width and height of the canvas in the window."""
    box = "document.querySelector('canvas').getBoundingClientRect()"
    left, top, width, height = browser.run(
        f"(() => {{ const b = {box}; return [b.x, b.y, b.width, b.height] }})()"
    )
    return left, top, width, height


def seen(browser: Browser, name: str) -> np.ndarray:
    """The picture of the balloon, also kept to be looked at."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    Image.fromarray(browser.picture().astype(np.uint8)).save(PICTURES / f"{name}.png")
    return browser.picture(*scene(browser))


def balloon_in(picture: np.ndarray) -> np.ndarray:
    """Where (h, w) something else than the card's white is."""
    return np.abs(picture - 255).max(axis=2) > 12


def insist_on_quiet(browser: Browser, page: Path) -> None:
    """Nothing was asked of a network; no script complained."""
    assert browser.asked[0] == page.as_uri()[:60]
    assert all(each.startswith("data:") for each in browser.asked[1:]), browser.asked
    assert browser.complaints == []


def turned(browser: Browser, name: str) -> tuple[np.ndarray, np.ndarray]:
    """The balloon before and after the mouse has dragged it a third of a turn."""
    before = seen(browser, name)
    left, top, width, height = scene(browser)
    middle = left + 0.5 * width, top + 0.5 * height
    browser.drag(middle, (middle[0] + 130.0, middle[1] + 60.0))
    return before, seen(browser, f"{name}, turned")


@pytest.mark.parametrize("name", ["printed", "gored", "letter", "bag"])
def test_the_balloon_is_seen_and_turns(browser: Browser, exported: Exported, name: str) -> None:
    page = exported(name) / "report.html"
    browser.open(page)
    before, after = turned(browser, name)
    for picture in (before, after):
        part = balloon_in(picture).mean()
        assert 0.05 < part < 0.9, part  # a balloon on its card, no blank, nothing cut off
        assert not balloon_in(picture)[[0, -1]].any()
        assert len(np.unique(picture[balloon_in(picture)], axis=0)) > 200  # shaded
    assert (np.abs(after - before).max(axis=2) > 24).mean() > 0.03
    insist_on_quiet(browser, page)


@pytest.mark.parametrize("name", ["printed", "gored"])
def test_on_a_phone(phone: Browser, exported: Exported, name: str) -> None:
    page = exported(name) / "report.html"
    phone.open(page)
    assert phone.run("document.documentElement.scrollWidth") <= PHONE["width"]
    before, after = turned(phone, f"{name} on a phone")
    assert 0.05 < balloon_in(before).mean() < 0.9
    assert (np.abs(after - before).max(axis=2) > 24).mean() > 0.03
    insist_on_quiet(phone, page)


@pytest.mark.parametrize(
    ("name", "above", "below"),
    [("on a colour", (16, 96, 192), (16, 96, 192)), ("on a photograph", (40, 150, 60), (130, 130, 130))],
)
def test_what_is_behind_it(
    browser: Browser, exported: Exported, name: str, above: tuple[int, ...], below: tuple[int, ...]
) -> None:
    """The ground stays where it is when the balloon turns before it; the page stays about 1 MB."""
    page = exported(name) / "report.html"
    assert page.stat().st_size < 1_300_000
    browser.open(page)
    before, after = turned(browser, name)
    height, width = before.shape[:2]
    for picture in (before, after):
        for row, colour in ((height // 10, above), (height - height // 10, below)):
            corner = picture[row - 8 : row + 8, 20:60].reshape(-1, 3).mean(axis=0)
            assert np.abs(corner - colour).max() < 6, (row, corner)
        middle = picture[height // 2, width // 2]
        assert middle[0] > middle[1] + 60  # the red heart
    assert (np.abs(after - before).max(axis=2) > 24).mean() > 0.03
    insist_on_quiet(browser, page)


def test_the_ground_is_there_without_scripts_too(browser: Browser, exported: Exported) -> None:
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open_without_scripts(exported("on a colour") / "report.html")
        shown = browser.picture()
    finally:
        browser.call("Emulation.setScriptExecutionDisabled", value=False)
    assert (np.abs(shown - (16, 96, 192)).max(axis=2) < 3).mean() > 0.2
    assert ((shown[..., 0] - shown[..., 1]) > 60).mean() > 0.05


def test_the_picture_by_itself(exported: Exported) -> None:
    colour = np.asarray(Image.open(exported("on a colour") / "balloon.png").convert("RGB")).astype(int)
    photograph = np.asarray(Image.open(exported("on a photograph") / "balloon.png").convert("RGB")).astype(
        int
    )
    assert colour.shape == photograph.shape == (1200, 1600, 3)
    assert colour[0, 0].tolist() == [16, 96, 192]
    assert np.abs(photograph[:40, :40].mean(axis=(0, 1)) - (40, 150, 60)).max() < 3
    assert np.abs(photograph[-40:, :40].mean(axis=(0, 1)) - (130, 130, 130)).max() < 3
    for picture in (colour, photograph):
        assert picture[600, 800, 0] > picture[600, 800, 1] + 60
