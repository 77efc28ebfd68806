# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut never goes through the air space: over machines, intakes and all that a pattern may carry."""

from __future__ import annotations

import json
import os
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, generated

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.machine import FOLDER, Machine, machines, read_machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.preflight import preflight
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.intake.kinds import intake_kinds
from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pattern.placement import split

SEAL = 0.005
#: What a maker has to cut: outlines, holes, and whatever notches lie on.
CUTS = {Role.CUT, Role.CUT_INNER} | {
    contour.role
    for contour in make_pattern(NAMED["disc"], SEAL, PatternOptions(intake=False, notches=9)).contours
    if np.ptp(contour.points, axis=0).max() < 0.002
}
#: All that a pattern may carry, and each alone.
EXTRAS = {
    "plain": {},
    "notches": {"notches": 24},
    "all": {
        "notches": 37,
        "notch_depth": 0.002,
        "tie_tab": True,
        "label": "A1",
        "mirror": True,
        "corner_radius": 0.001,
    },
}


def line(contour: Contour) -> shapely.Geometry:
    return (shapely.LinearRing if contour.closed else shapely.LineString)(contour.points)


def air_spaces(pattern: Pattern) -> shapely.Geometry:
    """The film between the welds of all panels of a sheet, necks included, a hair away from the welds."""
    spaces = []
    largest = max(shapely.Polygon(cut.points).area for cut in pattern.of(Role.CUT))
    for piece in split(pattern):
        film = shapely.Polygon(max((cut.points for cut in piece.of(Role.CUT)), key=len))
        if film.area < 0.5 * largest:
            spaces.append(film.buffer(-1e-4))  # a strip or a ring: nothing but its hole is cut in it
            continue
        welds = shapely.union_all([line(seal) for seal in piece.of(Role.SEAL)]).buffer(0.5 * SEAL - 5e-5)
        holes = [seal for seal in piece.of(Role.SEAL) if seal.closed and _is_hole(seal, film)]
        film = film.difference(shapely.union_all([shapely.Polygon(hole.points) for hole in holes]))
        for part in shapely.get_parts(film.difference(welds)):
            outside = part.boundary.intersection(film.exterior.buffer(1e-6)).length
            if outside < 0.4 * part.boundary.length:  # else it is the allowance outside the weld
                spaces.append(part)
    outlines = shapely.union_all([line(cut) for cut in pattern.of(Role.CUT)])
    return shapely.union_all(spaces).difference(outlines.buffer(2e-4))  # the mouth is cut, on its edge


def _is_hole(seal: Contour, film: shapely.Geometry) -> bool:
    return shapely.Polygon(seal.points).area < 0.5 * film.area


def cut_by(machine: Machine) -> set[Role]:
    """The roles that are cut when a user cuts what the machine's file is for.

    A file with cuts but no welds is cut whole; else what shares a layer, a colour or a pen with a cut is.
    """
    if Role.CUT in machine.layers and Role.SEAL not in machine.layers:
        return set(machine.layers)
    cuts = [machine.layers[role] for role in CUTS if role in machine.layers]
    return {
        role
        for role, own in machine.layers.items()
        if any(
            own.name == cut.name or own.rgb == cut.rgb or own.aci == cut.aci or
            (machine.format == "hpgl" and own.pen == cut.pen)
            for cut in cuts
        )
    }  # fmt: skip


def through_air(sheet: Pattern, air: shapely.Geometry, machine: Machine) -> list[tuple[str, float]]:
    """Lines of a machine's file that would be cut through air: role and length there [mm].

    A nozzle's bore does not count: it is meant.
    """
    if Role.CUT not in machine.layers:
        return []
    drawing = draw(sheet, replace(machine, arcs=False))
    low = np.min([path.curve.bounds[0] for path in drawing.of(Role.CUT)], axis=0) / 1000.0
    shift = np.min([cut.points.min(axis=0) for cut in sheet.of(Role.CUT)], axis=0) - low
    bores = [
        line(cut)
        for cut in sheet.of(Role.CUT_INNER)
        if cut.closed and np.ptp(cut.points, axis=0).max() < 0.009
    ]
    bad = []
    for path in drawing.paths:
        if path.role not in cut_by(machine):
            continue
        points = path.curve.flattened(0.01) / 1000.0 + shift
        drawn = shapely.LineString(np.concatenate([points, points[:1]]) if path.curve.closed else points)
        if path.role is Role.CUT_INNER and any(
            shapely.hausdorff_distance(drawn, bore) < 1e-4 for bore in bores
        ):
            continue
        inside = drawn.intersection(air).length
        if inside > 1e-5:
            bad.append((path.role.value, 1000.0 * inside))
    return bad


@pytest.mark.slow
@pytest.mark.parametrize("extras", EXTRAS)
@pytest.mark.parametrize("kind", list(intake_kinds()))
def test_nothing_is_cut_through_the_air_space(kind: str, extras: str) -> None:
    known = machines().values()
    for name in ("disc", "ring", "star") if extras == "plain" else ("heart",):
        wanted = PatternOptions(intake_kind=kind, **EXTRAS[extras])
        sheet = sheet_of(make_pattern(NAMED[name], SEAL, wanted), wanted)
        air = air_spaces(sheet)
        assert air.area > 0.5 * sheet.film_area
        alike = {(frozenset(each.layers), frozenset(cut_by(each)), each.control_bar): each for each in known}
        for machine in alike.values():
            assert not through_air(sheet, air, machine), (name, machine.name)


