# SPDX-License-Identifier: LGPL-2.1-or-later
"""A workbench without the native library offers to fetch it, once, and does nothing without a yes."""

import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

sys.path.append(str(Path(__file__).resolve().parents[2] / "core"))

from wheel_server import server, wheel_list, wheel_of

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.native import library, load, native_wheel
from BalloonWorkbench.gui.window import native_offer

pytestmark = pytest.mark.works_out

QtWidgets = hands.QtWidgets
BUILT = load._FOLDER / library.file_name()


@pytest.fixture(autouse=True)
def clone(monkeypatch, tmp_path):
    """A workbench without a library, whose source knows the wheel; returns the folder of its libraries."""
    monkeypatch.setattr(load, "_FOLDER", tmp_path / "lib")
    monkeypatch.setattr(library, "FOLDER", tmp_path / "lib")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setattr(native_wheel, "WHEELS", tmp_path / "native-wheels.json")
    wheel_list(native_wheel.WHEELS, "http://127.0.0.1:9/releases", wheel_of(BUILT))
    native_wheel._look_again()
    yield tmp_path / "lib"
    assert native_offer._worker is None
    App.ParamGet(preferences.PATH).RemBool(native_offer.KEY)
    native_wheel._look_again()


def boxes():
    return [box for box in hands.visible(QtWidgets.QMessageBox) if box.objectName().startswith("Balloon")]


def offered():
    """The box of the offer, once it stands."""
    native_offer.offer()
    hands.wait_until(boxes)
    (box,) = boxes()
    assert box.objectName() == "BalloonOffer"
    assert not box.isModal()
    return box


def answer(box, text):
    hands.click(next(button for button in box.buttons() if button.text().replace("&", "") == text))
    hands.wait_until(lambda: not native_offer.is_asking())


def status():
    return Gui.getMainWindow().statusBar().currentMessage()


def test_says_before_what_it_would_do(clone):
    box = offered()
    hands.screenshot("native-offer")
    told = f"{box.text()} {box.informativeText()} {box.detailedText()}"
    wheel = native_wheel.wheel()
    for part in ("20 to 30 times longer", "MB from 127.0.0.1", wheel.address, wheel.sha256, str(clone)):
        assert part in told
    native_offer.offer()
    hands.wait(0.2)
    assert len(boxes()) == 1
    answer(box, "No, use NumPy")
    assert not clone.exists()


def test_a_no_is_kept(clone):
    answer(offered(), "No, use NumPy")
    assert "NumPy" in status()
    assert preferences.get(native_offer.KEY) is False
    native_offer.offer()
    hands.wait(0.3)
    assert not boxes()
    assert not clone.exists()


def test_closing_the_box_is_a_no(clone):
    offered().close()
    hands.wait_until(lambda: not native_offer.is_asking())
    assert preferences.get(native_offer.KEY) is False


def test_after_a_yes_the_next_balloon_is_native(clone, doc):
    assert backend.active_backend() == "numpy"
    with server(wheel_of(BUILT)) as address:
        wheel_list(native_wheel.WHEELS, address, wheel_of(BUILT))
        answer(offered(), "Fetch")
        hands.wait_until(lambda: native_offer._worker is None)
    assert status() == "The native solver is in use now."
    assert library.damage(next(clone.rglob(library.file_name()))) is None
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc), mesh_size=16, correct=False)
    assert parts.balloon.ActiveBackend == "native"
    native_offer.offer()
    hands.wait(0.2)
    assert not boxes()


def test_what_fails_is_one_sentence_and_can_be_tried_again(clone):
    answer(offered(), "Fetch")
    hands.wait_until(lambda: native_offer._worker is None)
    (box,) = boxes()
    assert "Connection refused" in box.text()
    box.close()
    assert not clone.exists()
    assert preferences.get(native_offer.KEY) is True
    answer(offered(), "No, use NumPy")


def test_it_can_be_stopped(clone):
    with server(wheel_of(BUILT), "stuck") as address:
        wheel_list(native_wheel.WHEELS, address, wheel_of(BUILT))
        answer(offered(), "Fetch")
        hands.wait_until(lambda: buttons("BalloonStop"))
        hands.click(buttons("BalloonStop")[0])
        hands.wait_until(lambda: native_offer._worker is None)
    assert "stopped" in status()
    assert not boxes()
    assert not clone.exists()


def buttons(name):
    return [each for each in hands.visible(QtWidgets.QPushButton) if each.objectName() == name]


def test_what_works_here_offers_it_after_a_no(clone):
    preferences.put(native_offer.KEY, False)
    Gui.runCommand("BalloonWorkbench_Equipment")
    hands.wait_until(hands.panel_is_seen)
    text = hands.find("Equipment").text()
    assert "has not been built" in text
    assert "20 to 30 times slower" in text
    hands.click(hands.find("FetchSolver"))
    hands.wait_until(boxes)
    answer(boxes()[0], "No, use NumPy")
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)


def test_a_platform_without_one_is_not_asked(clone, monkeypatch):
    monkeypatch.setattr(library, "platform_name", lambda: "linux-armv7l")
    monkeypatch.setattr(native_wheel, "platform_name", lambda: "linux-armv7l")
    native_offer.offer()
    hands.wait(0.3)
    assert not boxes()
    Gui.runCommand("BalloonWorkbench_Equipment")
    hands.wait_until(hands.panel_is_seen)
    assert "There is no native solver for linux-armv7l." in hands.find("Equipment").text()
    assert not buttons("FetchSolver")
    hands.press("Close")
    hands.wait_until(hands.panel_is_closed)
