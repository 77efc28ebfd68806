# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test cards: each field is worked with its own settings, and what is kept of one is a machine."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from gcode_reader import Controller

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.machine import FOLDER, machine, read_machine
from BalloonWorkbench.core.machines.own.keep import machine_bytes, machine_data
from BalloonWorkbench.core.machines.tool import read_tool, tool_data
from BalloonWorkbench.core.test_cards.card import CUT_OUT, SettingsCard, make_card
from BalloonWorkbench.core.test_cards.files import CARD_FILE, card_files
from BalloonWorkbench.core.test_cards.job import keep_field, write_card
from BalloonWorkbench.core.test_cards.keep import fields_of, kept_machine
from BalloonWorkbench.core.test_cards.tried import read_tried
from BalloonWorkbench.core.units import from_mm, parse_temperature

HOT = {"feed": [200.0, 300.0, 400.0], "tip_temperature": [parse_temperature(f"{c}C") for c in (140, 160)]}
HOT["depth"] = [from_mm(0.2)]
LASER = {"power": [20.0, 40.0, 60.0], "feed": [900.0]}


def files_of(name: str, tried: dict) -> tuple[SettingsCard, dict[str, bytes]]:
    card = make_card(machine(name), tried)
    return card, card_files(card, machine_data(name))


def test_a_tip_welds_each_field_at_its_temperature_and_feed() -> None:
    card, files = files_of("gcode-marlin", HOT)
    done = Controller("marlin", beam=False).read(files["test-card.gcode"])
    assert [code for code, _, _ in done.heats] == ["M104", "M109", "M104", "M109", "M104"]
    assert [(celsius, before) for code, celsius, before in done.heats if code == "M109"] == [
        (140, 0),
        (160, 3),
    ]
    assert done.heats[-1][1] == 0.0, "it is cold at the end"
    assert [stroke.feeds for stroke in done.strokes] == [[200.0], [300.0], [400.0]] * 2
    lengths = [np.linalg.norm(np.diff(stroke.line, axis=0), axis=1).sum() for stroke in done.strokes]
    assert lengths == pytest.approx([25.0] * 6), "strips of ASTM F88"
    width, height = card.size
    places = np.concatenate([stroke.line for stroke in done.strokes])
    assert (places > 0.0).all()
    assert (places < 1e3 * np.array([width, height])).all()
    gaps = {
        round(float(after.line[0][1] - before.line[0][1]))
        for before, after in zip(done.strokes, done.strokes[3:])
    }
    assert gaps == {50}, "as much free film on both sides as a hand holds"


def test_a_laser_cuts_pieces_of_known_size_with_each_power() -> None:
    _, files = files_of("gcode-grbl", LASER)
    done = Controller("grbl", beam=True).read(files["test-card.gcode"])
    assert [stroke.power for stroke in done.strokes] == [200.0, 400.0, 600.0]
    for stroke in done.strokes:
        assert np.ptp(stroke.line, axis=0) == pytest.approx([1e3 * CUT_OUT] * 2)
        assert stroke.line[0] == pytest.approx(stroke.line[-1])
    assert b"$32=1" in files["test-card.gcode"]


def test_what_is_kept_of_a_field_is_a_machine_with_its_settings(tmp_path: Path) -> None:
    card, files = files_of("gcode-marlin", HOT)
    (tmp_path / CARD_FILE).write_bytes(files[CARD_FILE])
    (tmp_path / "tip-pe.json").write_bytes(machine_bytes(kept_machine(tmp_path / CARD_FILE, "b2", "tip-pe")))
    own, ours = read_machine(tmp_path / "tip-pe.json"), read_machine(FOLDER / "gcode-marlin.json")
    assert own.tool == next(field.machine.tool for field in card.fields if field.name == "B2")
    assert (own.bed, own.overrun, own.layers.keys()) == (ours.bed, ours.overrun, ours.layers.keys())
    _, files = files_of("gcode-marlin", LASER | {"tool": ["laser"]})
    (tmp_path / CARD_FILE).write_bytes(files[CARD_FILE])
    (tmp_path / "laser-pe.json").write_bytes(
        machine_bytes(kept_machine(tmp_path / CARD_FILE, "A3", "laser-pe"))
    )
    laser = read_machine(tmp_path / "laser-pe.json")
    assert laser.tool is not None
    assert (laser.tool.kind, laser.tool.power) == ("laser", pytest.approx(0.6))
    assert all(role.is_cut for role in laser.layers)


@pytest.mark.parametrize("name", ["gcode-grbl", "gcode-marlin", "gcode-linuxcnc"])
def test_a_tool_is_written_as_it_is_read(name: str) -> None:
    tool = machine(name).tool
    assert tool is not None
    assert read_tool(tool_data(tool)) == tool