@pytest.mark.parametrize("seed", range(int(os.environ.get("BALLOON_LAYER_SHAPES", "1"))))
def test_nothing_is_cut_through_the_air_space_of_any_shape(seed: int) -> None:
    """Generated outlines, each with every intake and other extras."""
    known = [machines()[name] for name in ("silhouette", "lightburn-project", "any-dxf", "hpgl-plotter")]
    made = 0
    for k, kind in enumerate(intake_kinds()):
        extras = list(EXTRAS.values())[(seed + k) % len(EXTRAS)]
        wanted = PatternOptions(intake_kind=kind, intake_along=0.07 * seed if seed % 3 else None, **extras)
        try:
            sheet = sheet_of(make_pattern(generated(seed), SEAL, wanted), wanted)
        except InputError:
            continue  # no room for it there
        air = air_spaces(sheet)
        for machine in known:
            assert not through_air(sheet, air, machine), (seed, kind, machine.name)
        made += 1
    assert made


def test_the_net_sees_a_slit() -> None:
    """A line through the neck on a layer that is cut is seen, so is one in a strip."""
    wanted = PatternOptions()
    pattern = make_pattern(NAMED["disc"], SEAL, wanted)
    intake = pattern.intake
    assert intake is not None
    axis = np.array([np.cos(intake.angle), np.sin(intake.angle)])
    side = 0.3 * intake.width * np.array([-axis[1], axis[0]])
    middle = intake.at + 0.5 * intake.length * axis
    slit = Contour(Role.CUT_INNER, np.array([middle - side, middle + side]), False)
    bad = Pattern((slit, *pattern.contours), intake, SEAL, pattern.seam_length)
    assert through_air(bad, air_spaces(pattern), machines()["cutting-shop"])


def test_lines_across_a_neck_are_drawn() -> None:
    """By meaning: notches are cut, folds and marks are not; knives get none of the drawn ones."""
    roles = {
        kind: {
            line.role for line in make_pattern(NAMED["disc"], SEAL, PatternOptions(intake_kind=kind)).contours
        }
        for kind in intake_kinds()
    }
    assert {Role.FOLD, Role.PEN} <= roles["one-way-tail"]
    assert Role.PEN in roles["film-valve"] & roles["nozzle"]
    assert {role for role in Role if role.is_cut} == CUTS
    for name in ("silhouette", "cricut", "hpgl-plotter", "cutting-shop", "cutting-shop-inch"):
        assert set(machines()[name].layers) <= CUTS | {Role.REGISTRATION}, name
    for name, machine in machines().items():
        if Role.SEAL in machine.layers and Role.CUT in machine.layers:
            assert {Role.NOTCH, Role.FOLD, Role.PEN} <= set(machine.layers), name


def test_a_users_older_machine_does_not_cut_folds(tmp_path: Path) -> None:
    """A file with the one layer MARK of earlier versions writes notches there, nothing across the neck."""
    data = json.loads((FOLDER / "silhouette.json").read_text(encoding="utf-8"))
    data["layers"]["MARK"] = data["layers"].pop("NOTCH")
    path = tmp_path / "old.json"
    path.write_text(json.dumps({**data, "name": "old"}), encoding="utf-8")
    machine = read_machine(path)
    wanted = PatternOptions(intake_kind="one-way-tail", notches=24)
    pattern = make_pattern(NAMED["heart"], SEAL, wanted)
    assert set(machine.layers) == {Role.CUT, Role.CUT_INNER, Role.NOTCH, Role.REGISTRATION}
    assert len(draw(pattern, machine).of(Role.NOTCH)) == len(pattern.of(Role.NOTCH)) > 15
    (remark,) = (finding.text for finding in preflight(pattern, machine) if "MARK" in finding.text)
    assert "old.json" in remark
    assert "NOTCH" in remark
    assert not preflight(pattern, machines()["silhouette"])


def test_lightburn_burns_nothing_but_cuts() -> None:
    """The project read back: each shape on a layer whose kind is Cut or Tool; sizes and closing as drawn."""
    wanted = PatternOptions(intake_kind="one-way-tail", notches=12, label="A1")
    pattern, made_for = make_pattern(NAMED["heart"], SEAL, wanted), machines()["lightburn-project"]
    root = ElementTree.fromstring(machine_file(pattern, made_for))
    kinds = {each.find("index").get("Value"): each.get("type") for each in root.findall("CutSetting")}
    assert kinds == {"2": "Cut", "5": "Cut", "30": "Tool", "31": "Tool"}
    drawing = draw(pattern, made_for)
    shapes = root.findall("Shape")
    assert len(shapes) == len(drawing.paths)
    for shape, path in zip(shapes, drawing.by_layer, strict=True):
        assert (kinds[shape.get("CutIndex")] == "Cut") is path.role.is_cut
        points = re.findall(r"V([-\d.]+) ([-\d.]+)c0x1c1x1", shape.find("VertList").text)
        drawn = path.curve.flattened(0.005)
        assert np.array(points, dtype=float) == pytest.approx(drawn, abs=1e-4)
        edges = shape.find("PrimList").text
        assert edges == "LineClosed" if path.curve.closed else edges.count("L") == len(points) - 1
    numbers = [int(each.find("priority").get("Value")) for each in root.findall("CutSetting")]
    assert numbers == sorted(set(numbers))


def test_a_project_has_no_more_layers(tmp_path: Path) -> None:
    data = json.loads((FOLDER / "lightburn-project.json").read_text(encoding="utf-8"))
    data["layers"]["CUT"]["pen"] = 32
    path = tmp_path / "wide.json"
    path.write_text(json.dumps({**data, "name": "wide"}), encoding="utf-8")
    with pytest.raises(InputError, match="31"):
        read_machine(path)
