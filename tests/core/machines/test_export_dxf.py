# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF files read back by ezdxf and by two programs of other people."""

from __future__ import annotations

import io
import math
import re
import shutil
import subprocess
from pathlib import Path

import ezdxf
import ezdxf.recover
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated
from read_back import begun_at, line

from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

COLOURS = {"CUT": 1, "CUT_INNER": 5, "SEAL": 6}
SHAPES = {**NAMED, **{f"generated {seed}": generated(seed) for seed in range(10)}}


def dxf_bytes(pattern: Pattern) -> bytes:
    """What goes to any program."""
    return machine_file(pattern, machine("any-dxf"))


def expected(pattern: Pattern) -> list[tuple[Role, np.ndarray, bool]]:
    """Contours in mm on the sheet, by role."""
    every = np.concatenate([contour.points for contour in pattern.contours])
    order = [contour for role in (Role.SEAL, Role.CUT_INNER, Role.CUT) for contour in pattern.of(role)]
    return [(c.role, (c.points - every.min(axis=0)) * 1000.0, c.closed) for c in order]


def as_written(wanted: list, layers: list[str], starts: list) -> list:
    """The contours in the order of a file, where those of a layer have a short way between them."""
    left, order = list(wanted), []
    for layer, start in zip(layers, starts, strict=True):
        able = [number for number, (role, _, _) in enumerate(left) if role.value == layer]
        place = shapely.Point(start)
        role, points, closed = left.pop(min(able, key=lambda number: line(*left[number][1:]).distance(place)))
        order.append((role, begun_at(points, closed, np.array(start)), closed))
    return order


@pytest.fixture(scope="module", params=SHAPES)
def pattern(request: pytest.FixtureRequest) -> Pattern:
    return build_pattern(SHAPES[request.param], 0.005)


def test_read_back_by_ezdxf(pattern: Pattern) -> None:
    document = ezdxf.read(io.StringIO(dxf_bytes(pattern).decode("cp1252")))
    auditor = document.audit()
    assert not auditor.errors
    assert not auditor.fixes
    assert document.dxfversion == "AC1015"
    header = document.header
    assert (header["$INSUNITS"], header["$MEASUREMENT"]) == (4, 1)
    width, height = (1000.0 * side for side in pattern.size)
    assert header["$EXTMIN"][:2] == (0.0, 0.0)
    assert header["$EXTMAX"][:2] == pytest.approx((width, height), abs=1e-3)
    entities = list(document.modelspace())
    assert {entity.dxftype() for entity in entities} == {"LWPOLYLINE"}
    wanted = expected(pattern)
    assert len(entities) == len(wanted)
    layers = [entity.dxf.layer for entity in entities]
    assert layers == [role.value for role, _, _ in wanted]
    starts = [entity.get_points("xy")[0] for entity in entities]
    for entity, (role, points, closed) in zip(entities, as_written(wanted, layers, starts), strict=True):
        assert entity.dxf.color == COLOURS[role.value] == document.layers.get(role.value).color
        assert entity.closed == closed
        read = np.array(entity.get_points("xy"))
        assert read.shape == points.shape  # no repeated vertex
        assert np.abs(read - points).max() < 0.01
        assert read.min() >= 0.0
        assert not entity.has_arc
    assert entities[-1].dxf.layer == "CUT"


def test_strict_reader_accepts_it(pattern: Pattern, tmp_path: Path) -> None:
    """dime's converter ends with an error at the first odd group."""
    program = shutil.which("dxf2vrml")
    if program is None:
        pytest.skip("dxf2vrml (package dime) is not installed")
    file = tmp_path / "pattern.dxf"
    file.write_bytes(dxf_bytes(pattern))
    done = subprocess.run([program, str(file)], capture_output=True, timeout=60, check=False)
    assert done.returncode == 0
    vertices = re.findall(rb"^\s*-?\d+\.?\d*\s+-?\d+\.?\d*\s+0\b", done.stdout, re.MULTILINE)
    assert len(vertices) >= sum(len(contour.points) for contour in pattern.contours)


def test_gis_reader_sees_the_same_contours(pattern: Pattern, tmp_path: Path) -> None:
    program = shutil.which("ogrinfo")
    if program is None:
        pytest.skip("ogrinfo (package gdal-bin) is not installed")
    file = tmp_path / "pattern.dxf"
    file.write_bytes(dxf_bytes(pattern))
    done = subprocess.run(
        [program, "-al", str(file)], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0
    assert "ERROR" not in done.stdout + done.stderr
    layers = re.findall(r"Layer \(String\) = (\w+)", done.stdout)
    lines = re.findall(r"LINESTRING \(([^)]*)\)", done.stdout)
    wanted = expected(pattern)
    assert layers == [role.value for role, _, _ in wanted]
    found = [np.array([[float(v) for v in pair.split()[:2]] for pair in line.split(",")]) for line in lines]
    starts = [line[0] for line in found]
    for read, (_, points, closed) in zip(found, as_written(wanted, layers, starts), strict=True):
        if closed:
            assert np.array_equal(read[0], read[-1])
        assert np.abs(read[: len(read) - closed] - points).max() < 0.01


def test_broken_files_would_be_noticed(tmp_path: Path) -> None:
    """The checks above can fail: a truncated file does."""
    content = dxf_bytes(build_pattern(NAMED["disc"], 0.005))
    with pytest.raises(ezdxf.DXFStructureError):
        ezdxf.read(io.StringIO(content[: len(content) // 2].decode("cp1252")))


def test_same_pattern_same_bytes() -> None:
    first, second = (dxf_bytes(build_pattern(NAMED["ring"], 0.005)) for _ in range(2))
    assert first == second
    assert not ezdxf.options.write_fixed_meta_data_for_testing


def test_known_square() -> None:
    """Side 100 mm without intake, weld 6 mm, allowance 1 mm: cut 114 mm."""
    points = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    contours = (Contour(Role.CUT, points * 1.14 - 0.007, True),)
    text = dxf_bytes(Pattern(contours, None, 0.006, 0.4)).decode("cp1252")
    (polyline,) = ezdxf.read(io.StringIO(text)).modelspace()
    (x, y), *corners = polyline.get_points("xy")
    assert corners == [(114.0, 0.0), (114.0, 114.0), (0.0, 114.0), (0.0, 0.0)]
    assert y == 0.0
    assert 5.0 < x < 109.0  # amid an edge
    assert math.isclose(text.count("\nLWPOLYLINE\n") + text.count("\r\nLWPOLYLINE\r\n"), 1)
