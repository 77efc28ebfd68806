# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons as they come out of the workshop: closed forms, derivatives, balloons from the flat film."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.correction.fit import inflate_outline
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import AIR, GAS_CONSTANT, Filling, air_pressure
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.making.weight import film_and_valve
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.sensitivity import position_changes
from BalloonWorkbench.core.tolerances.made_balloon import Made, Nominal, made_balloon, nominal_of
from BalloonWorkbench.core.tolerances.samples import Sample, read_tolerances
from BalloonWorkbench.core.tolerances.spread import ErrorSource

MYLAR = films()["mylar"]
#: Hardly stretches, at this pressure.
PRESSURE = 500.0
TOLERANCES = read_tolerances(
    {
        "cut": {"normal": "0.2mm"},
        "weld": {"normal": "0.5mm", "per": "whole"},
        "thickness": {"uniform": "10%"},
        "modulus": {"uniform": "10%"},
        "strength": {"uniform": "10%"},
        "pressure": {"normal": "10%"},
        "temperature": {"normal": "5K"},
    }
)


@cache
def nominal(shape: str = "disc", vertices: float = 150.0, two_panels: bool = False) -> Nominal:
    outline = NAMED[shape]
    edge = float(np.sqrt(outline.area / (0.87 * vertices)))
    design = inflate_outline(outline, MYLAR, PRESSURE, mesh_size=edge, model=Model(two_panels=two_panels))
    area, valve = film_and_valve(design.pattern, MYLAR, PatternOptions())
    return nominal_of(design, MYLAR, Filling(), area, valve)


@cache
def made(*deviations: tuple[ErrorSource, float], shape: str = "disc") -> Made:
    return made_balloon(nominal(shape), Sample("1", dict(deviations)), TOLERANCES)


def test_nothing_that_strays_makes_the_nominal_balloon() -> None:
    assert made().volume == pytest.approx(nominal().inflation.volume, rel=1e-6)
    assert made().pressure == PRESSURE
    assert made().at_rest


@pytest.mark.parametrize("source", [ErrorSource.WELD, ErrorSource.CUT])
def test_the_volume_of_a_disc_grows_with_its_radius_cubed(source: ErrorSource) -> None:
    """Film that does not stretch: all lengths grow alike."""
    radius = np.hypot(*NAMED["disc"].outer.T).mean()
    grown = made((source, 0.02 * radius))
    assert grown.volume / made().volume == pytest.approx(1.02**3, rel=2e-3)
    assert grown.silhouette.size[0] / made().silhouette.size[0] == pytest.approx(1.02, rel=1e-3)
    assert grown.seam.errors[source] == pytest.approx(0.02 * radius)


def test_a_cut_outside_takes_more_film_and_a_weld_outside_does_not() -> None:
    around = np.linalg.norm(np.diff(NAMED["disc"].outer, axis=0), axis=1).sum()
    more = made((ErrorSource.CUT, 1e-3)).weight - made().weight
    assert more == pytest.approx(2.0 * MYLAR.areal_density * 1e-3 * around, rel=0.02)
    assert made((ErrorSource.WELD, 1e-3)).weight == made().weight


def test_thicker_film_weighs_more_and_changes_no_volume() -> None:
    thick = made((ErrorSource.THICKNESS, 0.1))
    assert thick.weight - nominal().valve == pytest.approx(1.1 * (made().weight - nominal().valve))
    assert thick.volume == pytest.approx(made().volume, rel=1e-3)
    assert thick.lift == pytest.approx(made().lift - (thick.weight - made().weight), abs=2e-6)


def test_stiffer_film_changes_little_and_stronger_film_bears_more() -> None:
    assert made((ErrorSource.MODULUS, 0.1)).volume == pytest.approx(made().volume, rel=1e-3)
    weak, strong = (made((ErrorSource.STRENGTH, share)).safe_pressure for share in (-0.1, 0.1))
    assert weak == pytest.approx(0.9 * made().safe_pressure, rel=0.03)
    assert strong == pytest.approx(1.1 * made().safe_pressure, rel=0.03)


def test_the_nominal_lift_is_that_of_a_report() -> None:
    lightness = Filling().lightness(PRESSURE)
    assert made().lift == pytest.approx(lightness * made().volume - made().weight, abs=1e-9)


def test_a_warmer_balloon_keeps_its_gas() -> None:
    """(p0 + p) V / T stays; film that hardly stretches puts nearly all of it into the pressure."""
    outside, air = air_pressure(0.0), Filling().air_temperature
    for kelvin in (1.0, 5.0):
        warm = made((ErrorSource.TEMPERATURE, kelvin))
        ratio = (outside + warm.pressure) * warm.volume / ((outside + PRESSURE) * made().volume)
        assert ratio == pytest.approx((air + kelvin) / air, rel=1e-5)
        assert warm.pressure == pytest.approx((outside + PRESSURE) * (air + kelvin) / air - outside, rel=0.3)
        gas = (outside + PRESSURE) * made().volume / (GAS_CONSTANT * air) * Filling().gas.molar_mass
        lifted = outside * AIR / (GAS_CONSTANT * (air + kelvin)) * warm.volume
        assert warm.lift == pytest.approx(lifted - gas - made().weight, abs=1e-9)
        assert warm.safe_pressure == made().safe_pressure


