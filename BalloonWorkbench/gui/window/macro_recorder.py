# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user does, as lines of the Python API in the macro and in the Python console.

The window has done the work already, with progress and in a thread: the recorded call returns what there is
instead of doing it once more. Only a macro that is run later works.
"""

from __future__ import annotations

import json

import FreeCADGui as Gui

from BalloonWorkbench.app.api.call import already_done
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target
from BalloonWorkbench.app.group import OUTLINE
from BalloonWorkbench.app.properties import preferences, values

#: Properties of files, and what the Python API calls them.
_FILES = {
    "Drawing": "drawing",
    "ProfileFile": "profile_file",
    "PanelFile": "panel_file",
    "BodyFile": "body_file",
}
_drawings: dict[str, str] = {}  # where drawings came from, by their place in a document


def call(function: str, *arguments: str, result=None, name: str = "", **named: str) -> None:
    """Record `name = BalloonWorkbench.function(...)`; the arguments are Python text.

    result  what the call returns while it is recorded
    """
    listed = [*arguments, *(f"{key}={value}" for key, value in named.items())]
    with already_done(result):
        Gui.doCommand("import BalloonWorkbench")
        Gui.doCommand(f"{name and name + ' = '}BalloonWorkbench.{function}({', '.join(listed)})")


def text(value) -> str:
    """A string, path or number as Python text."""
    return json.dumps(value if isinstance(value, (int, float)) else str(value), ensure_ascii=False)


def obj(document_object) -> str:
    """A document object as Python text."""
    return f'App.ActiveDocument.getObject("{document_object.Name}")'


def came_from(source, path, name: str = "Drawing") -> None:
    """Remember the file that a property holds: the document has a copy without its path."""
    _drawings[getattr(source, name)] = str(path)


def begin(doc, label: str = "Film balloon", source: str = OUTLINE):
    """The objects of a new balloon with the user's preferences, and the edit that begins with them.

    source  what it is made from, of create.SOURCES
    """
    parts = create.make(doc, label, source)
    edit = Edit(parts, values.texts(parts))
    preferences.begin(parts)
    return parts, edit


class Edit:
    """What changes between the start of an edit and its end.

    before  `values.texts` of a new balloon, without the user's preferences
    """

    def __init__(self, parts, before: dict[str, str] | None = None):
        self.parts = parts
        self.is_new = before is not None
        self._before = values.texts(parts) if before is None else before
        self._sketches = self._sketches_now()

    def write(self) -> None:
        """Record the changes, if there are any, and the sketches that were made of the pattern."""
        self._write_changes()
        for sketch in self._sketches_now()[len(self._sketches) :]:
            call("sketch", obj(self.parts.pattern), result=sketch, name="sketch")

    def _sketches_now(self) -> list:
        group = self.parts.pattern.getParentGroup()
        return [one for one in group.Group if one.isDerivedFrom("Sketcher::SketchObject")] if group else []

    def _write_changes(self) -> None:
        changed = {
            name: value for name, value in values.texts(self.parts).items() if self._before.get(name) != value
        }
        outline = self.parts.outline
        for name, key in _FILES.items():
            if key in changed:
                held = getattr(outline, name)
                changed[key] = text(_drawings.get(held, held))
        if not self.is_new:
            if changed:
                call("change", f"BalloonWorkbench.parts({obj(self.parts.balloon)})", **changed)
        elif is_gored_body(outline):
            self._write_from_profile(changed)
        elif is_bag(outline):
            self._write_from_panels(changed)
        elif is_target(outline):
            self._write_from_body(changed)
        elif outline.Source:
            self._write_from_sketch(changed)
        elif outline.Drawing:
            self._write_from_picture(changed)

    def _write_from_profile(self, changed: dict[str, str]) -> None:
        path = changed.pop("profile_file", "None")
        changed.pop("profile_from", None)
        arguments = self._source_of(changed) if self.parts.outline.Source else [path]
        call("from_profile", "App.ActiveDocument", *arguments, result=self.parts, name="balloon", **changed)

    def _write_from_panels(self, changed: dict[str, str]) -> None:
        sources = [changed.pop(key) for key in ("panels", "ready", "panel_file") if key in changed]
        if sources:
            call(
                "from_panels", "App.ActiveDocument", sources[0], result=self.parts, name="balloon", **changed
            )

    def _write_from_body(self, changed: dict[str, str]) -> None:
        sources = [changed.pop(key) for key in ("solid", "body_file") if key in changed]
        if sources:
            call("from_body", "App.ActiveDocument", sources[0], result=self.parts, name="balloon", **changed)

    def _source_of(self, changed: dict[str, str]) -> list[str]:
        """The sketch, wire or face that is followed, as arguments."""
        changed.pop("source")
        source, elements = self.parts.outline.Source
        return [obj(source), json.dumps(list(elements))] if any(elements) else [obj(source)]

    def _write_from_sketch(self, changed: dict[str, str]) -> None:
        arguments = self._source_of(changed)
        call("from_sketch", "App.ActiveDocument", *arguments, result=self.parts, name="balloon", **changed)

    def _write_from_picture(self, changed: dict[str, str]) -> None:
        path = changed.pop("drawing")
        size = values.texts(self.parts)
        lengths = {
            name: size[name]
            for name in ("width", "height")
            if getattr(self.parts.outline, name.capitalize()).Value > 0.0
        }
        named = lengths | {name: value for name, value in changed.items() if name not in ("width", "height")}
        call("from_picture", "App.ActiveDocument", path, result=self.parts, name="balloon", **named)
