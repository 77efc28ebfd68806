# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user does with flat pieces, in the document: an undo step each, and a line of the macro."""

from __future__ import annotations

import math

import FreeCAD as App

from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.pattern import bag_patterns
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.app.shapes import piece_places
from BalloonWorkbench.core.arrangement.arrangement import (
    Arrangement,
    LaidPieces,
    PiecePlace,
    arrangement_of,
    names_of,
)
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.panels import is_free
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import undo_step


def lay(obj, laid: LaidPieces, number: int, place: PiecePlace) -> bool:
    """Keep that a piece lies elsewhere; False while a panel is open, which has a step of its own."""
    if not is_free():
        return False
    places = [place if each == number else own for each, own in enumerate(laid.places)]
    with undo_step(obj.Document, _title(laid.places[number], place)):
        piece_places.keep(obj, arrangement_of(laid.base, places))
        obj.Document.commitTransaction()
    _record(obj, names_of(laid.base)[number], place)
    return True


def reset(obj) -> None:
    """Let all pieces lie as the pattern lays them."""
    if not is_free():
        return
    with undo_step(obj.Document, translate("Lay out anew")):
        piece_places.keep(obj, Arrangement())
        obj.Document.commitTransaction()
    if obj.Document == App.ActiveDocument:
        macro_recorder.call("arrange", macro_recorder.obj(obj))


def undo(doc, back: bool) -> None:
    """Take the last step of a document back, or take it anew; not while a panel is open."""
    if is_free() and (doc.UndoCount if back else doc.RedoCount):
        (doc.undo if back else doc.redo)()


def grains(obj, laid: LaidPieces) -> list[float | None]:
    """The direction of the film's grain in each piece as the pattern lays it [rad]; None without a grain."""
    count = len(laid.places)
    own = film.read(obj.Balloon).lies if is_pattern(obj) else None
    if own is None:
        return [None] * count
    many = has_many_panels(obj.Balloon)
    panels = [own] * len(bag_patterns(obj).panels) if many else [own, math.pi - own]
    return [*panels, *[0.0] * (count - len(panels))]


def _title(before: PiecePlace, after: PiecePlace) -> str:
    if before.mirrored != after.mirrored:
        return translate("Mirror piece")
    return translate("Turn piece") if before.angle != after.angle else translate("Move piece")


def _record(obj, name: str, place: PiecePlace) -> None:
    if obj.Document != App.ActiveDocument:
        return
    x, y = (macro_recorder.text(round(to_mm(each), 6)) for each in place.middle)
    named = {}
    if place.angle:
        named["angle"] = macro_recorder.text(round(math.degrees(place.angle), 9))
    if place.mirrored:
        named["mirrored"] = "True"
    macro_recorder.call(
        "arrange", macro_recorder.obj(obj), macro_recorder.text(name), at=f"({x}, {y})", **named
    )