def test_a_cold_balloon_is_limp() -> None:
    """The volume is that of its gas, and it carries what it did: density falls and volume grows with T."""
    cold = made((ErrorSource.TEMPERATURE, -20.0))
    outside, air = air_pressure(0.0), Filling().air_temperature
    assert cold.pressure == 0.0
    assert cold.volume == pytest.approx((outside + PRESSURE) / outside * made().volume * (air - 20.0) / air)
    heavier = made().lift + made().weight
    assert cold.lift + cold.weight == pytest.approx(heavier, rel=0.01)


def test_a_slightly_cold_balloon_keeps_some_pressure() -> None:
    cold = made((ErrorSource.TEMPERATURE, -0.5))
    assert 0.0 < cold.pressure < PRESSURE
    outside, air = air_pressure(0.0), Filling().air_temperature
    ratio = (outside + cold.pressure) * cold.volume / ((outside + PRESSURE) * made().volume)
    assert ratio == pytest.approx((air - 0.5) / air, rel=1e-5)


def test_more_pressure_at_filling_is_the_pressure() -> None:
    assert made((ErrorSource.PRESSURE, 0.1)).pressure == pytest.approx(1.1 * PRESSURE)


def test_from_the_nominal_balloon_or_from_the_flat_film_it_is_the_same() -> None:
    """Within a small part of what different errors make of it."""
    sample = Sample("1", {ErrorSource.THICKNESS: 0.05}, {ErrorSource.CUT: 1})
    warm, cold = (made_balloon(nominal("heart"), sample, TOLERANCES, warm=each) for each in (True, False))
    other = made_balloon(nominal("heart"), Sample("2", {}, {ErrorSource.CUT: 3}), TOLERANCES)
    assert warm.seam.kept
    assert abs(warm.volume - cold.volume) < 0.03 * abs(warm.volume - other.volume)
    assert abs(warm.silhouette_error.mean - cold.silhouette_error.mean) < 2e-6
    assert warm.safe_pressure == pytest.approx(cold.safe_pressure, rel=2e-3)


def test_small_errors_act_as_the_derivative_says() -> None:
    one = nominal("heart")
    sample = Sample("1", {}, {ErrorSource.CUT: 5})
    small = read_tolerances({"cut": {"normal": "0.05mm", "along": "200mm"}})
    balloon, triangles = made_balloon(one, sample, small), one.inflation.panel.triangles
    before = one.inflation.positions
    moves = (balloon.seam.panel.rest_positions - one.inflation.panel.rest_positions)[:, :, None]
    changes = position_changes(one.inflation, MYLAR, moves).changes[:, :, 0]
    nominal_volume = facet_volume(before, triangles)
    foretold = facet_volume(before + changes, triangles) - nominal_volume
    assert abs(foretold) > 2e-4 * nominal_volume
    assert facet_volume(balloon.inflation.positions, triangles) - nominal_volume == pytest.approx(
        foretold, rel=0.05
    )


def test_the_same_sample_is_the_same_balloon_to_the_last_bit() -> None:
    sample = Sample("7", {ErrorSource.TEMPERATURE: 2.0}, {ErrorSource.CUT: 7})
    one, other = (made_balloon(nominal("heart"), sample, TOLERANCES) for _ in range(2))
    assert (one.volume, one.lift, one.safe_pressure) == (other.volume, other.lift, other.safe_pressure)
    assert one.silhouette_error == other.silhouette_error


def test_welded_spots_are_not_cut() -> None:
    """Their edge does not grow with the cutter's error; a hole's does."""
    ring = NAMED["ring"]
    spotted = replace(ring, holes=(), spots=ring.holes)
    grown = []
    for outline in (ring, spotted):
        design = inflate_outline(outline, MYLAR, PRESSURE, mesh_size=0.02)
        one = nominal_of(design, MYLAR, Filling(), 0.1, 0.0)
        grown.append(made_balloon(one, Sample("1", {ErrorSource.CUT: 1e-4}), TOLERANCES).seam.grown)
    loops = [np.linalg.norm(np.diff(loop, axis=0, append=loop[:1]), axis=1).sum() for loop in ring.loops]
    assert grown == pytest.approx([1e-4 * sum(loops), 1e-4 * loops[0]], rel=0.01)


def test_large_errors_are_meshed_anew() -> None:
    large = made((ErrorSource.WELD, -0.05))
    assert large.at_rest
    assert large.volume < 0.5 * made().volume


@pytest.mark.parametrize(
    ("deviation", "sentence"),
    [
        ({ErrorSource.PRESSURE: -1.5}, "leaves nothing of it"),
        ({ErrorSource.TEMPERATURE: -200.0}, "temperature"),
    ],
)
def test_what_leaves_nothing_is_told(deviation: dict[ErrorSource, float], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        made_balloon(nominal(), Sample("3", deviation), TOLERANCES)


def test_errors_too_fine_for_a_seam_are_refused() -> None:
    fine = read_tolerances({"cut": {"normal": "0.1mm", "along": "0.1mm"}})
    with pytest.raises(InputError, match="too fine"):
        made_balloon(nominal(), Sample("1", {}, {ErrorSource.CUT: 1}), fine)


def test_two_simulated_panels_are_refused() -> None:
    with pytest.raises(InputError, match="two equal panels"):
        nominal("disc", 100.0, two_panels=True)
