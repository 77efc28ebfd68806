# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of the user's own: what a form changes of a file, and how files are named, kept and deleted."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.machines.machine import Machine, machine, machine_of, machines, own_machines
from BalloonWorkbench.core.machines.own import keep
from BalloonWorkbench.core.machines.own.entries import ENTRIES, entry_value, with_entry
from BalloonWorkbench.core.machines.own.keep import (
    copied,
    delete_machine,
    free_title,
    keep_machines,
    machine_data,
    own_name,
)
from BalloonWorkbench.core.units import from_mm, parse_temperature

ENTRY = {entry.key: entry for entry in ENTRIES}


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's folder of machines, which is not there yet."""
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))
    return tmp_path / "machines"


def typed(data: dict, **texts: object) -> dict:
    for key, text in texts.items():
        data = with_entry(data, ENTRY[key], text)
    return data


def test_a_copy_that_is_filled_in_is_a_machine(folder: Path) -> None:
    data = copied(machine_data("gcode-marlin"), "Tip for PE")
    data = typed(data, feed_mm_min="300", temperature_C="180 °C", depth_mm="0,2", bed_mm=(0.6, math.inf))
    assert keep_machines([("", data)]) == (folder / "tip-for-pe.json",)
    own = machine("Tip for PE")
    assert own.tool is not None
    assert own.tool.feed == pytest.approx(from_mm(5.0))
    assert own.tool.temperature == pytest.approx(parse_temperature("180C"))
    assert own.tool.depth == pytest.approx(from_mm(0.2))
    assert own.bed == (0.6, math.inf)
    assert machine("tip-for-pe") == own == machines()["tip-for-pe"]


@pytest.mark.parametrize("name", machines())
def test_what_a_form_shows_it_takes_again(name: str) -> None:
    """Each value of each machine, but its bed, which the window writes in the user's unit."""
    data = machine_data(name)
    before = machine_of(data)
    for entry in ENTRIES:
        if entry.applies(data) and entry.key != "bed_mm":
            data = with_entry(data, entry, entry_value(entry, data))
    assert machine_of(data) == before


@pytest.mark.parametrize("name", machines())
@pytest.mark.parametrize("wish", ENTRY["format"].titles)
def test_each_machine_in_each_format_is_a_machine(name: str, wish: str) -> None:
    made = machine_of(with_entry(machine_data(name), ENTRY["format"], wish))
    assert f"{made.format} {made.version}".strip() == wish
    assert set(made.layers) & set(machine(name).layers) or made.tool is not None
    assert made.tool is None or set(made.layers) == set(made.tool.roles)


@pytest.mark.parametrize("kind", ENTRY["kind"].titles)
def test_another_tool_goes_along_its_own_lines_with_values_of_its_own(kind: str) -> None:
    data = typed(machine_data("gcode-grbl"), feed_mm_min="900", lift_mm="7", kind=kind)
    made = machine_of(data)
    assert made.tool is not None
    assert set(made.layers) == set(made.tool.roles)
    assert made.tool.lift == pytest.approx(from_mm(7.0))
    assert (made.tool.feed is None) == (kind != "laser"), "it has been a laser"


