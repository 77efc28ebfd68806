# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG files read by Inkscape, which tells sizes and draws them once more as PostScript; within 0.05 mm."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from read_back import compare, line, run

from BalloonWorkbench.core.machines.machine import Machine, machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of

WANTED = PatternOptions(intake_kind="film-valve", notches=9, mirror=True, tie_tab=True)
PATTERN = sheet_of(make_pattern(NAMED["heart"], 0.005, WANTED), WANTED)
PIXEL, POINT = 25.4 / 96.0, 25.4 / 72.0  # mm


def inkscape(tmp_path: Path, *options: str) -> str:
    return run("inkscape", *options, tmp_path / "pattern.svg", HOME=str(tmp_path), DISPLAY="")


@pytest.mark.parametrize("name", ["inkscape", "cricut", "any-svg"])
def test_inkscape_sees_the_real_size(name: str, tmp_path: Path) -> None:
    """Also of the SVG in inches."""
    drawing = draw(PATTERN, machine(name))
    (tmp_path / "pattern.svg").write_bytes(machine_file(PATTERN, machine(name)))
    told = inkscape(tmp_path, "--query-all")
    rows = re.findall(r"^([\w-]+),(.*)$", told, re.MULTILINE)
    sizes = {layer: [float(value) for value in numbers.split(",")] for layer, numbers in rows}
    whole = sizes[next(iter(sizes))]
    stroke = 0.025
    assert whole[2] * PIXEL - stroke == pytest.approx(drawing.width, abs=0.05)
    assert whole[3] * PIXEL - stroke == pytest.approx(drawing.height, abs=0.05)
    for role in drawing.roles:
        low, high = (
            np.min([path.curve.bounds[0] for path in drawing.of(role)], axis=0),
            np.max([path.curve.bounds[1] for path in drawing.of(role)], axis=0),
        )
        x, y, width, height = (PIXEL * value for value in sizes[machine(name).layers[role].name])
        assert [x + 0.5 * stroke, width - stroke] == pytest.approx([low[0], high[0] - low[0]], abs=0.05)
        bottom = drawing.height - (y + height - 0.5 * stroke)
        assert [bottom, height - stroke] == pytest.approx([low[1], high[1] - low[1]], abs=0.05)


def drawn(text: str, made_for: Machine, height: float) -> list[tuple[str, shapely.Geometry]]:
    """The lines of a page of PostScript [mm], each with the layer of its colour."""
    body = text.split("%%EndPageSetup")[1].partition("%%Trailer")[0]
    layers = {look.rgb: look.name for look in made_for.layers.values()}
    lines, stack, course, layer = [], [], [], ""
    for word in body.split():
        if re.fullmatch(r"-?\d*\.?\d+", word):
            stack.append(float(word))
            continue
        if word in ("rg", "g"):
            colour = stack[-3:] if word == "rg" else stack[-1:] * 3
            layer = layers.get("#" + "".join(f"{round(255 * value):02x}" for value in colour), "")
        elif word in ("h", "S", "s") and len(course) > 1:
            points = np.array(course) * POINT
            points[:, 1] = height - points[:, 1]
            closed = word == "h" or np.hypot(*(points[0] - points[-1])) < 1e-3
            lines.append((layer, line(points, closed)))
            course = []
        else:
            course = continued(course, word, stack)
        stack = []
    return lines


def continued(course: list[list[float]], word: str, stack: list[float]) -> list[list[float]]:
    """A path after one more of PostScript's words with its numbers."""
    if word == "m" and len(stack) >= 2:
        return [stack[-2:]]
    if word == "l" and len(stack) >= 2:
        return [*course, stack[-2:]]
    if word == "c":
        ends = np.array([course[-1], stack[-6:-4], stack[-4:-2], stack[-2:]])
        t = np.linspace(0.0, 1.0, 25)[1:, None]
        weights = np.hstack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3])
        return [*course, *(weights @ ends).tolist()]
    if word == "re":
        x, y, width, height = stack[-4:]
        return [[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]]
    return course


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inkscape", "cricut"])
def test_inkscape_draws_the_pattern(name: str, tmp_path: Path) -> None:
    made_for = machine(name)
    (tmp_path / "pattern.svg").write_bytes(machine_file(PATTERN, made_for))
    inkscape(tmp_path, "--export-type=ps", f"--export-filename={tmp_path / 'out.ps'}")
    read = drawn((tmp_path / "out.ps").read_text("latin-1"), made_for, draw(PATTERN, made_for).height)
    compare(read, PATTERN, made_for)