@pytest.mark.parametrize(
    ("name", "tried", "sentence"),
    [
        ("lightburn", LASER, "reads no G-code"),
        ("gcode-grbl", {"feed": [900.0], "power": [20.0]}, "one or two settings"),
        ("gcode-grbl", {}, "one or two settings"),
        ("gcode-grbl", LASER | {"feed": [1.0, 2.0], "depth": [0.0, 0.001]}, "one or two settings"),
        ("gcode-grbl", LASER | {"power": [20.0, 20.0]}, "each once"),
        ("gcode-grbl", LASER | {"power": [float(k) for k in range(1, 40)]}, "up to twelve"),
        ("gcode-grbl", LASER | {"power": [20.0, 200.0]}, "power of a laser must be from"),
        ("gcode-grbl", LASER | {"power": [20.0, float("nan")]}, "power of a laser must be from"),
        ("gcode-grbl", {"feed": [900.0, 600.0]}, "Nobody but you knows the power"),
        ("gcode-marlin", HOT | {"tip_temperature": [373.0, 383.0, 393.0, 403.0, 413.0]}, "220 mm x 220 mm"),
    ],
)  # fmt: skip
def test_cards_that_make_no_sense(name: str, tried: dict, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        make_card(machine(name), tried)


@pytest.mark.parametrize(
    "content", ["", "[]", "{}", '{"machine": {}, "layers": {}, "fields": 3}', "\x00", "NaN"]
)
def test_files_that_are_no_cards(content: str, tmp_path: Path) -> None:
    file = tmp_path / CARD_FILE
    file.write_text(content)
    with pytest.raises(InputError, match="no test card"):
        kept_machine(file, "A1", "mine")
    with pytest.raises(InputError, match="Cannot read"):
        kept_machine(tmp_path / "none.json", "A1", "mine")


@pytest.mark.parametrize(
    "change", [{"feed_mm_min": -5}, {"kind": "saw"}, {"feed_mm_min": "fast"}, {"wings": 2}]
)
def test_a_field_that_was_spoiled_is_no_machine(change: dict, tmp_path: Path) -> None:
    content = json.loads(files_of("gcode-grbl", LASER)[1][CARD_FILE])
    content["fields"]["A1"] |= change
    file = tmp_path / CARD_FILE
    file.write_text(json.dumps(content))
    with pytest.raises(InputError, match="The field A1 of this card makes no machine"):
        kept_machine(file, "A1", "mine")
    assert kept_machine(file, "A2", "mine")


def test_fields_and_names_that_there_are_not(tmp_path: Path) -> None:
    _, files = files_of("gcode-grbl", LASER)
    file = tmp_path / CARD_FILE
    file.write_bytes(files[CARD_FILE])
    with pytest.raises(InputError, match="A1, A2, A3"):
        kept_machine(file, "Z9", "mine")
    for name in ("", "../mine", "con", "mine.json"):
        with pytest.raises(InputError, match="name of a machine"):
            kept_machine(file, "A1", name)
    assert kept_machine(file, " a1 ", "mine")["tool"]["power_percent"] == 20.0


def test_settings_as_people_write_them() -> None:
    """Texts, numbers and lists give what the command line gives; units may be others."""
    written = {
        "feed": "200, 300,400",
        "tip_temperature": ["140C", "320 F"],
        "depth": "0.2",
        "power": "",
        "tool": "hot-tip",
    }
    tried = read_tried(written)
    assert tried == {
        "feed": [200.0, 300.0, 400.0],
        "tip_temperature": pytest.approx([parse_temperature("140C"), parse_temperature("160C")]),
        "depth": pytest.approx([from_mm(0.2)]),
        "tool": ["hot-tip"],
    }
    assert read_tried({"depth": 0.2, "feed": (200, 300)}) == read_tried({"depth": "0.2mm", "feed": "200,300"})


@pytest.mark.parametrize(
    ("written", "sentence"),
    [
        ({"speed": 3}, 'no "speed"'),
        ({"feed": "200, fast"}, "'fast' is no number"),
        ({"tool": "saw"}, 'the tool "saw" is none'),
        ({"depth": "deep"}, "not a length"),
        ({"tip_temperature": None}, "'None' is not a temperature"),
    ],
)
def test_settings_that_are_none(written: dict, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        read_tried(written)


def test_the_whole_way_from_settings_to_a_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))
    tried = read_tried({"feed": "200,300", "tip_temperature": "140,160", "depth": 0.2})
    _, paths = write_card("gcode-marlin", tried, tmp_path / "card", bed="90 x 130 mm")
    assert fields_of(paths[-1]) == {
        "A1": "200 mm/min, 140C, 0.2 mm",
        "A2": "300 mm/min, 140C, 0.2 mm",
        "B1": "200 mm/min, 160C, 0.2 mm",
        "B2": "300 mm/min, 160C, 0.2 mm",
    }
    assert keep_field(paths[-1], "B2", "Tip for PE").name == "tip-for-pe.json"
    assert machine("Tip for PE").title == "Tip for PE"
    with pytest.raises(InputError, match="There is a machine"):
        keep_field(paths[-1], "B1", "tip for pe")
    with pytest.raises(InputError, match="test card measures"):
        write_card("gcode-marlin", tried, tmp_path / "other", bed="20 x 20 mm")
    assert not (tmp_path / "other").exists()
