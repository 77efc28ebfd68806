# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scene 3: a maker has a picture printed, filled, laid out, cut and told how to make it; will it float?"""

import re
from pathlib import Path

import FreeCAD as App
import hands
import steps

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import kinds
from BalloonWorkbench.app.pattern import build
from BalloonWorkbench.core.units import to_mm

BEAR = Path("resources/examples/pictures/bear.png").resolve()


def test_scene_3_make(user, story, tmp_path):
    _balloon_of_picture(user, story)
    doc = App.ActiveDocument
    _film_and_valve(user, story, doc)
    _advice(user, story, doc.Balloon)
    _printed(user, story, doc.Balloon)
    _on_film(user, story, doc)
    _exported(user, story, doc.Pattern, tmp_path / "bear.dxf")
    _bed_too_small(user, story, doc.Pattern, tmp_path / "bear.svg")
    _assembly_sheet(user, story, doc.Balloon, tmp_path / "sheet.pdf")


def _balloon_of_picture(user, story):
    with user.answering(BEAR, expected=False) as chooser:
        user.command("BalloonWorkbench_FromPicture")
        hands.wait_until(hands.panel_is_seen)
        hands.wait(1.0)
    story.expect(chooser, "no chooser of files opens")
    story.step("picture")
    steps.inflated()
    story.step("inflated")
    user.replace(hands.find("Width"), "260 mm")
    hands.wait(0.3)
    story.step("wider-being-worked-out")
    steps.inflated()
    story.step("wider")


def _film_and_valve(user, story, doc):
    film = hands.find("Film")
    hands.show_tab(film)
    user.choose(film, "nylon/PE")
    steps.inflated()
    story.step("film")
    user.button("Step2")
    user.replace(hands.find("SealWidth"), "6 mm")
    steps.inflated()
    user.choose(hands.find("IntakeKind"), "film valve")
    steps.inflated()
    story.step("valve")
    user.button("DragIntake")
    steps.to_view(user)
    steps.look_at_all(user)
    before = doc.Pattern.IntakeAlong.Value
    user.drag([steps.in_view(place) for place in _along_the_rim(doc.Pattern)])
    hands.wait_until(lambda: not doc.Pattern.IntakeAuto, 20)
    hands.wait(0.5)
    story.step("valve-dragged")
    story.expect(doc.Pattern.IntakeAlong.Value != before, "the valve is where it was")
    steps.leave(user)
    balloon = doc.Balloon
    story.expect("001" not in balloon.Label, f"the first balloon is called {balloon.Label}")
    story.expect(doc.Pattern.SealWidth.Value == 6, "the weld is not 6 mm wide")
    story.step("ok")


def _along_the_rim(pattern):
    """Places (3,) mm from where the intake is to a sixth of the way round."""
    seam = list(pattern.Balloon.SeamPoints[: pattern.Balloon.SeamCounts[0]])
    x, y = (float(value) for value in to_mm(build(pattern).intake.at))
    start = min(range(len(seam)), key=lambda k: (seam[k].x - x) ** 2 + (seam[k].y - y) ** 2)
    count = len(seam) // 6
    way = [seam[(start + step * max(count // 12, 1)) % len(seam)] for step in range(13)]
    return [pattern.Placement.multVec(App.Vector(*place)) for place in ((x, y, 0), *way[1:])]


def _advice(user, story, balloon):
    steps.command(user, "Advice", balloon)
    hands.wait_until(lambda: hands.find("Findings").count() > 0 or bool(hands.find("AdviceMessage").text()))
    hands.wait(0.5)
    story.step("advice")
    steps.leave(user, "Close")


def _printed(user, story, balloon):
    steps.command(user, "Artwork", balloon)
    story.step("artwork")
    user.replace(hands.find("Picture"), str(BEAR), confirm=False)
    user.key("Tab")
    hands.wait_until(lambda: artwork.of_balloon(balloon).Status == status.READY, 30)
    hands.wait(0.5)
    story.step("artwork-chosen")
    steps.leave(user)
    story.step("artwork-kept")


def _on_film(user, story, doc):
    steps.command(user, "Nest", doc.Balloon)
    user.replace(hands.find("FilmWidth"), "500 mm")
    user.replace(hands.find("Balloons"), "6")
    story.step("nest")
    user.button("LayOut")
    hands.wait_until(lambda: "used" in hands.find("NestResult").text(), 90)
    story.step("laid-out")
    steps.leave(user)
    sheet = next(obj for obj in doc.Objects if kinds.is_film_sheet(obj))
    story.expect(sheet.Pieces >= 12, f"6 balloons are {sheet.Pieces} pieces")
    story.expect(sheet.UsedLength.Value > 0, "nothing says how much of the roll is used")
    story.step("on-film")


def _exported(user, story, pattern, file):
    steps.command(user, "ExportPattern", pattern)
    user.choose(hands.find("Machine"), "LightBurn")
    hands.wait(0.3)
    story.step("export")
    suggested = hands.find("File").text()
    story.expect(suggested.startswith("bear") and "_mm" in suggested, f"the file is called {suggested}")
    story.expect("mm" in hands.find("Size").text(), "the size is not told")
    story.expect(hands.find("Preflight").count() > 0, "nothing is said of what was checked")
    user.replace(hands.find("File"), str(file), confirm=False)
    steps.leave(user)
    story.step("exported")
    layers = set(re.findall(r"\n *8\r?\n([A-Z_]+)", file.read_text(encoding="utf-8")))
    story.expect({"CUT", "SEAL"} <= layers, f"layers of the file: {layers}")


def _bed_too_small(user, story, pattern, file):
    steps.command(user, "ExportPattern", pattern)
    user.choose(hands.find("Machine"), "Glowforge")
    hands.wait(0.5)
    story.step("bed-too-small")
    user.replace(hands.find("File"), str(file), confirm=False)
    user.panel("Ok")
    hands.wait(1.0)
    story.step("refused")
    story.expect(not file.exists(), "what does not fit was written")
    steps.leave(user, "Cancel")


def _assembly_sheet(user, story, balloon, file):
    steps.command(user, "AssemblySheet", balloon)
    hands.wait_until(lambda: "float?" in steps.said() and "Weight" in steps.said(), 60)
    hands.wait(0.5)
    story.step("assembly")
    user.replace(hands.find("AssemblyFile"), str(file), confirm=False)
    steps.leave(user)
    story.expect(file.exists() and file.read_bytes().startswith(b"%PDF"), "no assembly sheet was written")
    story.step("assembly-written")
