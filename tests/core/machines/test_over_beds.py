# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern larger than the bed, in several files: their lines together are the pattern's, and crosses tell
how the film lies."""

from __future__ import annotations

import io
from dataclasses import replace

import ezdxf
import ezdxf.path
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.machines.machine import Machine, machine
from BalloonWorkbench.core.machines.machine_file import checked_files
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.making import SPLIT
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.layout import on_one_sheet
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

MM = 1e-3
Lines = list[tuple[str, np.ndarray, bool]]


def laser(width: float, height: float, name: str = "lightburn") -> Machine:
    return replace(machine(name), bed=(width * MM, height * MM))


def gores() -> Pattern:
    """Four panels of an airship, 3 m long, side by side."""
    along = np.linspace(0.0, np.pi, 80)
    half = np.column_stack([1500.0 * (1.0 - np.cos(along)), 60.0 * np.sin(along)])
    gore = np.concatenate([half, half[-2:0:-1] * (1.0, -1.0)]) * MM
    one = Pattern((Contour(Role.CUT, gore, True),), None, 0.005, 0.4)
    return on_one_sheet([one] * 4)


def cases() -> dict[str, tuple[Pattern, Machine]]:
    star = make_pattern(NAMED["star"], 0.005, PatternOptions(notches=8, label="A1"))
    ring = build_pattern(NAMED["ring"], 0.005)
    return {
        "star": (star, laser(250, 200)),
        "ring": (ring, laser(230, 600)),
        "airship": (gores(), laser(600, 600)),
        "letter": (build_pattern(NAMED["L"], 0.005), replace(laser(170, 170), kerf=0.2 * MM)),
    }


def files_of(pattern: Pattern, made_for: Machine) -> list[Lines]:
    """Layer, points [mm] and whether closed, of the lines of each file in the order of the numbers."""
    contents, remarks = checked_files(pattern, [made_for], oversize=SPLIT)
    assert any("split over several files" in remark for remark in remarks)
    found = []
    for name in sorted(contents, key=lambda name: int("0" + "".join(filter(str.isdigit, name[-7:])))):
        lines = ezdxf.read(io.StringIO(contents[name].decode("cp1252"))).modelspace()
        found.append(
            [
                (
                    each.dxf.layer,
                    np.array([(at.x, at.y) for at in ezdxf.path.make_path(each).flattening(0.001)]),
                    bool(each.closed),
                )
                for each in lines
            ]
        )
    return found


def crosses(lines: Lines, size: float) -> np.ndarray:
    """The middles (k, 2) mm of those of a size: 10 mm are made, 14 mm are found."""
    own = [points for layer, points, _ in lines if layer == "REGISTRATION"]
    sizes = [float(np.linalg.norm(points[-1] - points[0])) for points in own]
    assert all(min(abs(each - 10.0), abs(each - 14.0)) < 1e-3 for each in sizes)
    kept = [points.mean(axis=0) for points, each in zip(own, sizes) if abs(each - size) < 1e-3]
    return np.unique(np.round(np.reshape(kept, (-1, 2)), 4), axis=0)


def laid_on(drawn: list[Lines]) -> list[np.ndarray]:
    """By crosses alone, how far (2,) mm each file lies from the first: the two that it finds are two that
    were made before, the only ones that lie so."""
    shifts, made = [np.zeros(2)], crosses(drawn[0], 10.0)
    for lines in drawn[1:]:
        first, second = crosses(lines, 14.0)
        assert np.linalg.norm(second - first) >= 40.0
        off = np.linalg.norm(made[None] - made[:, None] - (second - first), axis=2)
        pairs = np.argwhere(off < 0.01)
        assert len(pairs) == 1
        shifts.append(made[pairs[0, 0]] - first)
        made = np.concatenate([np.delete(made, pairs[0], axis=0), crosses(lines, 10.0) + shifts[-1]])
    assert not len(made)  # each is used
    return shifts


@pytest.mark.parametrize("name", ["star", "ring", "airship", "letter"])
def test_the_pieces_are_the_pattern(name: str) -> None:
    """Each file is within the bed; laid on each other by their crosses, all lines are those of the whole
    within 0.05 mm, none is cut twice but at the ends, and no cross lies in film that is used."""
    pattern, made_for = cases()[name]
    drawn = files_of(pattern, made_for)
    assert len(drawn) > 1
    width, height = 1e3 * np.array(made_for.bed)
    for lines in drawn:
        points = np.concatenate([each for _, each, _ in lines])
        assert points.min() > -1e-3
        assert (points.max(axis=0) < (width + 1e-3, height + 1e-3)).all()
    whole = draw(pattern, replace(made_for, control_bar=False, bed=None))
    shifts = laid_on(drawn)
    start = np.min(
        [(points + shift).min(axis=0) for lines, shift in zip(drawn, shifts)
         for layer, points, _ in lines if layer != "REGISTRATION"], axis=0,
    )  # fmt: skip
    film = shapely.union_all([
        shapely.Polygon(path.curve.flattened(0.01)) for path in whole.paths if path.role is Role.CUT
    ])  # fmt: skip
    for role in whole.roles:
        wanted = shapely.union_all([
            shapely.LinearRing(points) if path.curve.closed else shapely.LineString(points)
            for path in whole.of(role) for points in [path.curve.flattened(0.002)]
        ])  # fmt: skip
        layer = made_for.layers[role].name
        pieces = [
            shapely.LinearRing(points + shift - start)
            if closed
            else shapely.LineString(points + shift - start)
            for lines, shift in zip(drawn, shifts)
            for own, points, closed in lines
            if own == layer
        ]
        together = shapely.union_all(pieces)
        assert wanted.difference(together.buffer(0.05)).length < 1e-6, role
        assert together.difference(wanted.buffer(0.05)).length < 1e-6, role
        assert sum(piece.length for piece in pieces) < wanted.length + 1.3 * len(pieces)
    for lines, shift in zip(drawn, shifts):
        for at in np.concatenate([crosses(lines, 10.0), crosses(lines, 14.0)]) + shift - start:
            assert film.distance(shapely.Point(at)) > 7.0 + 1.5


def test_lines_overlap_where_they_change() -> None:
    """A cut that crosses from one file to the next is in both, 0.6 mm long."""
    pattern, made_for = cases()["ring"]
    first, second = files_of(pattern, made_for)
    shift = laid_on([first, second])[1]
    cuts = [
        shapely.union_all([shapely.LineString(points + by) for layer, points, _ in lines if layer == "CUT"])
        for lines, by in ((first, np.zeros(2)), (second, shift))
    ]
    both = cuts[0].buffer(0.02).intersection(cuts[1])
    assert len(shapely.get_parts(both)) == 2  # it crosses twice
    for each in shapely.get_parts(both):
        assert 0.5 < each.length < 0.9


def test_what_fits_is_one_file() -> None:
    """Also where it fits turned; and a pattern that is not split is as before."""
    pattern = build_pattern(NAMED["rectangle"], 0.005)
    for made_for in (laser(400, 400), laser(200, 400)):
        contents, _ = checked_files(pattern, [made_for], oversize=SPLIT)
        assert contents == checked_files(pattern, [made_for])[0]


@pytest.mark.parametrize(
    ("made_for", "text"),
    [
        (laser(50, 50), "bed of 50 mm is too small"),
        (laser(62, 62, "hpgl-plotter"), "too small to lay so much film on anew|leaves no waste"),
        (laser(120, 120), "leaves no waste film for two crosses 40 mm apart"),
        (laser(200, 200, "cutting-shop"), "cannot make crosses"),
        (laser(200, 200, "heat-sealer"), "cannot make crosses"),
    ],
)
def test_what_cannot_be_split_is_said(made_for: Machine, text: str) -> None:
    with pytest.raises(ExportError, match=text) as caught:
        checked_files(build_pattern(NAMED["disc"], 0.005), [made_for], oversize=SPLIT)
    assert str(caught.value).count(". ") <= 1


def test_a_print_is_not_split() -> None:
    pattern = build_pattern(NAMED["disc"], 0.005)
    printed = replace(
        pattern, contours=(*pattern.contours, Contour(Role.PRINT, pattern.of(Role.CUT)[0].points, True))
    )
    with pytest.raises(ExportError, match="print is not cut in parts"):
        checked_files(marked(printed), [laser(200, 200)], oversize=SPLIT)
