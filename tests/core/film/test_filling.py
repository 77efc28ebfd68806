# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gases and air against published densities, the atmosphere against the tables of ISO 2533."""

from __future__ import annotations

import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import AIR, GAS_CONSTANT, Filling, air_pressure, gas, gases


@pytest.mark.parametrize(
    ("altitude", "pressure"),
    [(0.0, 101325.0), (1000.0, 89874.6), (2000.0, 79495.2), (5000.0, 54019.9), (11000.0, 22632.1)],
)
def test_pressure_of_the_standard_atmosphere(altitude: float, pressure: float) -> None:
    """Tables of ISO 2533 / US Standard Atmosphere 1976, geopotential altitude."""
    assert air_pressure(altitude) == pytest.approx(pressure, rel=2e-5)


@pytest.mark.parametrize(
    ("name", "celsius", "density"),
    [
        ("helium", 0.0, 0.1785),
        ("helium", 20.0, 0.1664),
        ("hydrogen", 0.0, 0.0899),
        ("warm-air", 100.0, 0.9460),
    ],
)
def test_density_of_gases_at_one_atmosphere(name: str, celsius: float, density: float) -> None:
    """Handbook values [kg/m3] at 101325 Pa; air at 20 degrees has 1.2041."""
    filling = Filling(gas(name), 273.15 + celsius)
    assert 1.2041 - filling.lightness() == pytest.approx(density, abs=2e-3 * 1.2)


def test_a_cubic_metre_of_helium_lifts_a_kilogram() -> None:
    """The rule of thumb of balloonists: 1.02 to 1.05 kg."""
    assert 1.02 < Filling().lightness() < 1.05
    assert Filling(gas("hydrogen")).lightness() > Filling().lightness()


def test_air_as_warm_as_the_air_around_lifts_nothing() -> None:
    assert Filling(gas("warm-air"), 293.15).lightness() == pytest.approx(0.0, abs=1e-12)
    assert Filling(gas("warm-air"), 280.0).lightness() < 0.0
    assert Filling(gas("warm-air")).lightness() > 0.15


def test_overpressure_makes_the_gas_denser() -> None:
    """Boyle: 2 kPa add 2/101.325 to the density of helium, 0.1664 kg/m3."""
    assert Filling().lightness() - Filling().lightness(2000.0) == pytest.approx(
        0.1664 * 2.0 / 101.325, rel=1e-3
    )


def test_high_up_everything_lifts_less_in_proportion_to_the_pressure() -> None:
    low, high = Filling(), Filling(altitude=1600.0)
    assert high.lightness() / low.lightness() == pytest.approx(air_pressure(1600.0) / 101325.0)


def test_air_of_the_standard_atmosphere_has_its_density() -> None:
    """1.2250 kg/m3 at sea level and 15 degrees."""
    assert air_pressure(0.0) * AIR / (GAS_CONSTANT * 288.15) == pytest.approx(1.2250, abs=1e-4)


def test_every_gas_has_a_source() -> None:
    assert set(gases()) == {"helium", "hydrogen", "warm-air"}
    assert all(each.sources and each.title for each in gases().values())


@pytest.mark.parametrize(
    "filling",
    [
        Filling(altitude=20e3),
        Filling(altitude=-5e3),
        Filling(air_temperature=20.0),
        Filling(gas_temperature=2e3),
    ],
)
def test_what_is_out_of_range_is_refused(filling: Filling) -> None:
    with pytest.raises(InputError, match="out of range"):
        filling.lightness()


def test_an_unknown_gas_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match="helium, hydrogen, warm-air"):
        gas("neon")


def test_atmosphere_ends_where_its_formula_does() -> None:
    """From the deepest mine to the tropopause, ISO 2533."""
    assert air_pressure(-1000.0) == pytest.approx(113929.0, rel=1e-4)
    for altitude in (-1001.0, 11001.0, 1e9, float("nan")):
        with pytest.raises(InputError, match="out of range"):
            air_pressure(altitude)
