# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages in a real browser, opened from files without a network, under its mouse and keys."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from browser import PROGRAM, Browser
from drawn_shapes import NAMED
from inflated import lifted

from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.artwork.picture import Picture
from BalloonWorkbench.core.film.film import Look
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.scenes.glb import glb_bytes
from BalloonWorkbench.core.scenes.surface_mesh import Painted, two_panel_meshes
from BalloonWorkbench.core.web_pages.balloon_page import BalloonPage, NamedTable, balloon_page
from BalloonWorkbench.core.web_pages.study_page import CHOSEN, RESULT, StudyColumn, StudyPage, study_page

pytestmark = pytest.mark.skipif(
    PROGRAM is None, reason="Chromium is not here: see debian-packages-readers.txt"
)

NASTY = "</title><script>document.title = 'run'</script><img src=x onerror='document.title = 1'>"
RED, BLUE, GREEN = (0, 1, 2)
SVG = b"""<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M 1 1 L 8 8"/></svg>
"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    opened = Browser(tmp_path_factory.mktemp("browser"))
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def subject() -> BalloonPage:
    """A disc, red left and blue right on the front, green behind; everything on its page has a nasty name."""
    disc = lifted(triangulate(NAMED["disc"], 0.03))
    low, size = disc.positions[:, :2].min(axis=0), np.ptp(disc.positions[:, :2], axis=0)
    front, behind = np.zeros((2, 40, 40, 4), np.uint8)
    front[:, :20], front[:, 20:], behind[:] = (220, 0, 0, 255), (0, 0, 220, 255), (0, 160, 0, 255)
    painted = Painted(*(Picture(pixels, low, size / 40) for pixels in (front, behind)))
    glb = glb_bytes(NASTY, {NASTY: two_panel_meshes([disc], 0.005, Look("matt"), painted)[0]})
    picture = np.full((30, 40, 4), (250, 200, 20, 255), np.uint8)
    return BalloonPage(
        NASTY, NASTY, glb, png_bytes(picture, 96.0), [[NamedTable(NASTY, [(NASTY, NASTY)])]],
        SVG, [("#ff0000", NASTY)], [(NASTY, NASTY)], [NASTY],
    )  # fmt: skip


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory, subject: BalloonPage) -> Path:
    path = tmp_path_factory.mktemp("page") / "report.html"
    path.write_bytes(balloon_page(subject))
    return path


def canvas(browser: Browser) -> tuple[float, ...]:
    box = browser.run(
        "(() => { const box = document.querySelector('canvas').getBoundingClientRect();"
        " return [box.x, box.y, box.width, box.height]; })()"
    )
    return tuple(box)


def middle(box: tuple[float, ...]) -> tuple[float, float]:
    return box[0] + 0.5 * box[2], box[1] + 0.5 * box[3]


def places(picture: np.ndarray, colour: int) -> np.ndarray:
    """Rows and columns (k, 2) of pixels in which one of red, green and blue is much stronger than others."""
    order = {RED: 0, BLUE: 2, GREEN: 1}[colour]
    others = np.delete(picture, order, axis=2).max(axis=2)
    return np.argwhere(picture[..., order] > others + 60)


def test_the_balloon_turns_and_zooms(browser: Browser, page: Path) -> None:
    browser.open(page)
    box = canvas(browser)
    at = middle(box)
    begun = browser.picture(*box)
    red, blue = places(begun, RED), places(begun, BLUE)
    assert min(len(red), len(blue)) > 1000
    assert red[:, 1].mean() < blue[:, 1].mean()  # as it is drawn, not mirrored
    assert not len(places(begun, GREEN))
    browser.drag(at, (at[0] + np.pi / 0.008, at[1]))  # half round
    turned = browser.picture(*box)
    assert len(places(turned, GREEN)) > 2000
    assert not len(places(turned, RED))
    browser.key("Home")
    np.testing.assert_array_equal(browser.picture(*box), begun)
    browser.wheel(at, -300.0)
    larger = browser.picture(*box)
    assert len(places(larger, RED)) > 1.3 * len(red)
    browser.run("document.querySelector('canvas').focus()")
    browser.key("Home")
    for key in ("ArrowLeft", "ArrowUp", "+"):
        before = browser.picture(*box)
        browser.key(key)
        assert np.abs(browser.picture(*box) - before).max() > 60, key
    browser.drag(at, (at[0], at[1] + 900.0))  # not over the top
    assert len(places(browser.picture(*box), GREEN)) < 0.6 * len(places(turned, GREEN))


@pytest.mark.parametrize("photograph", [False, True])
def test_the_ground_covers_what_is_behind(
    browser: Browser, subject: BalloonPage, tmp_path: Path, photograph: bool
) -> None:
    """One colour, or a photograph in its own proportions, also while the balloon turns."""
    pixels = np.full((30, 400, 4) if photograph else (1, 1, 4), (120, 60, 140, 255), np.uint8)
    if photograph:
        pixels[:, :100], pixels[:, -100:] = (0, 0, 0, 255), (0, 0, 0, 255)  # these lie outside
    path = tmp_path / "report.html"
    path.write_bytes(balloon_page(replace(subject, ground=("image/png", png_bytes(pixels, 96.0)))))
    browser.open(path)
    box = canvas(browser)
    at = middle(box)
    low = int(min(box[3], browser.run("window.innerHeight") - box[1])) - 3  # what is in sight
    shown = browser.picture(*box)
    browser.drag(at, (at[0] + 60.0, at[1] + 20.0))
    turned = browser.picture(*box)
    assert np.abs(turned - shown).max() > 60
    for seen in (shown, turned):
        corners = seen[[2, 2, low, low], [2, -3, 2, -3]]
        assert np.abs(corners - (120, 60, 140)).max() < 4
        assert len(places(seen, RED)) > 1000
    assert browser.complaints == []
    assert all(each.startswith("data:") for each in browser.asked[1:]), browser.asked


def test_nothing_is_asked_of_a_network_and_no_foreign_word_runs(browser: Browser, page: Path) -> None:
    browser.open(page)
    assert browser.run("document.title") == NASTY
    assert browser.asked[0] == page.as_uri()[:60]
    assert all(each.startswith("data:") for each in browser.asked[1:]), browser.asked
    assert browser.complaints == []
    assert browser.run("document.images.length") == 1
    assert browser.run("document.querySelector('h1').textContent") == NASTY
    assert browser.run("document.scripts.length") == 1


def test_the_page_can_be_used_without_scripts(browser: Browser, page: Path) -> None:
    """The picture is shown instead, and nobody is told to turn it."""
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    try:
        browser.open_without_scripts(page)
        shown = browser.picture()
    finally:
        browser.call("Emulation.setScriptExecutionDisabled", value=False)
    assert (np.abs(shown - (250, 200, 20)).max(axis=2) < 4).mean() > 0.1
    assert browser.run("document.querySelector('canvas')") is None
    assert browser.run("document.getElementById('balloon-keys').offsetHeight") == 0


def test_light_and_dark_and_narrow(browser: Browser, page: Path) -> None:
    try:
        for theme, light in (("light", True), ("dark", False)):
            browser.call(
                "Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}]
            )
            browser.open(page)
            assert (browser.picture()[-1].mean() > 128) == light
        sizes = {"width": 320, "height": 700, "deviceScaleFactor": 1, "mobile": False}
        browser.call("Emulation.setDeviceMetricsOverride", **sizes)
        browser.open(page)
        assert browser.run("document.documentElement.scrollWidth") <= 320
        assert len(places(browser.picture(*canvas(browser)), RED)) > 300
    finally:
        browser.call("Emulation.clearDeviceMetricsOverride")
        browser.call("Emulation.setEmulatedMedia", features=[])


def test_tables_are_sorted_by_a_press(browser: Browser, tmp_path: Path) -> None:
    """Numbers as numbers, texts with numbers by these, empty cells last."""
    values = [(10.0, "b10"), (9.0, "b9"), (None, "a"), (100.5, "b100"), (-1.0, NASTY)]
    rows = [{"volume_m3": number, "input": text, "key": text, "failure": ""} for number, text in values]
    columns = [StudyColumn("volume_m3", RESULT), StudyColumn("input", CHOSEN)]
    path = tmp_path / "study.html"
    path.write_bytes(study_page(StudyPage("Study", columns, rows)))
    browser.open(path)

    def column(number: int) -> list[str]:
        script = f"[...document.querySelectorAll('tbody tr')].map((row) => row.cells[{number}].textContent)"
        return list(browser.run(script))

    press = "document.querySelectorAll('th button')[{}].click()"
    browser.run(press.format(0))
    assert column(0) == ["-1", "9", "10", "100.5", ""]
    assert browser.run("document.querySelector('th').ariaSort") == "ascending"
    browser.run(press.format(0))
    assert column(0) == ["100.5", "10", "9", "-1", ""]
    browser.run(press.format(1))
    assert column(1) == [NASTY, "a", "b9", "b10", "b100"]
    assert browser.run("document.querySelector('th').ariaSort") is None
    assert browser.complaints == []
