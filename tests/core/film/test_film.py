# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film library: complete, plausible, and clear about what is wrong."""

import json
import math
from pathlib import Path

import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import (
    FOLDER,
    custom_film,
    film,
    films,
    read_film,
    with_grain,
    with_weld,
)
from BalloonWorkbench.core.options.film import DEFAULT_FILM

#: Density of the bulk materials [kg/m3], from general tables: lower and upper end.
DENSITIES = {
    "mylar": (1370, 1410),
    "bopp-foil": (890, 950),
    "nylon-foil": (1000, 1100),
    "pe": (910, 940),
    "pvc": (1100, 1450),
    "tracing-paper": (1000, 1300),
    "kraft-paper": (480, 860),
    "tpu-nylon": (700, 1200),
}


def test_every_material_of_the_trade_is_there() -> None:
    assert set(films()) == set(DENSITIES)
    assert film(DEFAULT_FILM).name == DEFAULT_FILM


@pytest.mark.parametrize("name", DENSITIES)
def test_weight_and_thickness_belong_to_the_same_material(name: str) -> None:
    low, high = DENSITIES[name]
    assert low <= film(name).areal_density / film(name).thickness <= high


@pytest.mark.parametrize("name", DENSITIES)
def test_numbers_have_sources_and_a_note(name: str) -> None:
    found = film(name)
    assert found.title
    assert found.note
    assert len(found.sources) >= 2
    assert all(len(source) > 20 for source in found.sources)


def test_party_balloon_film_weighs_what_the_trade_says() -> None:
    assert 0.031 <= film("nylon-foil").areal_density <= 0.032


def test_who_chooses_pvc_is_warned_of_the_laser() -> None:
    assert "laser" in film("pvc").note


def test_film_that_does_not_stretch_hardly_does() -> None:
    """Strain of about p L / (E t) at 2 kPa and 300 mm: below 2 % for foils and papers."""
    for name in ("mylar", "bopp-foil", "nylon-foil", "tracing-paper", "kraft-paper", "tpu-nylon"):
        assert 2e3 * 0.3 / film(name).membrane_stiffness < 0.02


def test_stiffnesses() -> None:
    """E t and E t^3 / (12 (1 - nu^2)) with round numbers: 3 GPa, 0.3, 25 um."""
    own = custom_film(3e9, 0.3, 25e-6)
    assert own.membrane_stiffness == pytest.approx(75e3)
    assert own.flexural_rigidity == pytest.approx(4.2926e-6, rel=1e-4)


@pytest.mark.parametrize("name", ["Mylar", " MYLAR ", "mylar"])
def test_name_is_found_in_any_case(name: str) -> None:
    assert film(name).name == "mylar"


def test_unknown_name_lists_the_known_ones() -> None:
    with pytest.raises(InputError, match="steel") as caught:
        film("steel")
    assert all(name in str(caught.value) for name in DENSITIES)


def test_callers_cannot_change_the_library() -> None:
    films().clear()
    assert set(films()) == set(DENSITIES)


def test_custom_film_assumes_the_weight_of_a_polymer() -> None:
    assert custom_film(3e9, 0.3, 25e-6).areal_density == pytest.approx(0.03)
    assert custom_film(3e9, 0.3, 25e-6, 0.05).areal_density == pytest.approx(0.05)


@pytest.mark.parametrize(
    ("values", "word"),
    [
        ((9e4, 0.3, 25e-6), "Young"),
        ((2e12, 0.3, 25e-6), "Young"),
        ((-3e9, 0.3, 25e-6), "Young"),
        ((math.nan, 0.3, 25e-6), "Young"),
        ((math.inf, 0.3, 25e-6), "Young"),
        ((3e9, -0.1, 25e-6), "Poisson"),
        ((3e9, 0.5, 25e-6), "Poisson"),
        ((3e9, math.nan, 25e-6), "Poisson"),
        ((3e9, 0.3, 0.0), "thickness"),
        ((3e9, 0.3, 25.0), "thickness"),
        ((3e9, 0.3, math.nan), "thickness"),
        ((3e9, 0.3, 25e-6, 0.0), "areal density"),
        ((3e9, 0.3, 25e-6, math.nan), "areal density"),
    ],
)
def test_impossible_values_are_refused(values: tuple[float, ...], word: str) -> None:
    with pytest.raises(InputError, match=word):
        custom_film(*values)


@pytest.mark.parametrize("values", [(1e5, 0.0, 1e-6), (1e12, 0.499, 5e-3)])
def test_ends_of_the_ranges_are_allowed(values: tuple[float, float, float]) -> None:
    assert isinstance(custom_film(*values), Film)


