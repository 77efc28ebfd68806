# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 5: a hot tip is tried out, welds as a job; prints with marks; a photograph corrects the film."""

import json

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np
import photographs
import pytest
import sketches
import steps
from drawn_pictures import png
from print_and_cut import disagreement, lines_of, marks_of, photographed
from story import view_box
from user import show

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.core.as_made.comparison import with_rim
from BalloonWorkbench.core.design.silhouette import silhouette

QtWidgets = hands.QtWidgets
PIXEL, SIZE = 0.0004, (480, 400)  # m; px of the photograph
AGREED = 0.1  # mm
STRETCHED = 1.02  # the balloon in the photograph


@pytest.fixture
def machines(tmp_path, monkeypatch):
    """The user's own machines: none yet."""
    monkeypatch.setenv("BALLOON_MACHINES", str(tmp_path / "machines"))


def test_scene_5_machine(user, story, machines, tmp_path):
    doc = App.newDocument("Tag")
    drawn = sketches.rectangle(doc, 90, 60)
    parts = create.balloon_from_sketch(doc, drawn, mesh_size=10)
    doc.clearUndos()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.5)
    _card_made(user, story, tmp_path / "card")
    _best_kept(user, story)
    _tool_paths(user, story, doc, parts.pattern)
    _marks(user, story, doc, parts, tmp_path)
    _photograph(user, story, parts, tmp_path)


def _card_made(user, story, folder):
    user.menu("BalloonWorkbench_TestCard")
    hands.wait_until(hands.panel_is_seen)
    user.choose(hands.find("CardMachine"), "Marlin")
    story.step("card")
    for name, text in (("feed", "200, 300, 400"), ("tip_temperature", "140, 160"), ("depth", "0.2")):
        user.replace(hands.find(f"Try_{name}"), text, confirm=False)
    user.replace(hands.find("CardFolder"), str(folder), confirm=False)
    story.step("card-filled-in")
    story.expect(hands.find("CardSize").text().startswith("Fields: 6,"), hands.find("CardSize").text())
    steps.leave(user)
    story.step("card-written")
    names = {path.name for path in folder.iterdir()}
    story.expect({"test-card.gcode", "test-card.json"} <= names, f"the card is {names}")
    story.expect(str(folder) in steps.status_text(), "nothing tells where the card was written")


def _best_kept(user, story):
    user.menu("BalloonWorkbench_TestCard")
    hands.wait_until(hands.panel_is_seen)
    user.button("Step1")
    story.step("which-held")
    user.choose(hands.find("CardField"), "B2")
    story.expect("300 mm/min" in hands.find("CardTries").text(), hands.find("CardTries").text())
    user.replace(hands.find("CardName"), "Tip for PE", confirm=False)
    story.step("best")
    steps.leave(user)
    story.step("best-kept")


def _tool_paths(user, story, doc, pattern):
    steps.command(user, "ExportPattern", pattern)
    user.choose(hands.find("Machine"), "Tip for PE")
    hands.wait(0.3)
    paths = hands.find("AsToolPaths")
    steps.tick(user, paths)
    story.step("tool-paths")
    before = len(doc.Objects)
    steps.leave(user)
    hands.wait(0.5)
    story.step("job")
    jobs = [obj for obj in doc.Objects[before:] if obj.Name.startswith("Job")]
    assert len(jobs) == 1, "there is no job"
    (welds,) = jobs[0].Operations.Group
    story.expect(_green() > 200, "the path cannot be seen in the 3D view")
    code = welds.Path.toGCode()
    story.expect("M104" in code or "M109" in code, "the tip is not heated")
    story.expect("G1" in code, "nothing is welded")
    _simulated(user, story, doc, jobs[0])
    jobs[0].ViewObject.Visibility = False  # what it shows is looked at in its own workbench


def _green():
    """How many pixels of the 3D view have the colour of feeds."""
    view = QtWidgets.QApplication.primaryScreen().grabWindow(0, *view_box().getRect())
    red, green, blue = pixels(view.toImage())[..., :3].astype(int).transpose(2, 0, 1)
    return ((green > red + 20) & (green > blue + 20)).sum()


