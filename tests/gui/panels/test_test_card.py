# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test card: made and kept with mouse and keys, as one line of the macro each; nonsense is told there."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.gui.window import macro_recorder


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """The user's machines: none yet; and no preferences."""
    group = App.ParamGet(preferences.PATH)
    group.Clear()
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))
    yield tmp_path
    group.Clear()


def open_panel():
    Gui.runCommand("BalloonWorkbench_TestCard")
    hands.wait_until(hands.panel_is_seen, 5)


def choose(name, text):
    hands.choose(hands.find(name), text)


def fill(**texts):
    for name, text in texts.items():
        hands.type_into(hands.find(name), text, confirm=False)


def keep():
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed, 10)


def test_a_card_is_made_and_its_best_field_kept(folder, stand_in):
    lines = []
    stand_in.setattr(macro_recorder.Gui, "doCommand", lines.append)
    open_panel()
    choose("CardMachine", "Marlin printer (G-code)")
    assert not hands.find("Try_power").isVisible()
    fill(Try_feed="200, 300, 400", Try_tip_temperature="140C, 160", Try_depth="0.2")
    assert hands.find("CardSize").text() == "Fields: 6, on 104 x 115 mm of film"
    fill(CardFolder=str(folder / "card"))
    hands.screenshot("test_card")
    keep()
    assert {path.name for path in (folder / "card").iterdir()} == {
        "test-card.gcode",
        "test-card.svg",
        "test-card.json",
    }
    open_panel()
    hands.click(hands.find("Step1"))
    choose("CardField", "B2")
    assert hands.find("CardTries").text() == "300 mm/min, 160C, 0.2 mm"
    fill(CardName="Tip for PE")
    hands.screenshot("test_card_keep")
    keep()
    own = machine("tip-for-pe")
    calls = [line for line in lines if "BalloonWorkbench." in line]
    assert len(calls) == 2
    content = (folder / "card" / "test-card.gcode").read_bytes()
    for path in (*(folder / "card").iterdir(), folder / "machines" / "tip-for-pe.json"):
        path.unlink()
    exec("\n".join(lines), {"App": App})
    assert (folder / "card" / "test-card.gcode").read_bytes() == content
    assert machine("tip-for-pe") == own


def test_another_tool_on_a_machine(folder):
    open_panel()
    choose("CardMachine", "GRBL machine (G-code)")
    choose("CardTool", "Spindle")
    fill(Try_feed="300", Try_spindle_speed="8000; 12000", Try_depth="0.3", CardFolder=str(folder / "card"))
    keep()
    assert b"S12000" in (folder / "card" / "test-card.gcode").read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("texts", "sentence"),
    [
        ({}, "Nobody but you knows this: Feed, Temperature, Depth."),
        ({"feed": "0, 300", "tip_temperature": "140", "depth": "0.2"}, "feed of a hot tip must be from 1"),
        ({"feed": "300", "tip_temperature": "420, 440", "depth": "0"}, "must be from 40C to 400C"),
        ({"feed": "300", "tip_temperature": "140", "depth": "0.2"}, "tries one or two settings"),
        ({"feed": "200, 200", "tip_temperature": "140", "depth": "0.2"}, "each once"),
        ({"feed": "fast", "tip_temperature": "140", "depth": "0.2"}, "'fast' is no number"),
    ],
)
def test_nonsense_is_told_in_the_panel(folder, texts, sentence):
    open_panel()
    choose("CardMachine", "Marlin printer (G-code)")
    fill(**{f"Try_{name}": text for name, text in texts.items()}, CardFolder=str(folder / "card"))
    hands.press("Ok")
    hands.wait_until(lambda: sentence in hands.message(), 3, hands.message())
    assert not (folder / "card").exists()


def test_no_card_is_replaced_unasked_and_what_is_none_is_told(folder):
    (folder / "card").mkdir()
    (folder / "card" / "test-card.json").write_text("precious")
    open_panel()
    choose("CardMachine", "Marlin printer (G-code)")
    fill(Try_feed="200, 300", Try_tip_temperature="140", Try_depth="0.2", CardFolder=str(folder / "card"))
    hands.press("Ok")
    assert "is there already" in hands.message()
    hands.click(hands.find("Step1"))
    hands.type_into(hands.find("Card"), str(folder / "card" / "test-card.json"))
    assert "is no test card" in hands.message()
    hands.press("Ok")
    assert "is no test card" in hands.message()
    hands.screenshot("test_card_none")
    hands.click(hands.find("Step0"))
    hands.tick(hands.find("CardFolderReplace"))
    keep()
    open_panel()
    hands.click(hands.find("Step1"))
    fill(CardName="a/b")
    hands.press("Ok")
    assert "cannot be the name of a machine" in hands.message()