@pytest.mark.parametrize(
    ("name", "key", "text", "sentence"),
    [
        ("gcode-grbl", "feed_mm_min", "0", "feed of a laser must be from 1 mm/min"),
        ("gcode-grbl", "feed_mm_min", "fast", "Feed: 'fast' is no number"),
        ("gcode-grbl", "power_percent", "nan", "no number"),
        ("gcode-grbl", "power_percent", "130 %", "power of a laser must be"),
        ("gcode-marlin", "temperature_C", "420", "temperature of a hot tip must be from 40C to 400C"),
        ("gcode-marlin", "temperature_C", "900 F", "temperature of a hot tip must be from 40C to 400C"),
        ("gcode-marlin", "temperature_C", "hot", "not a temperature"),
        ("gcode-marlin", "depth_mm", "-9", "above the film"),
        ("gcode-marlin", "depth_mm", "deep", "not a length"),
        ("silhouette", "kerf_mm", "30", "Kerf: 30 mm is out of range, give 0 to 20 mm"),
        ("silhouette", "kerf_mm", "-1 in", "out of range"),
    ],
)
def test_values_that_make_no_sense(name: str, key: str, text: str, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        with_entry(machine_data(name), ENTRY[key], text)


def test_a_turning_axis_takes_the_place_of_a_swivel() -> None:
    """Its offset goes, and the axis goes where the controller has none."""
    data = machine_data("gcode-linuxcnc")
    data = with_entry(data, ENTRY["knife_offset_mm"], "0.25")
    turned = with_entry(data, ENTRY["turning_axis"], "C")
    assert machine_of(turned).tool.turning_axis == "C"  # type: ignore[union-attr]
    assert machine_of(turned).knife_offset == 0.0
    assert not ENTRY["knife_offset_mm"].applies(turned)
    on_grbl = with_entry(turned, ENTRY["format"], "gcode grbl")
    assert machine_of(on_grbl).tool.turning_axis == ""  # type: ignore[union-attr]
    assert not ENTRY["turning_axis"].applies(on_grbl)
    assert machine_of(with_entry(turned, ENTRY["kind"], "laser")).tool.turning_axis == ""  # type: ignore[union-attr]


def test_what_is_left_empty_is_not_known_or_as_usual() -> None:
    data = typed(machine_data("gcode-linuxcnc"), knife_offset_mm="0.3", feed_mm_min="600", overcut_mm="2")
    data = typed(data, feed_mm_min="", overcut_mm=" ", kerf_mm="", lift_mm="")
    made = machine_of(data)
    assert made.tool is not None
    assert (made.tool.feed, made.kerf, made.tool.lift) == (None, 0.0, from_mm(5.0))
    assert made.overcut == pytest.approx(from_mm(1.8)), "six times the knife's offset"


@pytest.mark.parametrize(
    "title", ["", " ", "a/b", "..", "../x", "a\\b", "con", "Aux", "x" * 41, "a.json", "a:b"]
)
def test_names_that_are_none(title: str) -> None:
    with pytest.raises(InputError, match="cannot be the name of a machine"):
        own_name(title)


@pytest.mark.parametrize("title", ["My laser 5 W", "Größe-2", "溶着機", "x" * 40])
def test_names_in_any_script(title: str) -> None:
    keep_machines([("", copied(machine_data("lightburn"), title))])
    assert machine(title).title == title


def test_a_name_that_is_taken_leaves_all_as_it_was(folder: Path) -> None:
    first = copied(machine_data("lightburn"), "First")
    keep_machines([("", first)])
    second = copied(machine_data("silhouette"), "Second")
    for title in ("First", "FIRST", "lightburn", "Second"):
        with pytest.raises(InputError, match="There is a machine"):
            keep_machines([("", second), ("", copied(second, title))])
    (folder / "broken.json").write_text("{")
    with pytest.raises(InputError, match="There is a machine"):
        keep_machines([("", copied(second, "broken"))])
    assert sorted(path.name for path in folder.iterdir()) == ["broken.json", "first.json"]


def test_another_name_takes_the_file_along(folder: Path) -> None:
    data = copied(machine_data("lightburn"), "First")
    keep_machines([("", data)])
    keep_machines([("first", copied(data, "Better name"))])
    assert [path.name for path in folder.iterdir()] == ["better-name.json"]
    delete_machine("better-name")
    delete_machine("better-name")
    assert not own_machines()


def test_what_cannot_be_written_is_told(folder: Path) -> None:
    folder.write_text("no folder")
    with pytest.raises(ExportError, match="Cannot write"):
        keep_machines([("", copied(machine_data("lightburn"), "First"))])


def test_a_draft_that_was_spoiled_names_itself() -> None:
    data = copied(machine_data("lightburn"), "First")
    for change in ({"layers": {}}, {"layers": 3}, {"unit": "ell"}, {"wings": 2}):
        with pytest.raises(InputError, match="First: "):
            keep.machine_bytes(data | change)
    del data["arcs"]
    with pytest.raises(InputError, match="First: its file lacks 'arcs'"):
        keep.machine_bytes(data)


def test_titles_of_copies_are_free_and_can_be_kept(folder: Path) -> None:
    assert free_title("My GRBL machine (G-code)") == "My GRBL machine"
    assert free_title("My GRBL machine", {"my-grbl-machine"}) == "My GRBL machine 2"
    assert free_title("(!)") == "Machine"
    folder.mkdir()
    (folder / "my-x.json").write_text("broken")
    assert free_title("My x") == "My x 2"
    for known in machines().values():
        own_name(free_title(f"My {known.title}"))


def test_a_roll_in_a_file_by_hand(folder: Path) -> None:
    folder.mkdir()
    data = copied(machine_data("hpgl-plotter"), "Roll") | {"bed_mm": [600, None]}
    (folder / "roll.json").write_text(json.dumps(data))
    assert machine("roll").bed == (0.6, math.inf)
    (folder / "roll.json").write_text(json.dumps(data | {"bed_mm": [5, None]}))
    (refused,) = own_machines().values()
    assert not isinstance(refused, Machine)
    assert "bed_mm is 5: give a number from 10" in str(refused)
