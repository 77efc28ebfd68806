# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and pressures as people write them."""

import numpy as np
import pytest

from BalloonWorkbench.core import units
from BalloonWorkbench.core.errors import InputError


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("300mm", 0.3),
        ("30 cm", 0.3),
        ("12in", 0.3048),
        ('12"', 0.3048),
        ("1ft", 0.3048),
        ("0.3", 0.3),
        ("3e-1 m", 0.3),
        (" .3m ", 0.3),
        ("25um", 25e-6),
        ("25 µm", 25e-6),
        ("2 INCH", 0.0508),
        (0.25, 0.25),
        ("-5mm", -0.005),
        ("0", 0.0),
    ],
)
def test_lengths(text, metres):
    assert units.parse_length(text) == pytest.approx(metres, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "pascals"),
    [
        ("2kPa", 2000),
        ("20 mbar", 2000),
        ("1bar", 1e5),
        ("5 psi", 34473.786),
        ("1500", 1500),
        ("3 hPa", 300),
        ("100 mmH2O", 980.665),
        ("8 inH2O", 1992.7113),
        (2e3, 2e3),
    ],
)
def test_pressures(text, pascals):
    assert units.parse_pressure(text) == pytest.approx(pascals, rel=1e-7)


@pytest.mark.parametrize(
    ("pascals", "text"), [(2000.0, "204 mm (8 in)"), (99.0, "10 mm (0.3 in)"), (1.0, "0 mm (0 in)")]
)
def test_a_water_column_is_not_higher_than_the_pressure(pascals, text):
    """Of water at 20 degrees: 998.2 kg/m3."""
    assert units.water_column_text(pascals) == text


@pytest.mark.parametrize(
    "text",
    [
        "",
        "mm",
        "3 apples",
        "3 kPa",
        "nan",
        "inf",
        "1e999",
        "1,5 mm",
        "3 mm 4",
        "--3mm",
        "0x10",
        "3e",
        "3 m m",
    ],
)
def test_nonsense_lengths_are_refused_with_an_example(text):
    with pytest.raises(InputError, match="300mm"):
        units.parse_length(text)


@pytest.mark.parametrize("text", ["", "x", "500mm x", "x 500mm", "1x2x3"])
def test_nonsense_sizes_are_refused_with_an_example(text):
    with pytest.raises(InputError, match="500mmx700mm"):
        units.parse_size(text)


@pytest.mark.parametrize("text", ["", "kPa", "2 mm", "2 mPa", "2 MPa", "nan", "-"])
def test_nonsense_pressures_are_refused_with_an_example(text):
    with pytest.raises(InputError, match="2kPa"):
        units.parse_pressure(text)


def test_millimetres_and_back():
    assert units.to_mm(0.3) == pytest.approx(300)
    values = np.array([[0.001, 2.0]])
    assert np.allclose(units.from_mm(units.to_mm(values)), values)
    assert units.length_text(0.0123456) == "12.35 mm"
    assert units.length_text(1e5) == "100000 m"


@pytest.mark.parametrize(
    ("parse", "units_of", "size"),
    [
        # how many of each go into 24 m, 1 bar, a cubic metre, a kilogram, by the international definitions
        (
            units.parse_length,
            units.LENGTH_UNITS,
            {"um": 24e6, "µm": 24e6, "mm": 24e3, "cm": 2400, "dm": 240, "m": 24, "in": 24 / 0.0254,
             "inch": 24 / 0.0254, "inches": 24 / 0.0254, '"': 24 / 0.0254, "ft": 24 / 0.3048},
        ),
        (
            units.parse_pressure,
            units.PRESSURE_UNITS,
            {"pa": 1e5, "hpa": 1000, "kpa": 100, "mbar": 1000, "bar": 1, "psi": 14.503773773,
             "mmh2o": 10197.162130, "cmh2o": 1019.7162130, "inh2o": 401.46307597},
        ),
        (
            units.parse_volume,
            units.VOLUME_UNITS,
            {"l": 1000, "litre": 1000, "litres": 1000, "ml": 1e6, "cm3": 1e6, "dm3": 1000, "m3": 1,
             "ft3": 35.314666721},
        ),
        (
            units.parse_mass,
            units.MASS_UNITS,
            {"g": 1000, "gram": 1000, "grams": 1000, "kg": 1, "oz": 35.27396195, "n": 9.80665},
        ),
    ],
)  # fmt: skip
def test_every_unit_has_its_size(parse, units_of, size):
    whole = {units.parse_length: 24.0, units.parse_pressure: 1e5}.get(parse, 1.0)
    assert set(size) == set(units_of)
    for name, count in size.items():
        assert parse(f"{count!r} {name}") == pytest.approx(whole, rel=1e-9), name
