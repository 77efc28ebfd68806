# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines as other people's programs read them, beside the pattern's own points [mm]."""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import shapely
import shapely.ops

from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import BAR
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.units import to_mm

NEAR = 0.05  # mm
POINT = 25.4 / 72.0  # mm
_PIXEL = 25.4 / 96.0  # mm, the unit of svgelements
_STEPS = 24  # of a curve
_CHORD = 3.0  # of its units

#: Lines with their layer or colour.
Lines = list[tuple[str, shapely.Geometry]]


def run(*command: str | Path, **values: str) -> str:
    """What a program prints; the test is skipped where it is not installed."""
    if shutil.which(str(command[0])) is None:
        pytest.skip(f"{command[0]} is not installed")
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=120, check=False, env={**os.environ, **values}
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def pages_of(file: Path) -> tuple[int, np.ndarray]:
    """How many pages a PDF has, and width and height of the first [mm], by poppler."""
    told = run("pdfinfo", file)
    size = re.search(r"Page size:\s+([\d.]+) x ([\d.]+) pts", told)
    return int(re.search(r"Pages:\s+(\d+)", told)[1]), POINT * np.array(size.groups(), dtype=float)


def wanted(pattern: Pattern, made_for: Machine) -> Lines:
    """The contours in mm with their layer, moved as the drawing is: straight from the pattern's points."""
    roles = [role for role in Role if role in made_for.layers]
    contours = [contour for role in roles for contour in pattern.of(role)]
    low = np.min([contour.points.min(axis=0) for contour in contours], axis=0) * 1000.0
    if made_for.control_bar:
        low = low - [0.0, 10.0]
    return [
        (made_for.layers[contour.role].name, line(contour.points * 1000.0 - low, contour.closed))
        for contour in contours
    ]


def line(points: np.ndarray, closed: bool) -> shapely.Geometry:
    return (shapely.LinearRing if closed else shapely.LineString)(points)


def once_round(points: np.ndarray, overcut: float) -> shapely.Geometry:
    """The ring of a cut that goes on past its start by a length [mm], which is looked at."""
    way = shapely.LineString(points)
    again = (
        shapely.ops.substring(way, way.length - overcut, way.length) if overcut else way.interpolate(-1e-9)
    )
    assert way.interpolate(max(way.length - overcut, 0.0)).distance(shapely.Point(points[0])) < NEAR
    assert shapely.ops.substring(way, 0.0, overcut + NEAR).buffer(NEAR).covers(again)
    ring = shapely.get_coordinates(shapely.ops.substring(way, 0.0, way.length - overcut))
    return shapely.LinearRing(ring[:-1])


def apart(one: shapely.Geometry, other: shapely.Geometry) -> float:
    """The largest distance between two lines, both ways [mm]."""
    return shapely.hausdorff_distance(one.segmentize(0.5), other.segmentize(0.5))


def same(read: shapely.Geometry, contour: shapely.Geometry, near: float = NEAR) -> bool:
    """Close all along, both ways; and of the same length."""
    return apart(read, contour) < near and abs(read.length / contour.length - 1.0) < 2e-3


def compare(read: Lines, pattern: Pattern, made_for: Machine) -> None:
    """Each contour is there once, on its layer; besides only the control bar."""
    rest = list(read)
    # all of it begins at the corner of its curves, which are off by as much as a curve may be
    near = max(NEAR, 2.0 * to_mm(made_for.tolerance))
    for layer, contour in wanted(pattern, made_for):
        if layer == "SEAL" and contour.is_ring and made_for.overrun:
            found = [one for one in rest if one[0] == layer and one[1].length > contour.length + 5.0]
            found = [one for one in found if contour.buffer(NEAR).covers(one[1])]
        else:
            found = [one for one in rest if one[0] == layer and same(one[1], contour, near)]
        assert len(found) == 1, f"{layer}: {len(found)}"
        rest.remove(found[0])
    assert len(rest) == (3 if made_for.control_bar else 0)
    if rest:
        assert max(one.length for _, one in rest) == pytest.approx(BAR, abs=1e-3)


def svg_lines(text: str) -> tuple[Lines, float]:
    """The stroked lines of an SVG file with their colours, y upward from the lower edge; and its height."""
    svgelements = pytest.importorskip("svgelements")
    picture = svgelements.SVG.parse(io.StringIO(text))
    found = []
    for path in picture.elements(lambda element: isinstance(element, svgelements.Path)):
        if path.stroke is None or path.stroke.value is None:
            continue
        for part in path.as_subpaths():
            points: list[tuple[float, float]] = []
            drawn = [segment for segment in part if not isinstance(segment, svgelements.Move)]
            for segment in drawn:
                straight = isinstance(segment, (svgelements.Line, svgelements.Close))
                steps = 2 if straight else max(_STEPS, int(segment.length(error=1e-3) / _CHORD))
                for share in np.linspace(0.0, 1.0, steps):
                    at = segment.point(share)
                    points.append((float(at.x), picture.height - float(at.y)))
            if drawn:
                closed = isinstance(drawn[-1], svgelements.Close)
                found.append((path.stroke.hex, line(np.array(points) * _PIXEL, closed)))
    return found, picture.height * _PIXEL


def page_lines(file: Path, page: int, folder: Path) -> tuple[Lines, shapely.Geometry]:
    """The lines of a page of a PDF with their colours, from its lower left corner, as poppler reads them; and
    the window to which the page clips them, None without."""
    number, drawn = str(page), folder / "page.svg"
    run("pdftocairo", "-svg", "-noshrink", "-nocenter", "-f", number, "-l", number, file, drawn)
    text = drawn.read_text(encoding="utf-8")
    clips = re.findall(r"<clipPath[^>]*>\s*<path[^>]* d=\"([^\"]*)\"", text)
    found, height = svg_lines(re.sub(r"<clipPath.*?</clipPath>", "", text, flags=re.DOTALL))
    if not clips:
        return found, None
    corners = np.array(re.findall(r"(-?[\d.]+) (-?[\d.]+)", " ".join(clips)), dtype=float) * POINT
    low, high = corners.min(axis=0), corners.max(axis=0)
    return found, shapely.box(low[0], height - high[1], high[0], height - low[1])
