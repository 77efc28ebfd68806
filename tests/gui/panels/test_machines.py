# SPDX-License-Identifier: LGPL-2.1-or-later
"""My machines: copied, named, filled in and deleted with mouse and keys; nonsense is told there."""

import json

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.machines.machine import machine, machines


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """The user's machines: none yet; and no preferences."""
    group = App.ParamGet(preferences.PATH)
    group.Clear()
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))
    yield tmp_path / "machines"
    group.Clear()


def open_panel():
    Gui.runCommand("BalloonWorkbench_Machines")
    hands.wait_until(hands.panel_is_seen, 5)


def keep():
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)


def copy_of(title):
    combo = hands.find("MachineChoice")
    combo.setCurrentIndex(combo.findText(title))
    combo.activated.emit(combo.currentIndex())
    hands.click(hands.find("CopyMachine"))


def field(key):
    return hands.find(f"Machine_{key}")


def fill(**texts):
    for key, text in texts.items():
        hands.type_into(field(key), text)


def test_a_copy_is_filled_in_and_is_offered_at_once(made, folder):
    open_panel()
    hands.screenshot("machines_ours")
    copy_of("Marlin printer (G-code)")
    assert field("title").text() == "My Marlin printer"
    assert not field("power_percent").isVisible()
    fill(title="Tip for PE", bed_mm="300 x 200 mm", feed_mm_min="300", temperature_C="356 F", depth_mm="0,2")
    assert field("temperature_C").text() == "180"
    hands.tick(hands.find("ExportBegins"))
    hands.screenshot("machines_own")
    keep()
    own = machine("tip-for-pe")
    assert (own.bed, own.tool.kind, own.tool.dwell) == ((0.3, 0.2), "hot-tip", 0.0)
    Gui.Selection.addSelection(made.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    assert hands.find("Machine").currentText() == "Tip for PE"
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    preferences.put("Machine", "any-dxf")
    path = made.pattern.Document.FileName
    made.pattern.Document.save()
    App.closeDocument(made.pattern.Document.Name)
    document = App.openDocument(path)
    assert preferences.machine(document) == "tip-for-pe", "the document knows for what it was exported"


def test_edited_again_from_the_export_panel_renamed_and_deleted(made, folder):
    open_panel()
    copy_of("GRBL machine (G-code)")
    keep()
    Gui.Selection.addSelection(made.pattern)
    Gui.runCommand("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    hands.click(hands.find("SetUpMachines"))
    hands.wait_until(lambda: hands.panel_is_seen() and hands.find("CopyMachine").isVisible())
    assert hands.find("MachineChoice").currentText() == "My GRBL machine"
    hands.choose(field("kind"), "Hot wheel")
    hands.wait(0.05)
    assert field("knife_offset_mm").isVisible()
    assert not field("power_percent").isVisible()
    hands.choose(field("format"), "SVG")
    hands.choose(field("unit"), "in")
    fill(title="Wheel")
    keep()
    assert [path.name for path in folder.iterdir()] == ["wheel.json"]
    own = machine("wheel")
    assert (own.format, own.unit, own.tool, own.process) == ("svg", "in", None, "heat-sealing")
    open_panel()
    hands.click(hands.find("DeleteMachine"))
    assert hands.find("DeleteSurely").isVisible()
    hands.screenshot("machines_delete")
    hands.click(hands.find("DeleteNot"))
    assert machine("wheel")
    hands.click(hands.find("DeleteMachine"))
    hands.click(hands.find("DeleteSurely"))
    assert not list(folder.iterdir())
    assert not hands.find("DeleteMachine").isEnabled(), "those of the workbench stay"
    hands.press("Cancel")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("key", "text", "sentence"),
    [
        ("feed_mm_min", "0", "The feed of a hot tip must be from 1 mm/min"),
        ("bed_mm", "1 mm", "A bed is 10 mm to"),
        ("temperature_C", "420", "must be from 40C to 400C"),
        ("title", "a/b", "cannot be the name of a machine"),
        ("title", "Silhouette", "There is a machine Silhouette already"),
        ("dwell_s", "long", "Dwell: 'long' is no number"),
    ],
)
def test_nonsense_is_told_in_the_panel_and_nothing_is_kept(folder, key, text, sentence):
    open_panel()
    copy_of("Marlin printer (G-code)")
    hands.type_into(field(key), text, confirm=False)
    hands.press("Ok")
    hands.wait(0.05)
    assert sentence in hands.message()
    assert hands.panel_is_open()
    assert field(key).text() == text
    hands.screenshot(f"machines_refused_{key}")
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)
    assert not folder.exists()


def test_a_file_by_hand_that_is_broken_is_shown_with_its_sentence(folder):
    folder.mkdir()
    (folder / "old.json").write_text(json.dumps({"name": "old"}))
    open_panel()
    combo = hands.find("MachineChoice")
    assert combo.currentText() == "old (unusable)"
    assert "The machine file old.json lacks" in hands.message()
    hands.screenshot("machines_broken")
    hands.click(hands.find("CopyMachine"))
    assert "lacks" in hands.message()
    hands.click(hands.find("DeleteMachine"))
    hands.click(hands.find("DeleteSurely"))
    assert combo.count() == len(machines())
    keep()
