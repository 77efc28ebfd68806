# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text is a text: each of its letters is drawn as a font gives it, or a sentence names it."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawn_shapes import NAMED
from fontTools.ttLib import TTFont
from hostile_texts import BLANK, LONG, PERHAPS, PLAIN, SAME, UNSHOWN
from matplotlib import rc_context
from matplotlib.font_manager import FontProperties, findfont
from test_assembly import POPPLER, subject, told_by

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.assembly_sheet.page import assembly_pdf
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pictures.preview import preview_png

HEIGHT = 0.002  # m


@cache
def sheet_of_film() -> Pattern:
    """A disc with room for any label."""
    return build_pattern(NAMED["disc"], 0.005)


def letters(text: str) -> list[np.ndarray]:
    """The outlines of a label, from left to right."""
    pattern = with_label(sheet_of_film(), text, HEIGHT)
    assert pattern.contours[len(pattern.of(Role.ENGRAVE)) :] == sheet_of_film().contours
    return [contour.points for contour in pattern.of(Role.ENGRAVE)]


def measured(loops: list[np.ndarray]) -> np.ndarray:
    """Width, height and enclosed area of each outline, in heights of capitals."""
    rows = []
    for loop in loops:
        x, y = loop.T / HEIGHT
        area = 0.5 * abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)))
        rows.append((np.ptp(x), np.ptp(y), area))
    return np.array(rows)


@cache
def font() -> tuple[Any, dict[int, str], float]:
    """The glyphs of DejaVu Sans by another reader of fonts, their names by letter, its units in a height."""
    from fontTools.pens.boundsPen import BoundsPen

    opened = TTFont(findfont(FontProperties(family="DejaVu Sans")))
    glyphs, names = opened.getGlyphSet(), opened.getBestCmap()
    pen = BoundsPen(glyphs)
    glyphs[names[ord("H")]].draw(pen)
    return glyphs, names, 1.0 / (pen.bounds[3] - pen.bounds[1])


def by_font_tools(text: str) -> np.ndarray:
    """What `measured` gives for each letter on its own."""
    from fontTools.pens.areaPen import AreaPen
    from fontTools.pens.boundsPen import BoundsPen
    from fontTools.pens.recordingPen import DecomposingRecordingPen

    glyphs, names, scale = font()
    rows = []
    for letter in text:
        pen = DecomposingRecordingPen(glyphs)
        glyphs[names[ord(letter)]].draw(pen)
        ends = [k for k, (what, _) in enumerate(pen.value) if what == "closePath"]
        for start, end in zip([0, *(end + 1 for end in ends)], ends):
            area, bounds = AreaPen(), BoundsPen(None)
            for what, points in pen.value[start : end + 1]:
                getattr(area, what)(*points)
                getattr(bounds, what)(*points)
            x0, y0, x1, y1 = bounds.bounds
            if x1 > x0:  # else a point by which other glyphs are placed
                rows.append((scale * (x1 - x0), scale * (y1 - y0), scale**2 * abs(area.value)))
    return np.array(rows)


@pytest.mark.parametrize("text", [*PLAIN, *SAME])
def test_label_has_the_outlines_of_its_letters(text: str) -> None:
    """As many outlines as the font's letters have, each of the same size and area."""
    found, expected = measured(letters(text)), by_font_tools(SAME.get(text, text))
    assert len(found) == len(expected)
    # in any order, each column by itself
    assert np.allclose(np.sort(found, axis=0), np.sort(expected, axis=0), rtol=0.015, atol=4e-3)


@pytest.mark.parametrize("text", BLANK)
def test_blank_label_is_none(text: str) -> None:
    assert with_label(sheet_of_film(), text, HEIGHT) is sheet_of_film()


@pytest.mark.parametrize("text", UNSHOWN)
def test_refusal_names_the_letters(text: str) -> None:
    with pytest.raises(InputError) as caught:
        letters(text)
    told = str(caught.value)
    assert all(name in told for name in UNSHOWN[text]), told
    assert told.isprintable()
    assert "leave" in told


@pytest.mark.parametrize("text", PERHAPS)
def test_other_letters_are_drawn_or_named(text: str) -> None:
    """Never as the empty box that a font has for what it lacks."""
    try:
        found = letters(text)
    except InputError as error:
        assert "U+" in str(error)
        assert str(error).isprintable()
    else:
        assert len(found) >= len(set(text) - {" ", "\u200d", "\ufe0f"})


def test_label_of_200_letters_is_refused() -> None:
    with pytest.raises(InputError, match="60 letters"):
        letters(LONG)