def changed(folder: Path, **changes: object) -> Path:
    """A copy of a good film file with some values replaced; None removes one."""
    data = json.loads((FOLDER / "mylar.json").read_text(encoding="utf-8")) | changes
    path = folder / "mylar.json"
    path.write_text(json.dumps({key: value for key, value in data.items() if value is not None}))
    return path


@pytest.mark.parametrize(
    ("changes", "word"),
    [
        ({"thickness_m": None}, "thickness_m"),
        ({"sources": None}, "sources"),
        ({"thickness_m": "thick"}, "thick"),
        ({"thickness_m": 25}, "thickness"),
        ({"poisson_ratio": math.nan}, "NaN"),
        ({"young_modulus_Pa": 6e9}, "own range"),
        ({"young_modulus_range_Pa": 5}, "mylar.json"),
        ({"max_stress_Pa": -1}, "strength"),
        ({"look": {"kind": "wood", "colour": "#ffffff", "opacity": 1}}, "look"),
        ({"look": {"kind": "paper", "colour": "white", "opacity": 1}}, "colour"),
        ({"look": {"kind": "paper", "colour": "#ffffff", "opacity": 0}}, "opacity"),
        ({"weld_rigidity": {"value": 0.0, "source": "assumed"}}, "weld rigidity"),
        ({"weld_rigidity": {"value": 11, "source": "assumed"}}, "weld rigidity"),
        ({"weld_rigidity": {"value": 0.5, "source": " "}}, "source"),
        ({"weld_rigidity": {"value": 0.5}}, "source"),
        ({"weld_rigidity": 0.5}, "mylar.json"),
        ({"name": "foil"}, "foil"),
    ],
)
def test_broken_file_is_named(tmp_path: Path, changes: dict[str, object], word: str) -> None:
    with pytest.raises(InputError, match=word) as caught:
        read_film(changed(tmp_path, **changes))
    assert "mylar.json" in str(caught.value)


def test_file_that_is_not_json_is_named(tmp_path: Path) -> None:
    path = tmp_path / "mylar.json"
    path.write_text("E = 3 GPa")
    with pytest.raises(InputError, match=r"mylar\.json"):
        read_film(path)


@pytest.mark.parametrize(
    ("number", "low", "high"), [(0, 1e5, 1e12), (1, 0.0, 0.4999), (2, 1e-6, 5e-3), (3, 1e-4, 20.0)]
)
def test_ranges_end_where_they_say(number: int, low: float, high: float) -> None:
    """Young's modulus, Poisson's ratio, thickness, areal density: what no film has is refused."""
    usual = [3e9, 0.3, 25e-6, 0.03]
    for value, allowed in ((low, True), (high, True), (0.9 * low - 1e-9, False), (1.1 * high, False)):
        values = [*usual[:number], value, *usual[number + 1 :]]
        if allowed:
            made = custom_film(*values)
            assert values[number] in (
                made.young_modulus,
                made.poisson_ratio,
                made.thickness,
                made.areal_density,
            )
        else:
            with pytest.raises(InputError):
                custom_film(*values)


def test_film_that_gives_energy_is_refused() -> None:
    """Of an orthotropic film nu^2 < E_along / E_across (Jones, 2.4): 33.3 GPa for 3 GPa and 0.3."""
    own = custom_film(3e9, 0.3, 25e-6)
    assert with_grain(own, 32.9e9).young_modulus_across == 32.9e9
    for across in (33.4e9, 50e9):
        with pytest.raises(InputError, match="turn the grain"):
            with_grain(own, across)


def test_rigidity_of_welds_has_a_source(tmp_path: Path) -> None:
    """In each file of ours; an older file of the user's own without one has the usual number, assumed."""
    for path in FOLDER.glob("*.json"):
        said = json.loads(path.read_text(encoding="utf-8"))["weld_rigidity"]
        known = film(path.stem)
        assert (known.weld_rigidity, known.weld_rigidity_source) == (said["value"], said["source"])
    older = read_film(changed(tmp_path, weld_rigidity=None))
    assert (older.weld_rigidity, older.weld_rigidity_source) == (1.0, "assumed")
    measured = read_film(changed(tmp_path, weld_rigidity={"value": 0.4, "source": "A strip, bent"}))
    assert (measured.weld_rigidity, measured.weld_rigidity_source) == (0.4, "A strip, bent")


def test_rigidity_of_welds_may_be_given() -> None:
    """The film's own number keeps its source."""
    own = film("pe")
    assert with_weld(own, own.weld_rigidity) == own
    given = with_weld(own, 0.25)
    assert (given.weld_rigidity, given.weld_rigidity_source) == (0.25, "given by the user")
    for value in (0.0, -1.0, 10.1, math.nan):
        with pytest.raises(InputError, match="weld rigidity"):
            with_weld(own, value)