def _simulated(user, story, doc, job):
    """FreeCAD's simulator plays the job to its end, and marks the film."""
    with user.answering("", "MessageBox", expected=False):  # a remark of 0.20 on units of speed
        Gui.activateWorkbench(_one_of(Gui.listWorkbenches(), "CAMWorkbench", "PathWorkbench"))
        hands.wait(1.0)
    user.select(job)
    Gui.runCommand(_one_of(Gui.listCommands(), "CAM_Simulator", "Path_Simulator"))
    hands.wait_until(hands.panel_is_seen)
    bar = Gui.getMainWindow().findChild(QtWidgets.QProgressBar, "progressBar")
    user.click(Gui.getMainWindow().findChild(QtWidgets.QToolButton, "toolButtonFF"))
    hands.wait_until(lambda: bar.value() == 100, 240)
    hands.wait(0.5)
    story.step("simulated", ours=False)
    story.expect(doc.CutMaterialIn.Mesh.CountFacets > 0, "the simulator leaves no mark on the film")
    user.panel("Cancel")
    hands.wait_until(hands.panel_is_closed)
    Gui.activateWorkbench("BalloonWorkbench")


def _one_of(known, *names):
    """By which of its names this FreeCAD knows it."""
    return next(name for name in names if name in known)


def _marks(user, story, doc, parts, folder):
    picture = folder / "check.png"
    board = np.indices((60, 90)).sum(axis=0) // 10 % 2 * 60 + 110  # clear of paper and of marks
    picture.write_bytes(png(np.dstack([board, board, board, np.full_like(board, 255)]).astype(np.uint8)))
    steps.command(user, "Artwork", parts.balloon)
    user.replace(hands.find("Picture"), str(picture), confirm=False)
    user.key("Tab")
    hands.wait_until(lambda: artwork.of_balloon(parts.balloon).Status == status.READY, 30)
    user.replace(hands.find("Bleed"), "0 mm")  # the border of the print is the cut
    user.choose(hands.find("MarksFor"), "Summa")
    hands.wait(0.5)
    story.step("registration-marks")
    story.expect(artwork.of_balloon(parts.balloon).MarksFor.startswith("summa"), "the marks are others")
    (folder / "print").mkdir()
    with user.answering(folder / "print"):
        user.button("WriteArtwork")
        hands.wait_until(lambda: "written" in hands.find("ArtworkMessage").text(), 60)
    story.step("artwork-written")
    written = {path.suffix for path in (folder / "print").iterdir()}
    story.expect({".pdf", ".png", ".dxf"} <= written, f"written are {written}")
    _lies_askew(story, folder / "print")
    steps.leave(user)


def _lies_askew(story, folder):
    """The print, turned, shifted and larger, as the machine sees it: the cut is right all the same."""
    cut = next(folder.glob("*front*summa*.dxf"))
    lines = lines_of(cut.read_bytes(), cut.name)
    picture = photographed(next(folder.glob("*.pdf")))
    off = disagreement(lines, marks_of(lines["Regmark"]), picture)
    story.expect(off < AGREED, f"on a print that lies askew the cut is off by {off} mm")


def _photograph(user, story, parts, folder):
    photo = folder / "photo.png"
    inflation, own = film_result.stored(parts.balloon)
    rim = own.seal_width + 1e-3 * parts.pattern.Allowance.Value
    loop = STRETCHED * with_rim(silhouette(inflation), rim).outer
    photo.write_bytes(png(photographs.photograph([loop], pixel=PIXEL, size=SIZE, turn=20.0, noise=3.0)))
    steps.command(user, "Compare", parts.balloon)
    story.step("photograph")
    user.replace(hands.find("Photo"), str(photo), confirm=False)
    user.button("MarkLength")
    view = hands.find("MarkedPicture")
    hands.wait_until(view.isVisible, 10)
    hands.wait(0.5)
    for x in (40.0, 440.0):
        user.click(view.viewport().mapToGlobal(view.mapFromScene(x, 200.0)))
    story.step("length-marked")
    user.click(hands.find("PictureDone"))
    user.click(hands.find("PhotoLength"))  # the screen of the tests has nobody who gives the keys back
    hands.wait(0.5)
    pixels = float(hands.find("PhotoPixels").text())
    story.expect(pixels == pytest.approx(400.0, abs=3.0), f"marked are {pixels} pixels of 400")
    user.replace(hands.find("PhotoLength"), "160 mm", confirm=False)
    steps.tick(user, hands.find("FitFilm"))
    user.button("Compare")
    hands.wait_until(lambda: "Difference" in hands.message(), 90)
    hands.wait(0.5)
    story.step("compared")
    show(hands.find("KeepFilm"))
    story.step("fitted")
    user.button("KeepFilm")
    hands.wait_until(lambda: any("as-made" in name for name in film.known_films()), 20)
    hands.wait(0.3)
    story.step("film-kept")
    name = next(name for name in film.known_films() if "as-made" in name)
    stretch = json.loads((film.own_folder() / f"{name}.json").read_text(encoding="utf-8"))["as_made"][
        "stretch"
    ]
    story.expect(stretch == pytest.approx(STRETCHED - 1, abs=0.01), f"the film stretches by {stretch}")
    steps.leave(user, "Close")
