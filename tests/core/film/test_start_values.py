# SPDX-License-Identifier: LGPL-2.1-or-later
"""With what the first welds of a film are tried: each number has its source, and nothing harms."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.assembly_sheet.work_settings import WorkSettings, work_settings
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import FOLDER, film, films, read_film
from BalloonWorkbench.core.film.start_values import (
    StartValues,
    read_start_values,
    separating_layers,
    start_values_data,
)
from BalloonWorkbench.core.machines.layers import LaserSettings
from BalloonWorkbench.core.machines.machine import Machine, holding, machine
from BalloonWorkbench.core.machines.preflight import film_preflight
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.pattern.pattern import Role

BAR = {"value": [108, 118], "source": "Somebody: a table"}
LAYER = {"value": "baking paper", "source": "Somebody: a table"}


def with_values(folder: Path, values: Any, **change: Any) -> Path:
    """The file of a film of the user's own."""
    data = json.loads((FOLDER / "pe.json").read_text(encoding="utf-8"))
    path = folder / "pe.json"
    path.write_text(json.dumps(data | {"start_values": values} | change), encoding="utf-8")
    return path


def tipped(celsius: float | None, name: str = "gcode-marlin") -> Machine:
    """A machine with a hot tip of that temperature."""
    heat = None if celsius is None else celsius + 273.15
    return holding(machine(name), ToolOptions(tool="hot-tip", feed=300.0, tip_temperature=heat, depth=2e-4))


@pytest.mark.parametrize("known", films().values(), ids=lambda known: known.name)
def test_values_of_our_films_have_sources_and_harm_nothing(known: Film) -> None:
    values = known.start_values
    data = start_values_data(values)
    assert all(len(entry["source"]) > 10 and ":" in entry["source"] for entry in data.values())
    assert read_start_values(data) == values
    borne = separating_layers()
    assert borne == {"baking paper": pytest.approx(491.15), "PTFE": pytest.approx(533.15)}
    for given in (values.bar_temperature, values.tip_temperature):
        if given is not None:
            assert given.most <= borne[values.separating_layer] <= 533.15
    if known.joining != "heat":
        assert values == StartValues()
        assert not known.first_weld()
    elif values.is_known:
        assert known.first_weld().startswith("Start values")
    else:
        assert known.first_weld().startswith("Make a test card")


def test_a_film_tells_its_start_values() -> None:
    assert film("pe").first_weld() == (
        "Start values for welding: bar or iron 108C, pressed for 0.5 s–2 s; hot tip at 250C, moved"
        " at 150 mm/min–300 mm/min; through a layer of PTFE"
        " (Yuan et al.; Chenxi Packaging, 2019; leuys, 2d-inflatables)."
    )
    assert film("mylar").first_weld() == "Make a test card: nobody states a temperature for this film."
    assert film("tpu-nylon").first_weld().endswith("this film. Stated is: pressed for 8 s (diypackraft.com).")


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ([], "give the values with their sources"),
        ({"temperature": BAR}, 'nobody knows the start value "temperature"'),
        ({"bar_temperature_C": 120}, "who says so"),
        ({"bar_temperature_C": {"value": 120}}, "who says so"),
        ({"bar_temperature_C": {"value": 120, "source": " "}}, "lacks its source"),
        ({"bar_temperature_C": {**BAR, "value": [118, 108]}}, "the smaller one first"),
        ({"bar_temperature_C": {**BAR, "value": [1, 2, 3]}}, "give a number"),
        ({"bar_temperature_C": {**BAR, "value": True}}, "give a number"),
        ({"bar_temperature_C": {**BAR, "value": "hot"}}, "give a number"),
        ({"bar_temperature_C": {**BAR, "value": 500}}, "from 40 to 400"),
        ({"tip_temperature_C": {**BAR, "value": 261}}, "PTFE bears 260C"),
        ({"tip_temperature_C": {**BAR, "value": 219}, "separating_layer": LAYER}, "baking paper bears 218C"),
        ({"tip_speed_mm_min": {**BAR, "value": 0}}, "from 1 to 100000"),
        ({"dwell_s": {**BAR, "value": -1}}, "from 0.01 to 600"),
        ({"separating_layer": {**LAYER, "value": "cling film"}}, "none of baking paper, PTFE"),
        ({"separating_layer": {**LAYER, "value": ["PTFE"]}}, "none of baking paper, PTFE"),
    ],
)
def test_bad_values_are_named(tmp_path: Path, values: Any, told: str) -> None:
    with pytest.raises(InputError, match=told) as caught:
        read_film(with_values(tmp_path, values))
    assert str(caught.value).startswith("The film file pe.json is of no use: ")


def test_values_are_of_films_that_are_welded_by_heat(tmp_path: Path) -> None:
    with pytest.raises(InputError, match='give "joining": "heat" too'):
        read_film(with_values(tmp_path, {"bar_temperature_C": BAR}, joining="glue"))
    assert read_film(with_values(tmp_path, {})).start_values == StartValues()


@pytest.mark.parametrize(
    ("name", "celsius", "told"),
    [
        ("pe", 180.0, "hot tip is stated to weld .* at 250C, this tool has 180C"),
        ("pe", 250.0, ""),
        ("nylon-foil", 180.0, "bar is stated to weld .* at 108C–118C, this tool has 180C"),
        ("nylon-foil", 90.0, "this tool has 90C: peel a test card"),
        ("nylon-foil", 110.0, ""),
        ("mylar", 180.0, ""),
        ("pe", None, ""),
    ],
)
def test_check_says_when_a_tool_has_another_temperature(name: str, celsius: float | None, told: str) -> None:
    texts = [found.text for found in film_preflight(film(name), tipped(celsius, "gcode-grbl"))]
    assert len(texts) == bool(told)
    if told:
        assert re.search(told, texts[0]), texts


def test_settings_are_those_of_machines_that_know_them() -> None:
    """One that lacks something, or cuts only, tells nothing of welds."""
    laser = holding(machine("gcode-grbl"), ToolOptions(tool="laser", feed=900.0, power=35.0))
    found = work_settings([tipped(None), laser, tipped(180.0), machine("any-dxf")])
    assert found == WorkSettings(
        "Marlin printer (G-code)",
        "feed 300 mm/min, temperature 180C, depth 0.2 mm",
        laser.title,
        "feed 900 mm/min, power 35 %",
    )
    assert work_settings([machine(name) for name in ("gcode-grbl", "lightburn-project", "any-svg")]) == (
        WorkSettings()
    )


def test_settings_of_a_laser_are_told_from_its_project() -> None:
    plain = machine("lightburn-project")
    cut = replace(plain.layers[Role.CUT], laser=LaserSettings(0.02, 0.35))
    found = work_settings([replace(plain, layers={**plain.layers, Role.CUT: cut})])
    assert (found.cut_machine, found.cut) == (plain.title, "speed 1200 mm/min, power 35 %")
