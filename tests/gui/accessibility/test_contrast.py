# SPDX-License-Identifier: LGPL-2.1-or-later
"""What we draw in colours of our own can be read on its ground, in light and dark themes, by every eye."""

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from eyes import EYES, apart, contrast, rgb
from hands import QtGui

import BalloonWorkbench
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.bags.seam_colours import FREE, WRONG, panel_tint
from BalloonWorkbench.gui.qt import HELP, ICONS, drawn_icon
from BalloonWorkbench.gui.view3d import legend, marks

_TEXT, _SIGNS = 4.5, 3.0  # contrasts that WCAG 2.1 asks for: 1.4.3 and 1.4.11
_APART = 10.0  # in CIELAB: told apart at a glance
#: Grounds of tool bars and panels: Qt's own style, FreeCAD's "Light" and "Dark", its "Behave-dark".
LIGHT, DARK = ("#efefef", "#ffffff"), ("#2a2a2a", "#333333", "#232932")
THEMES = {"light": LIGHT, "dark": DARK}
_SHARE = 0.05  # of an icon's square that has to stand out: a line of two pixels across it


def test_numbers_of_a_legend():
    """On its half clear paper, over black and over white."""
    *paper, clear = legend._PAPER
    for behind in (0.0, 255.0):
        ground = (np.array(paper) * clear + behind * (255 - clear)) / 255.0 / 255.0
        for ink in (legend._INK, legend._WARNING):
            assert contrast(np.array(ink) / 255.0, ground) >= _TEXT


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("name", sorted(path.stem for path in Path(ICONS).glob("*.svg")))
def test_icons_stand_out(name, theme):
    """Enough of an icon differs from the tool bar to be seen as what it is."""
    picture = drawn_icon(name).pixmap(48, 48).toImage().convertToFormat(QtGui.QImage.Format_RGBA8888)
    shown = pixels(picture).reshape(-1, 4) / 255.0
    for ground in map(rgb, THEMES[theme]):
        over = shown[:, :3] * shown[:, 3:] + ground * (1.0 - shown[:, 3:])
        assert np.mean(contrast(over, ground) >= _SIGNS) >= _SHARE


def style_sheets():
    """(file, its rules) of each that gives widgets colours."""
    for path in sorted(Path(BalloonWorkbench.__file__).parent.joinpath("gui").rglob("*.py")):
        rules = re.findall(r'[{"]([^{}"]*:[^{}"]*#[0-9a-fA-F]{6}[^{}"]*)', path.read_text(encoding="utf-8"))
        if rules:
            yield pytest.param([_parts(rule) for rule in rules], id=path.name)


def _parts(rule):
    """What a rule says, by property; colours alone."""
    pairs = (each.partition(":") for each in rule.split(";"))
    return {key.strip(): re.findall(r"#[0-9a-f]{6}", value) for key, _, value in pairs}


@pytest.mark.parametrize("rules", style_sheets())
def test_style_sheets(rules):
    """Text with a colour of ours has a ground of ours; a border stands out in every theme."""
    grounds = [colour for rule in rules for colour in rule.get("background", [])]
    for rule in rules:
        for ink in rule.get("color", []):
            assert grounds, f"{ink} has no ground of ours: it cannot be read in every theme"
            assert min(contrast(rgb(ink), rgb(ground)) for ground in grounds) >= _TEXT
        for line in [] if "background" in rule else rule.get("border", []):
            assert min(contrast(rgb(line), rgb(ground)) for ground in LIGHT + DARK) >= _SIGNS


def test_help():
    """Its own colours on white, which is what a page without a ground of its own has."""
    text = (HELP / "help.css").read_text(encoding="utf-8")
    rules = [
        [re.search(rf"(?:^|[ ;]){key}: (#\w+)", rule) for key in ("color", "background")]
        for rule in re.findall(r"{([^}]*)}", text)
    ]
    inks = [contrast(_long(ink), _long(ground) if ground else rgb("#ffffff")) for ink, ground in rules if ink]
    assert min(inks) >= _TEXT


def _long(match):
    text = match.group(1)
    return rgb(text if len(text) == 7 else "#" + "".join(2 * letter for letter in text[1:]))


@pytest.mark.parametrize("eye", EYES)
def test_panels_beside_each_other(eye):
    tints = [panel_tint(number) for number in range(24)]
    assert min(apart(one, other, eye) for one, other in pairwise(tints)) > _APART
    assert min(contrast((0.0, 0.0, 0.0), tint) for tint in tints) >= _TEXT, "names are written on them"


@pytest.mark.parametrize("eye", EYES)
def test_marks_of_advice(eye):
    ordered = list(marks.COLOURS.values())
    assert min(apart(one, other, eye) for one, other in pairwise(ordered)) > _APART


@pytest.mark.parametrize("eye", EYES)
def test_seams_that_are_free_or_wrong(eye):
    """They are dashed, and no seam that is right has their colour."""
    assert apart(FREE, WRONG, eye) > _APART