def test_the_users_settings_of_matplotlib_change_nothing() -> None:
    """Whoever lets LaTeX write his diagrams has it not write on film."""
    expected = letters("US$5 or $6")
    with rc_context({"text.usetex": True, "font.family": ["serif"], "font.sans-serif": ["cmr10"]}):
        found = letters("US$5 or $6")
    assert all(np.array_equal(a, b) for a, b in zip(found, expected, strict=True))


WRITERS: dict[str, Callable[[Pattern], bytes]] = {
    name: lambda pattern, name=name: machine_file(pattern, machines()[name])  # type: ignore[misc]
    for name in ("any-dxf", "any-svg", "rdworks", "hpgl-plotter")
}
WRITERS["tiles"] = lambda pattern: machine_file(pattern, machines()["paper"], "A4")


@pytest.mark.parametrize("writer", WRITERS)
def test_every_file_takes_any_label(writer: str) -> None:
    """A label is lines: the file holds none of its letters, and every writer takes it."""
    small = build_pattern(NAMED["disc"], 0.005)
    for text in PLAIN[:5]:
        content = WRITERS[writer](with_label(small, text, 0.002))
        assert text.encode() not in content or len(text) < 3


def test_preview_shows_any_label() -> None:
    about = subject("disc")
    from inflated import designed

    design = designed(NAMED["disc"], 300)
    pattern = with_label(about.pattern, "US$5 or $6", 0.002)
    expected = preview_png([design], [pattern])
    with rc_context(
        {"text.usetex": True, "font.family": ["serif"], "axes.facecolor": "red", "savefig.dpi": 30}
    ):
        assert preview_png([design], [pattern]) == expected


#: What the balloon and its film are called.
NAMES = {
    "plain": (" ".join(PLAIN[:5]), " ".join(PLAIN[5:10])),
    "others": (" ".join(PLAIN[10:14]), PLAIN[15]),
    "changed": (" ".join(SAME), "".join(BLANK)),
    "unshown": (" ".join(UNSHOWN), "a".join(UNSHOWN)),
    "perhaps": (" ".join(PERHAPS), PERHAPS[3]),
    "not bold": ("sans \U0001d5a0\U0001d5a1", PLAIN[14]),
    "long": (LONG, LONG),
}


@POPPLER
@pytest.mark.parametrize("names", NAMES)
def test_assembly_sheet_takes_any_name(tmp_path: Path, names: str) -> None:
    """As the balloon's name and its film's: no letter is missing from the fonts, plain ones can be read."""
    about, (title, material) = subject("disc"), NAMES[names]
    path = tmp_path / "sheet.pdf"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        path.write_bytes(assembly_pdf(replace(about, title=title, film=replace(about.film, title=material))))
    told = subprocess.run(["pdftotext", path, "-"], capture_output=True, check=True)
    assert not told.stderr
    read = "".join(told.stdout.decode().replace("-", "").split())
    assert "Materi" in read
    if names in ("plain", "others"):
        for text in (title, material):
            assert "".join(text.replace("-", "").split()) in read
        assert told_by("pdfinfo", path).splitlines()[0].split(None, 1)[1] == f"{title}: Assembly sheet"
    if names == "changed":
        assert "".join(" ".join(SAME.values()).split()) in read


def test_assembly_sheet_is_the_same_whatever_matplotlib_is_told() -> None:
    about = subject("disc")
    expected = assembly_pdf(about)
    with rc_context(
        {"text.usetex": True, "lines.linestyle": ":", "font.size": 30.0, "axes.unicode_minus": False}
    ):
        assert assembly_pdf(about) == expected


def test_command_line_takes_any_name_of_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Letters that are none, as in names from other systems, and a terminal that knows only plain ones."""
    drawing = tmp_path / "$\\foo$ %s {0} 🎈é \udcff.json"
    drawing.write_text('{"unit": "mm", "outer": [[0, 0], [120, 0], [120, 70], [0, 70]]}', "utf-8")
    terminal = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr(sys, "stdout", terminal)
    out = tmp_path / "$$ 🎈 \udcff"
    options = ["--label", "US$5", "--tiled", "A4", "--assembly", "A4", "--machine", "rdworks"]
    assert main(["inflate", str(drawing), "--mesh-size", "16mm", "--out", str(out), *options]) == 0
    terminal.flush()
    told = terminal.buffer.getvalue().decode("ascii")
    assert "\\udcff" in told
    assert len([line for line in told.splitlines() if line.startswith("Wrote ")]) == len(list(out.iterdir()))
    assert json.loads((out / "report.json").read_text("utf-8"))["input"]["file"]
