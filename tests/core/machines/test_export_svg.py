# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG files read back as XML."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED
from read_back import begun_at, line

from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

SVG, INKSCAPE = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}"
COLOURS = {"CUT": "#ff0000", "CUT_INNER": "#0000ff", "SEAL": "#ff00ff"}


def svg_bytes(pattern: Pattern) -> bytes:
    """What goes to any program."""
    return machine_file(pattern, machine("any-svg"))


@pytest.mark.parametrize("name", NAMED)
def test_real_size_and_layers(name: str) -> None:
    pattern = build_pattern(NAMED[name], 0.005)
    root = ElementTree.fromstring(svg_bytes(pattern))
    width, height = (1000.0 * side for side in pattern.size)
    assert root.tag == f"{SVG}svg"
    assert [float(value) for value in root.attrib["viewBox"].split()] == pytest.approx(
        [0, 0, width, height], abs=1e-3
    )
    for key, size in (("width", width), ("height", height)):
        number, unit = re.fullmatch(r"([\d.]+)(mm)", root.attrib[key]).groups()
        assert unit == "mm"
        assert float(number) == pytest.approx(size, abs=1e-3)
    groups = list(root)
    assert [group.attrib["id"] for group in groups] == [role.value for role in pattern.roles]
    assert groups[-1].attrib["id"] == "CUT"
    low, high = pattern.bounds
    for group in groups:
        assert group.tag == f"{SVG}g"
        assert group.attrib[f"{INKSCAPE}groupmode"] == "layer"
        assert group.attrib[f"{INKSCAPE}label"] == group.attrib["id"]
        assert group.attrib["stroke"] == COLOURS[group.attrib["id"]]
        assert group.attrib["fill"] == "none"
        contours = list(pattern.of(Role(group.attrib["id"])))
        assert len(group) == len(contours)
        for path in group:  # in the order of a short way
            course = path.attrib["d"]
            assert course.startswith("M ")
            words = course.removeprefix("M ").removesuffix(" Z").replace(" L ", " ").split(" ")
            read = np.array(words, dtype=float).reshape(-1, 2)
            sheet = [
                1e3 * np.stack([c.points[:, 0] - low[0], high[1] - c.points[:, 1]], axis=1) for c in contours
            ]
            away = [
                line(points, c.closed).distance(shapely.Point(read[0]))
                for points, c in zip(sheet, contours, strict=True)
            ]
            number = int(np.argmin(away))
            closed = contours.pop(number).closed
            assert course.endswith(" Z") == closed
            wanted = begun_at(sheet[number], closed, read[0])
            assert read.shape == wanted.shape
            assert np.abs(read - wanted).max() < 0.01


def test_same_pattern_same_bytes() -> None:
    first, second = (svg_bytes(build_pattern(NAMED["holes"], 0.005)) for _ in range(2))
    assert first == second
