# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the paint window into the document, and back."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path

import FreeCAD as App

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.document.parts import Parts, companions
from BalloonWorkbench.app.drawings import painting as painted
from BalloonWorkbench.app.group import name_group
from BalloonWorkbench.app.outline import DRAWN_AS, SYMMETRY
from BalloonWorkbench.core.files.write import write_files
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.gui.paint.preview.painting_display import MODE
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import macro_recorder


@dataclass(frozen=True)
class BalloonValues:
    """What a painted balloon of a document was made with.

    width  mm
    visible  names of the objects that can be seen
    """

    file: Path
    width: float
    settings: Settings
    visible: tuple[str, ...]


def values_of(parts: Parts) -> BalloonValues:
    """The values of a balloon that was made before; usual ones while its outline is of no use."""
    outline = parts.outline
    settings = balloon.request(parts.balloon).settings if outline.LoopCounts else Settings()
    settings = replace(
        settings,
        symmetry=SYMMETRY[outline.Symmetry],
        drawn_as=DRAWN_AS[outline.DrawnAs],
        pattern=pattern.values(parts.pattern),
    )
    everything = [obj for each in (parts, *companions(parts)) for obj in each]
    visible = tuple(obj.Name for obj in everything if obj.ViewObject.Visibility)
    return BalloonValues(Path(outline.Drawing), outline.Width.Value, settings, visible)


def keep(doc, parts: Parts | None, state, width: float, pause) -> Parts:
    """Put a full design into the document, as a new balloon or instead of an older one; returns the balloon.

    pause is called between the steps of the work. Raises BalloonError.
    """
    if parts is not None:
        edit = macro_recorder.Edit(parts)
        painted.update(parts, state.file, width, state.solved, pause)
        _record(edit, state.file)
        return parts
    edits: list[macro_recorder.Edit] = []

    def begin(doc, label: str) -> Parts:
        parts, edit = macro_recorder.begin(doc, label)
        edits.append(edit)
        return parts

    parts = painted.make(doc, state.file, width, state.solved, pause, begin)
    _record(edits[0], state.file)
    name_group(parts.balloon.getParentGroup(), translate("Painted balloon"))
    for each in (parts, *companions(parts)):
        each.balloon.ViewObject.DisplayMode = MODE
        pause()
    return parts


def _record(edit, file: Path) -> None:
    """The macro needs the painting: it stays in a folder of the user's data."""
    content = file.read_bytes()
    folder = Path(App.getUserAppDataDir()) / "BalloonWorkbench" / "paintings"
    path = folder / f"{file.stem}-{hashlib.sha256(content).hexdigest()[:8]}.png"
    write_files(folder, {path.name: content})
    macro_recorder.came_from(edit.parts.outline, path)
    edit.write()


def show(document, names, visible: bool) -> None:
    """Show or hide objects of a document in the window; nothing in one that is being closed: None."""
    if document is None:
        return
    for obj in map(document.Document.getObject, names):
        if obj is not None:
            obj.ViewObject.Visibility = visible
