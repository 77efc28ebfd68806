# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on balloons of many panels: what is wrong is told, where it is, and nothing of what is well."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.advice.as_data import finding_data, finding_from
from BalloonWorkbench.core.advice.findings import Finding, Severity
from BalloonWorkbench.core.advice.many_panels.bag_advice import bag_advice, design_findings
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bag_pattern.make import make_bag_patterns
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import default_size
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag, divided
from BalloonWorkbench.core.bodies.gores import gored_bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.bodies.ready import ready_bag
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.making.safety import safety
from BalloonWorkbench.core.options.pattern import PatternOptions

FILM = film("bopp-foil")
ANGLES = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 60)
BALL = Profile(0.25 * np.column_stack([np.abs(np.cos(ANGLES)) * (np.abs(ANGLES) < 1.57), np.sin(ANGLES)]))


@cache
def inflated(name: str) -> BagDesign:
    if name == "band":
        fine = divided(NAMED["disc"], 1.0)
        joints = band_joints(fine.loops, 1.0)
        places = band_places(fine.loops, joints, 0.06)
        bag = banded_bag(fine, 0.06, 1.0, joints)
        return replace(at_rest(bag, places=places), source=fine)
    return at_rest(gored_bag(BALL, 8) if name == "ball" else ready_bag(name))


def at_rest(bag: Bag, **more: Any) -> BagDesign:
    return inflate_bag(bag, FILM, 300.0, mesh_size=default_size(bag, 400), **more)


def advice(design: BagDesign, accuracy: float = 0.01, **options: Any) -> dict[str, Finding]:
    patterns = make_bag_patterns(design, FILM, PatternOptions(intake=False, **options))
    strong = safety(design.inflation, FILM, exact=False)
    return {found.rule: found for found in bag_advice(design, patterns, FILM, strong, accuracy)}


def test_a_box_is_well() -> None:
    assert advice(inflated("box")) == {}


def test_the_poles_of_a_ball_are_told_at_its_ends() -> None:
    design = inflated("ball")
    pole = advice(design)["pole"]
    assert pole.text.startswith("8 panels meet")
    centre = design.inflation.positions.mean(axis=0)
    away = np.linalg.norm(design.inflation.positions - centre, axis=1)
    assert np.linalg.norm(np.array(pole.place) - centre) == pytest.approx(away.max(), rel=0.05)


def test_seams_that_turn_are_told_at_the_one_that_turns_most() -> None:
    found = advice(inflated("band"))["turning"]
    assert found.measured == pytest.approx(2.0 * np.pi, rel=0.05)
    assert np.hypot(*found.place[:2]) == pytest.approx(0.5 * max(NAMED["disc"].size), rel=0.15)
    assert "turning" not in advice(inflated("ball"))


def test_too_much_pressure_is_told_where_it_gives_way() -> None:
    design = inflated("box")
    strong = safety(design.inflation, FILM, exact=False)
    assert strong.safe_pressure is not None
    patterns = make_bag_patterns(design, FILM, PatternOptions(intake=False))
    for share, severity in ((0.9, Severity.WARNING), (0.4, Severity.SERIOUS)):
        weak = replace(strong, safe_pressure=share * strong.pressure)
        (found,) = bag_advice(design, patterns, FILM, weak)
        assert (found.rule, found.severity) == ("pressure", severity)
        assert found.place == pytest.approx(strong.place)


def test_panels_of_nearly_weld_alone_are_told() -> None:
    narrow = advice(inflated("box"), seal_width=0.08, allowance=0.0, label_height=1e-3)
    assert narrow["narrow"].severity in (Severity.WARNING, Severity.SERIOUS)
    assert "Panel " in narrow["narrow"].text


def test_gores_that_stand_out_more_than_the_accuracy_are_told() -> None:
    design = replace(inflated("ball"), source=BALL, apart=0.01)
    share = 0.01 / design.size
    assert "apart" not in advice(design, accuracy=1.1 * share)
    found = advice(design, accuracy=0.9 * share)["apart"]
    assert "8 gores stand out by up to 10 mm" in found.text


def test_a_band_leans_where_front_and_back_are_shifted() -> None:
    design = inflated("band")
    assert [found.rule for found in design_findings(design)] == []
    inflation, start = design.inflation, design.inflation.assembly.offsets[2]
    positions = inflation.positions.copy()
    positions[:, 0] += np.tan(np.radians(40.0)) * positions[:, 2]
    assert start > 0
    (found,) = design_findings(replace(design, inflation=replace(inflation, positions=positions)))
    assert (found.rule, found.severity) == ("leaning", Severity.WARNING)
    assert found.measured == pytest.approx(np.radians(40.0), abs=0.05)


def test_unrest_and_contact_are_told() -> None:
    design = inflated("band")
    inflation = design.inflation
    restless = replace(inflation, report=replace(inflation.report, converged=False))
    assert [found.rule for found in design_findings(replace(design, inflation=restless))] == ["unrest"]
    turned = inflation.positions.copy()
    turned[:, 2] *= np.where(turned[:, 0] > 0.5 * turned[:, 0].max(), -1.0, 1.0)  # one side inside out
    rules = [
        found.rule
        for found in design_findings(replace(design, inflation=replace(inflation, positions=turned)))
    ]
    assert "contact" in rules


def test_findings_survive_as_plain_data() -> None:
    pole = advice(inflated("ball"))["pole"]
    again = finding_from(finding_data(pole))
    assert (again.rule, again.severity, again.text) == (pole.rule, pole.severity, pole.text)
    assert again.place == pytest.approx(pole.place, abs=1e-7)
