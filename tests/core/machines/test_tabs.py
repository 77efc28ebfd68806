# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs: what is cut and the tabs are the contour, each as wide as was asked with the beam's width counted."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_cuts import laid_out, letter, made
from drawn_shapes import NAMED, TURN
from gcode_reader import KNIFE, LASER, held, run
from test_export_cuts import COUNT, READERS
from test_sweeps import pattern as swept_pattern

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.contour.tabs import with_tabs
from BalloonWorkbench.core.machines.machine import Machine, machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.preflight import preflight
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.making import TabOptions
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

CUTS = (Role.CUT, Role.CUT_INNER)
ANY = replace(machine("any-dxf"), control_bar=False)
NEAR = 0.05


@cache
def pattern(name: str) -> Pattern:
    if name == "laid out":
        return laid_out()
    if name == "ball":
        return swept_pattern("ball")
    outline = letter("B", 0.22) if name == "B" else NAMED[name].map(lambda loop: 0.4 * loop)
    found = made((outline,), PatternOptions(notches=7, mirror=False, tie_tab=name != "B"))
    assert found is not None
    return found


def rings(made_for: Machine, sheet: Pattern) -> list[np.ndarray]:
    """The closed cuts of the same machine without tabs and overcut, finely."""
    whole = replace(made_for, tabs=TabOptions(), overcut=0.0, knife_offset=0.0)
    return [path.curve.flattened(0.002) for role in CUTS for path in draw(sheet, whole).of(role)]


def hold(made_for: Machine, sheet: Pattern) -> int:
    """How many cuts have tabs; all others are whole."""
    tab, kerf = 1e3 * made_for.tabs.tabs, 1e3 * made_for.kerf
    drawn = draw(sheet, made_for)
    paths = [path.curve for role in CUTS for path in drawn.of(role)]
    pieces = [shapely.LineString(curve.flattened(0.002)) for curve in paths if not curve.closed]
    loose = [curve for curve in paths if curve.closed]
    notches = [shapely.LineString(path.curve.joints) for path in drawn.of(Role.NOTCH)]
    ends = shapely.MultiPoint([end for each in notches for end in shapely.get_coordinates(each)])
    whole, parted = rings(made_for, sheet), 0
    for points in whole:
        ring = shapely.LinearRing(points)
        own = [piece for piece in pieces if ring.distance(piece.interpolate(0.5, normalized=True)) < 0.02]
        if not own:
            continue
        parted += 1
        assert all(ring.buffer(0.02).covers(each) for each in own)
        assert len(own) >= 2
        assert len(own) >= ring.length // 100.0
        gap = ring.difference(shapely.union_all(own).buffer(0.005))
        gaps = shapely.get_parts(shapely.line_merge(gap))
        assert len(gaps) == len(own)
        assert ring.length == pytest.approx(
            sum(each.length for each in own) + len(own) * (tab + kerf), abs=0.2
        )
        for each in gaps:
            assert each.length + 0.01 == pytest.approx(tab + kerf, abs=NEAR)
            assert ends.is_empty or each.distance(ends) > 1.9
            around = shapely.line_merge(ring.intersection(each.centroid.buffer(0.5 * tab + 1.5)))
            steps = np.diff(shapely.get_coordinates(around), axis=0)
            assert np.abs(np.diff(np.unwrap(np.arctan2(*steps.T)))).sum() < 0.6
        for before, after in zip(own, [*own[1:], own[0]], strict=True):
            beams = [shapely.Point(at).buffer(0.5 * kerf, quad_segs=64) if kerf else shapely.Point(at)
                     for at in (before.coords[-1], after.coords[0])]  # fmt: skip
            assert beams[0].distance(beams[1]) == pytest.approx(tab, abs=NEAR)
    assert parted + len(loose) == len(whole)
    return parted


BEAM = replace(ANY, arcs=True, kerf=2e-4)


@pytest.mark.parametrize(
    ("name", "made_for"),
    [("heart", ANY), ("heart", replace(ANY, kerf=3e-3)), ("star", BEAM), ("B", BEAM), ("ball", ANY)]
    + [("laid out", BEAM)] * (COUNT > 3),
)
def test_what_is_cut_and_the_tabs_are_the_contour(name: str, made_for: Machine) -> None:
    sheet, tabbed = pattern(name), with_tabs(made_for, TabOptions(4e-4))
    free = [finding for finding in preflight(sheet, tabbed) if "two tabs" in finding.text]
    closed = [each for each in sheet.contours if each.closed and each.role in CUTS]
    parted = hold(tabbed, sheet)
    assert parted >= 1
    assert bool(free) == (parted < len(closed))


