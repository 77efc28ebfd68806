# SPDX-License-Identifier: LGPL-2.1-or-later
"""A maker inflates a picture chooses width and film, prints, lays out, and meets a bed too small."""

from pathlib import Path

import FreeCAD as App
import hands

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import kinds

HEART = Path("resources/examples/pictures/heart.png").resolve()


def solved():
    return hands.find("Apply").isVisible()


def ready():
    return [
        obj.Status
        for obj in App.ActiveDocument.Objects
        if type(getattr(obj, "Proxy", None)).__name__ == "BalloonProxy"
    ] == [status.READY]


def test_maker(user, story, tmp_path):
    _balloon_of_picture(user, story)
    doc = App.ActiveDocument
    _printed(user, story, doc.Balloon)
    _on_film(user, story, doc)
    _assembly_sheet(user, story, doc.Balloon, tmp_path)
    _colour_map(user, story, doc.Balloon)
    _bed_too_small(user, story, doc.Pattern, tmp_path)


def _balloon_of_picture(user, story):
    with user.answering(HEART, expected=False) as chooser:
        user.command("BalloonWorkbench_FromPicture")
        hands.wait_until(hands.panel_is_seen)
        hands.wait(1.0)
    story.expect(chooser, "no chooser of files opens")
    story.step("panel")
    if not chooser:
        user.replace(hands.find("Drawing"), str(HEART))
    hands.wait(0.3)
    story.step("picture")
    hands.wait_until(lambda: ready() and solved(), 60)
    story.step("inflated")
    user.replace(hands.find("Width"), "400 mm")
    hands.wait(0.3)
    story.step("wider-being-worked-out")
    hands.wait_until(lambda: ready() and solved(), 60)
    story.step("wider")
    film = hands.find("Film")
    hands.show_tab(film)
    user.choose(film, film.itemText(1))
    hands.wait_until(lambda: ready() and solved(), 60)
    story.step("film")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    balloon = App.ActiveDocument.Balloon
    story.expect("001" not in balloon.Label, f"the first balloon is called {balloon.Label}")
    story.step("ok")


def _printed(user, story, balloon):
    user.select(balloon)
    user.command("BalloonWorkbench_Artwork")
    hands.wait_until(hands.panel_is_seen)
    story.step("artwork")
    user.replace(hands.find("Picture"), str(HEART), confirm=False)
    user.key("Tab")
    hands.wait_until(lambda: artwork.of_balloon(balloon).Status == status.READY, 30)
    hands.wait(0.5)
    story.step("artwork-chosen")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    story.step("artwork-kept")


def _on_film(user, story, doc):
    user.select(doc.Balloon)
    user.command("BalloonWorkbench_Nest")
    hands.wait_until(hands.panel_is_seen)
    story.step("nest")
    user.button("LayOut")
    hands.wait_until(lambda: bool(hands.find("NestResult").text()), 90)
    story.step("laid-out")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    assert any(kinds.is_film_sheet(obj) for obj in doc.Objects)
    story.step("on-film")


def _assembly_sheet(user, story, balloon, folder):
    user.select(balloon)
    user.command("BalloonWorkbench_AssemblySheet")
    hands.wait_until(hands.panel_is_seen)
    hands.wait(3.0)
    story.step("assembly")
    user.replace(hands.find("AssemblyFile"), str(folder / "sheet.pdf"), confirm=False)
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    assert (folder / "sheet.pdf").exists()
    story.step("assembly-written")


def _colour_map(user, story, balloon):
    user.select(balloon)
    user.command("BalloonWorkbench_ColourMap")
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.5)
    story.step("colours")
    user.panel("Cancel")
    hands.wait_until(hands.panel_is_closed)


def _bed_too_small(user, story, pattern, folder):
    user.select(pattern)
    user.command("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    user.choose(hands.find("Machine"), "Glowforge")
    hands.wait(0.5)
    story.step("bed-too-small")
    user.replace(hands.find("File"), str(folder / "heart.svg"), confirm=False)
    user.panel("Ok")
    hands.wait(1.0)
    story.step("refused")
    user.panel("Cancel")
    hands.wait_until(hands.panel_is_closed)
