# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever the engine raises: the window answers, the document is as it was, a sentence tells, and the same
thing works the next time. BALLOON_FAULTS sets how many faults are tried (`make fuzz`: 200).
"""

import faulthandler
import os
import shutil
import sys
import zipfile
from contextlib import suppress

import brush
import FreeCAD as App
import FreeCADGui as Gui
import hands
import injected
import numpy as np
import pytest

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create, kinds
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.nesting import nest
from BalloonWorkbench.gui.paint import window as paint_window

COUNT = int(os.environ.get("BALLOON_FAULTS", "12"))
#: The last one is what a data file that is of no use is said to have.
SAID = ("This is a fault of the program", "There is too little memory", "put in by a test")
_OFTEN = 4  # faults after which the same is done without one, in a long run
_FROZEN = 150  # s after which a window that does nothing more ends the run


class ToldError(Exception):
    """A fault was told while something else was waited for."""


class Listener:
    """Reads what the window says, as a user would: labels, lists, boxes, objects, report view."""

    def __init__(self):
        self.beats, self._read = 0, 0
        self.heard: set[str] = set()
        self._old: set[str] = set()
        self._report = Gui.getMainWindow().findChild(hands.QtWidgets.QTextEdit, "Report view")
        self._timer = hands.QtCore.QTimer()
        self._timer.timeout.connect(self._look)
        self._timer.start(25)

    def stop(self):
        self._timer.stop()

    def _look(self):
        self.beats += 1
        if self.beats % 4 == 0:
            self.read()

    def read(self):
        texts = [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]
        for rows in hands.visible(hands.QtWidgets.QListWidget):
            texts += [rows.item(row).text() for row in range(rows.count())]
        for doc in App.listDocuments().values():
            texts += [obj.Status for obj in doc.Objects if hasattr(obj, "Status")]
        texts += self._report.toPlainText()[self._read :].splitlines()
        self.heard |= {text for text in texts if any(said in text for said in SAID)} - self._old

    def forget(self):
        """What was said until now; a label may show it for a while."""
        hands.wait(0.05)
        self._old = set()
        self.heard.clear()
        self.read()
        self._old = set(self.heard)
        self.heard.clear()
        self._read = len(self._report.toPlainText())

    def settle(self, condition, seconds=60.0):
        """Wait until something is so; ToldError when a fault is told instead."""
        hands.wait_until(lambda: condition() or self.heard, seconds)
        if not condition():
            raise ToldError


class Run:
    """One document, and what is done in it."""

    made = 0

    def __init__(self, listener, folder, made_file):
        Run.made += 1
        self.listener, self.folder = listener, folder
        self.doc = App.openDocument(str(shutil.copy(made_file, folder / f"Test{Run.made}.FCStd")))
        self.doc.clearUndos()
        hands.wait(0.05)
        self.turn = 10 * Run.made

    @property
    def parts(self):
        return create.Parts(self.doc.Outline, self.doc.Balloon, self.doc.Pattern)

    def open(self, command, chosen="Balloon"):
        """The panel of a command."""
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.doc.getObject(chosen))
        Gui.runCommand(f"BalloonWorkbench_{command}")
        self.listener.settle(hands.panel_is_seen)

    def close(self, button="Ok"):
        hands.press(button)
        self.listener.settle(hands.panel_is_closed)

    def edit(self):
        """The panel of the balloon."""
        view = self.doc.Balloon.ViewObject
        view.Proxy.doubleClicked(view)
        self.listener.settle(hands.panel_is_seen)

    def state(self):
        """What must be there, and unchanged as long as it is marked as stale."""
        balloon, pattern = self.doc.Balloon, self.doc.Pattern
        mesh = balloon.Mesh
        return {
            "Balloon": (balloon.SolvedFor, mesh.CountPoints, mesh.Volume, balloon.SeamPoints, balloon.Report),
            "Pattern": (pattern.Shape.hashCode(), pattern.Roles, pattern.SeamLength.Value),
        }


def balloon_panel(run):
    run.edit()
    hands.type_into(hands.find("MeshSize"), ("11 mm", "12 mm")[run.turn % 2])
    run.close()
    assert status.is_ready(run.doc.Balloon)


def pattern_panel(run):
    run.edit()
    hands.find("Notches").setValue(3 + run.turn % 4)
    hands.type_into(hands.find("Allowance"), ("3 mm", "4 mm")[run.turn % 2])
    run.close()
    assert status.is_ready(run.doc.Pattern)


def recompute(run):
    run.doc.Balloon.SealWidth = (5.0, 6.0)[run.turn % 2]
    run.doc.recompute()
    if run.listener.read() or run.listener.heard:
        raise ToldError
    assert status.is_ready(run.doc.Pattern)


def picture(run):
    balloons = len(run.doc.findObjects("Mesh::FeaturePython"))
    Gui.runCommand("BalloonWorkbench_FromPicture")
    run.listener.settle(hands.panel_is_seen)
    hands.click(hands.find("Live"), x=8)
    hands.type_into(hands.find("Drawing"), str(run.folder / f"shape{run.turn % 2}.png"))
    hands.type_into(hands.find("Width"), "12 cm")
    hands.choose(hands.find("Mode"), "Inflate as drawn")
    hands.type_into(hands.find("MeshSize"), "16 mm")
    run.close()
    assert len(run.doc.findObjects("Mesh::FeaturePython")) == balloons + 1


def export(run):
    path = run.folder / f"cut {run.turn}.dxf"
    run.open("ExportPattern")
    hands.type_into(hands.find("File"), str(path), confirm=False)
    run.close()
    assert path.is_file()


def prints(run):
    run.open("Artwork")
    hands.type_into(hands.find("Picture"), str(run.folder / f"shape{run.turn % 2}.png"), confirm=False)
    hands.find("Picture").editingFinished.emit()
    run.listener.settle(hands.find("WriteArtwork").isEnabled)
    run.close()
    assert status.is_ready(artwork.of_balloon(run.doc.Balloon))


def nesting(run):
    run.open("Nest")
    hands.find("Spacing").setProperty("rawValue", 3.0 + 0.1 * run.turn)
    hands.find("Balloons").setValue(2 + run.turn % 3)
    hands.find("FilmWidth").setProperty("rawValue", 250.0)
    hands.click(hands.find("LayOut"))
    run.listener.settle(lambda: "used" in hands.find("NestResult").text())
    run.close()
    assert all(status.is_ready(obj) for obj in run.doc.Objects if kinds.is_film_sheet(obj))


def assembly(run):
    path = run.folder / f"page {run.turn}.pdf"
    run.doc.Balloon.Altitude = run.turn  # the numbers are counted anew
    run.doc.recompute()
    run.open("AssemblySheet")
    hands.type_into(hands.find("AssemblyFile"), str(path), confirm=False)
    run.close()
    assert path.is_file()


def advice(run):
    run.doc.Pattern.IntakeWidth = 10.0 + 0.1 * run.turn
    run.doc.recompute()
    run.open("Advice")
    hands.click(hands.find("ThicknessMap"), x=8)
    hands.wait(0.05)
    run.close("Close")


def colours(run):
    run.open("ColourMap")
    hands.find("ColourMap").setCurrentIndex(1 + run.turn % 6)
    hands.find("CompareOutlines").setChecked(run.turn % 2 == 0)
    hands.wait(0.2)
    run.close()


def animation(run):
    run.open("Animate")
    run.listener.settle(hands.find("Play").isVisible)
    run.close("Close")


def painting(run):
    window = brush.open_window()
    window.live.settings = Settings(correct=False, mesh_size=0.02)
    y = 0.5 + 0.02 * (run.turn % 3)
    brush.draw(window.canvas, brush.ellipse(0.44, y, 0.30, 0.19))
    run.listener.settle(lambda: window.live.latest is not None and not window.live._dirty)
    if window.card.isVisible():
        brush.press("PaintSizeDone")
    brush.press("PaintMake")
    run.listener.settle(brush.is_closed)
    hands.wait_until(hands.panel_is_seen)
    hands.leave()


DONE = (
    *(painting, balloon_panel, picture, pattern_panel, export, prints),
    *(nesting, assembly, advice, recompute, colours, animation),
)
#: A function that each of them needs, to begin with.
FIRST = {
    painting: "core.design.draft.draft",
    balloon_panel: "core.job.design_outline",
    picture: "core.tracing.segment.segment",
    pattern_panel: "core.pattern.make.make_pattern",
    export: "core.machines.machine_file.drawing_file",
    prints: "core.machines.marks.place.marked",
    nesting: "core.nesting.nest.nest",
    assembly: "core.assembly_sheet.page.assembly_pdf",
    advice: "core.advice.advise.advise",
    recompute: "core.reports.report.build",
    colours: "core.results.film_state.film_state",
    animation: "core.solver.dynamics.animation.inflate_in_time",
}


@pytest.fixture(autouse=True)
def no_fault():
    """Here they are made."""


@pytest.fixture
def listener():
    ear = Listener()
    yield ear
    ear.stop()
    brush.close_window()
    close_box()


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """Two pictures to begin with."""
    place = tmp_path_factory.mktemp("faults")
    for number in range(2):
        y, x = np.mgrid[0:60, 0:80]
        inside = ((x - 40) / 30) ** 2 + ((y - 30) / (20 - 4 * number)) ** 2 < 1
        pixels = np.where(inside[..., None], (20, 60, 220, 255), (255, 255, 255, 255)).astype(np.uint8)
        (place / f"shape{number}.png").write_bytes(png_bytes(pixels, 100.0))
    return place


def box():
    return next((one for one in hands.visible(hands.QtWidgets.QMessageBox) if one.objectName()), None)


def close_box():
    if box() is not None:
        box().close()
        hands.wait(0.05)


def leave_all(run):
    """As a user would after a fault: let "Make it!" come to its end, close what is open."""
    hands.wait_until(lambda: not any(window.making for window in paint_window._open), 60)
    hands.wait(0.05)
    close_box()
    # an OK whose fault is told may still be on its way to close its panel
    hands.wait_until(lambda: hands.panel_is_closed() or hands.panel_is_seen())
    if hands.panel_is_open():
        with suppress(RuntimeError):  # it closes under the hand, and its button is gone
            hands.close_panel()
        hands.wait_until(hands.panel_is_closed, 20)


def try_one(do, run, engine, place, nth, error):
    """Do it with a fault at a place, and look at what is left."""
    ear = run.listener
    before, names = run.state(), {obj.Name for obj in run.doc.Objects}
    ear.forget()
    run.turn += 1
    engine.arm(place, nth, error)
    through = False
    try:
        do(run)
        through = True
    except ToldError:
        pass
    except AssertionError:
        ear.read()
        if not ear.heard:
            raise
    beats = ear.beats
    hands.wait_until(lambda: ear.beats > beats + 2, 20)
    ear.read()
    engine.disarm()
    # the engine itself takes a RuntimeError of a singular matrix for what it is
    assert ear.heard or not engine.fired or (through and error is RuntimeError), "nobody told"
    leave_all(run)
    assert not run.doc.HasPendingTransaction, "an undo step was left open"
    missing = names - {obj.Name for obj in run.doc.Objects}
    assert not missing, f"gone: {missing}"
    after = run.state()
    if after["Balloon"][0] == before["Balloon"][0]:
        assert after["Balloon"] == before["Balloon"], "the balloon has changed"
    if not status.is_ready(run.doc.Pattern):
        assert after["Pattern"] == before["Pattern"], "the pattern has changed"
    run.doc.saveAs(str(run.folder / "saved.FCStd"))
    with zipfile.ZipFile(run.folder / "saved.FCStd") as kept:
        assert kept.testzip() is None
    for obj in run.doc.Objects:
        obj.touch()
    run.doc.recompute()
    assert [obj.Status for obj in run.parts] == [status.READY] * 3


def do_once_more(do, run, engine):
    """The same without a fault; what it asks of the engine is counted."""
    run.listener.forget()
    run.turn += 1
    engine.calls.clear()
    do(run)
    run.listener.read()
    assert not run.listener.heard, f"still told: {run.listener.heard}"
    leave_all(run)


@pytest.mark.slow
@pytest.mark.parametrize("do", DONE[: max(COUNT, 1)], ids=lambda do: do.__name__)
def test_no_fault_of_the_engine_ends_the_window(do, listener, folder, rectangle_file, monkeypatch):
    # the search for the closest layout takes its time; what it raises is tested in test_nesting.py
    monkeypatch.setattr(nest, "PACKAGE", "no_such_package")
    number = DONE.index(do)
    count = len(range(number, COUNT, len(DONE)))
    places, wrong, run = [(FIRST[do], 1, injected.ERRORS[number % 3])], [], None
    with injected.Engine() as engine:
        for tried in range(count):
            if tried == 1:
                places += injected.chosen(engine.calls, count - 1, number)
            place, nth, error = places[tried]
            what = f"{place}, call {nth}, {error.__name__}"
            sys.__stdout__.write(f"{do.__name__}: {what}\n")
            faulthandler.dump_traceback_later(hands.patience(_FROZEN), exit=True, file=sys.__stderr__)
            run = run or Run(listener, folder, rectangle_file)
            try:
                try_one(do, run, engine, place, nth, error)
                assert engine.fired or tried, f"{place} was not asked"
                if count > 1 and tried % _OFTEN == 0:
                    do_once_more(do, run, engine)
            except (AssertionError, ToldError) as failed:
                wrong.append(f"{what}: {str(failed)[:300] or type(failed).__name__} {listener.heard or ''}")
                sys.__stdout__.write(f"WRONG {wrong[-1]}\n")
                engine.disarm()
                with suppress(AssertionError):
                    leave_all(run)
            if wrong or do in (painting, picture):  # each makes another balloon
                brush.close_window()
                App.closeDocument(run.doc.Name)
                run = None
            faulthandler.cancel_dump_traceback_later()
    assert not wrong, "\n".join(wrong)