@pytest.mark.parametrize("name", ["heart", "laid out"])
def test_nothing_falls_out_of_the_film(name: str) -> None:
    """A laser's beam goes along the file: film and pieces stay one; without tabs there are many."""
    sheet = pattern(name)
    parts = {}
    for tabs in (0.0, 5e-4):
        made_for = with_tabs(held("grbl", LASER, kerf=2e-4), TabOptions(tabs))
        ways = [shapely.LineString(stroke.line) for stroke in run(sheet, made_for).strokes]
        cut = shapely.union_all([way.simplify(0.002).buffer(0.1, quad_segs=4) for way in ways])
        box = shapely.box(*cut.buffer(5.0).bounds)
        parts[tabs] = len(shapely.get_parts(box.difference(cut)))
    closed = [each for each in sheet.contours if each.closed and each.role in CUTS]
    assert parts[0.0] == 1 + len(closed)
    small = [each for each in closed if np.ptp(each.points, axis=0).max() < 0.02]
    assert parts[5e-4] == 1 + len(small)  # the hole of the tie tab


@pytest.mark.parametrize("name", ["any-dxf", "any-svg", "hpgl-plotter", "lightburn-project", "cricut"])
def test_every_format_has_the_tabs(name: str, tmp_path: Path) -> None:
    sheet = pattern("heart")
    made_for = with_tabs(replace(machine(name), overcut=0.0), TabOptions(6e-4))
    read = READERS[made_for.format](machine_file(sheet, made_for), made_for, tmp_path)
    lines = [each for _, each in read if each.length > 20.0]
    paths = [path.curve for role in CUTS for path in draw(sheet, made_for).of(role) if not path.curve.closed]
    assert len(paths) >= 4
    for curve in paths:
        way = shapely.LineString(curve.flattened(0.002))
        same = [each for each in lines if not each.is_ring and way.hausdorff_distance(each) < 0.06]
        assert len(same) == 1


def test_a_knife_leaves_the_same_tabs() -> None:
    """Its axis is ahead of the tip: the tip is drawn over the contour, and stays off the tabs."""
    sheet = pattern("star")
    made_for = with_tabs(held("linuxcnc", KNIFE, knife_offset=2.5e-4, overcut=1e-3), TabOptions(8e-4))
    nominal = [
        curve.curve for role in CUTS for curve in draw(sheet, replace(made_for, knife_offset=0.0)).of(role)
    ]
    followed = [curve.curve for role in CUTS for curve in draw(sheet, made_for).of(role)]
    assert len(nominal) == len(followed) >= 3
    for tip, axis in zip(nominal, followed, strict=True):
        if not tip.closed:
            ahead = [axis.joints[k] - tip.joints[k] for k in (0, -1)]
            assert np.hypot(*np.transpose(ahead)) == pytest.approx(0.25)


def disc(radius: float, role: Role = Role.CUT) -> Contour:
    return Contour(role, radius * np.column_stack([np.cos(TURN), np.sin(TURN)]), True)


@pytest.mark.parametrize(
    ("radius", "tab", "count"),
    [
        (0.05, 4e-4, 4),
        (0.01, 4e-4, 2),
        (0.004, 4e-4, 0),
        (0.05, 9.9e-3, 4),
        (0.02, 9.9e-3, 0),
        (0.5, 4e-4, 32),
    ],
)
def test_so_many_tabs_as_there_is_room_for(radius: float, tab: float, count: int) -> None:
    """A round piece has no straights: it is held where its bend is gentle, and told where it is not."""
    sheet = Pattern((disc(radius),), None, 0.006, 1.0)
    tabbed = with_tabs(ANY, TabOptions(tab))
    paths = draw(sheet, tabbed).paths
    assert len([path for path in paths if not path.curve.closed]) == count
    told = [finding.text for finding in preflight(sheet, tabbed) if "two tabs" in finding.text]
    assert bool(told) == (count == 0)


def test_only_small_pieces_where_that_is_wished() -> None:
    sheet = Pattern((disc(0.03), Contour(Role.CUT, disc(0.05).points + 0.2, True)), None, 0.006, 1.0)
    for below, count in ((None, 2 + 4), (0.0601, 2 + 1), (0.0599, 1 + 1)):
        assert len(draw(sheet, with_tabs(ANY, TabOptions(4e-4, below))).paths) == count


def test_a_line_twice_is_cut_once_and_keeps_its_tabs() -> None:
    """The same contour begun elsewhere: no second cut goes through the tabs of the first."""
    one = disc(0.05)
    other = replace(one, points=np.roll(one.points, 17, axis=0))
    both = with_tabs(ANY, TabOptions(4e-4))
    assert len(draw(Pattern((one, other), None, 0.006, 1.0), both).paths) == 4


@pytest.mark.parametrize("width", [1e-5, 0.4, float("nan"), -1e-3])
def test_senseless_tabs_are_refused(width: float) -> None:
    with pytest.raises(InputError, match="A tab must be"):
        with_tabs(ANY, TabOptions(width))


def test_paper_has_no_tabs() -> None:
    sheet = Pattern((disc(0.05),), None, 0.006, 1.0)
    assert draw(sheet, with_tabs(machine("paper"), TabOptions(4e-4))).of(Role.CUT)[0].curve.closed
