# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 6: a spreadsheet of balloons is stopped and gone on with; a page that turns; the command line."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import sketches
import steps

from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.studies.runners.worker import python

ROWS = 40
FILMS = ("mylar", "pe")
HEART = Path("resources/examples/pictures/heart.png").resolve()


def test_scene_6_catalogue(user, story, tmp_path):
    doc = App.newDocument("Catalogue")
    parts = create.balloon_from_sketch(doc, sketches.rectangle(doc, 120, 80), mesh_size=5, correct=False)
    doc.clearUndos()
    Gui.SendMsgToActiveView("ViewFit")
    hands.wait(0.5)
    file = tmp_path / "catalogue.FCStd"
    _begun_and_stopped(user, story, doc, parts, tmp_path / "rows")
    _saved(user, file)
    App.closeDocument(doc.Name)
    doc = App.openDocument(str(file))
    hands.wait(1.0)
    story.step("next-day")
    _gone_on_with(user, story, doc)
    _page(user, story, doc.Balloon, tmp_path / "turns.html")
    _command_line(story, tmp_path)
    _questions(story, tmp_path)


def _begun_and_stopped(user, story, doc, parts, folder):
    steps.command(user, "Study", parts.balloon)
    doc.Study.Folder = str(folder)
    doc.Study.Jobs = 1
    story.step("study")
    user.choose(hands.find("StudyColumn"), "Pressure")
    for name, text in (("StudyFirst", "1 kPa"), ("StudyLast", "3 kPa")):
        user.replace(hands.find(name), text, confirm=False)
    user.replace(hands.find("StudySteps"), str(ROWS), confirm=False)
    user.button("StudyMakeRows")
    hands.wait_until(lambda: hands.find("StudyRows").rowCount() == ROWS, 20)
    story.step("rows")
    user.button("StudyStart")
    hands.wait_until(lambda: _done() >= 2, 120)
    story.step("rows-fill-up")
    user.button("StudyStart")
    hands.wait_until(lambda: hands.find("StudyStart").text() == "Work out", 60)
    story.step("stopped")
    story.expect(2 <= _done() < ROWS, f"{_done()} rows are there after Stop")
    steps.leave(user)
    story.expect(doc.Study.ViewObject.isVisible(), "the study is grey in the tree")
    story.expect("Touched" not in doc.Study.State + doc.StudyTable.State, "the study is to be recomputed")
    story.step("study-kept")


def _done():
    """How many rows are worked out, as the panel says."""
    return int(hands.find("StudyMessage").text().split()[0])


def _saved(user, file):
    with user.answering(file):
        user.key("Ctrl", "s")
        hands.wait_until(file.exists, 20)


def _gone_on_with(user, story, doc):
    user.open_in_tree(doc.Study)
    hands.wait_until(hands.panel_is_seen)
    before = _done()
    story.expect(before >= 2, "what was there before is not known any more")
    user.button("StudyStart")
    hands.wait_until(lambda: hands.find("StudyStart").text() == "Work out" and _done() == ROWS, 300)
    hands.wait(0.3)
    story.step("all-rows")
    over = hands.find("StudyAcross").currentText()
    story.expect(over == "Pressure", f"the plot is over {over}, which is the same in all rows")
    steps.leave(user)
    values = [doc.Study.Table.get(f"{letter}2") for letter in "AB"]
    story.expect(all(values), f"the spreadsheet has {values}")
    story.expect((doc.Study.Rows, doc.Study.Finished) == (ROWS, ROWS), "not all rows are counted")
    story.step("results-kept")


def _page(user, story, balloon, file):
    steps.command(user, "ExportForWeb", balloon)
    story.step("page")
    user.replace(hands.find("SharedFile"), str(file), confirm=False)
    steps.leave(user)
    text = file.read_text(encoding="utf-8")
    story.expect("<script" in text and "data:model/gltf-binary" in text, "the page has nothing that turns")
    story.expect(str(file) in steps.status_text(), "nothing tells where the page was written")
    story.step("page-written")


def _command_line(story, folder):
    """A table of drawings, widths and pressures, as a spreadsheet saves it; twice: nothing is made again."""
    table, out = folder / "catalogue.csv", folder / "catalogue"
    with table.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(("input", "command", "width", "pressure", "mesh-size"))
        rows.writerows((HEART, "inflate", "200mm", f"{kpa}kPa", "20mm") for kpa in (1, 2))
    _study(story, table, out)
    said = _study(story, table, out, "--dry-run")
    story.expect("2" in said, f"the command line says: {said}")
    with (out / "table.csv").open(encoding="utf-8") as file:
        made = list(csv.DictReader(file))
    story.expect(len(made) == 2 and all(float(row["volume_m3"]) > 0 for row in made), f"the table has {made}")
    story.expect((out / "study.html").exists(), "there is no page")


def _study(story, file, out, *more):
    """What the command line says of a study."""
    paths = os.pathsep.join([str(Path.cwd()), *filter(None, sys.path)])
    done = subprocess.run(
        [python(), "-m", "BalloonWorkbench", "study", str(file), "--out", str(out), *more],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": paths},
    )
    story.expect(done.returncode == 0, f"the command line says: {done.stdout}{done.stderr}")
    return done.stdout


def _questions(story, folder):
    """Which film carries 20 g at least cost, and what half a millimetre of cutting error does."""
    fixed = {"input": str(HEART), "command": "inflate", "mesh-size": "60mm", "pressure": "100Pa"}
    over = {"width": ["600mm", "1000mm"], "material": FILMS}
    goal = {"minimize": "film_cost", "over": over, "limits": {"lift": ">= 20 g"}}
    (folder / "cheapest.json").write_text(json.dumps({"fixed": fixed, "goal": goal}), encoding="utf-8")
    said = _study(story, folder / "cheapest.json", folder / "cheapest")
    story.expect("Best of" in said and "film_cost" in said, f"which is the cheapest is not said: {said}")
    best = json.loads((folder / "cheapest" / "goal.json").read_text(encoding="utf-8"))
    story.expect(best["reached"] and best["results"]["lift_g"] >= 20, f"the cheapest carries {best}")
    with (folder / "cheapest" / "table.csv").open(encoding="utf-8") as file:
        carry = [row for row in csv.DictReader(file) if float(row["lift_g"]) >= 20]
    costs = {film: min(float(row["film_cost"]) for row in carry if row["material"] == film) for film in FILMS}
    story.expect(best["values"]["material"] == min(costs, key=costs.get), f"by film it costs {costs}")
    cut = {"cut": {"uniform": "0.5mm", "per": "whole"}}
    errors = {"fixed": {**fixed, "width": "300mm", "mesh-size": "20mm"}, "tolerances": cut, "samples": 6}
    (folder / "errors.json").write_text(json.dumps(errors), encoding="utf-8")
    said = _study(story, folder / "errors.json", folder / "errors")
    story.expect("most by cut" in said, f"what the error does is not said: {said}")
    story.expect((folder / "errors" / "study.html").exists(), "there is no page with charts")
