# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the paint window into the document, and back."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from BalloonWorkbench.app import balloon, create, pattern
from BalloonWorkbench.app import painting as painted
from BalloonWorkbench.app.create import Parts
from BalloonWorkbench.app.outline import SYMMETRY
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.gui.paint.display import MODE
from BalloonWorkbench.gui.qt import translate


@dataclass(frozen=True)
class Kept:
    """What a painted balloon of a document was made with.

    width  mm
    shown  names of the objects that can be seen
    """

    file: Path
    width: float
    settings: Settings
    shown: tuple[str, ...]


def kept(parts: Parts) -> Kept:
    """The values of a balloon that was made before; usual ones while its outline is of no use."""
    outline = parts.outline
    settings = balloon.request(parts.balloon).settings if outline.LoopCounts else Settings()
    settings = replace(settings, symmetry=SYMMETRY[outline.Symmetry], wanted=pattern.values(parts.pattern))
    everything = [obj for each in (parts, *create.companions(parts)) for obj in each]
    shown = tuple(obj.Name for obj in everything if obj.ViewObject.Visibility)
    return Kept(Path(outline.Drawing), outline.Width.Value, settings, shown)


def keep(doc, parts: Parts | None, look, width: float, pause) -> Parts:
    """Put a study into the document, as a new balloon or instead of an older state; returns the balloon.

    pause is called between the steps of the work. Raises BalloonError.
    """
    if parts is not None:
        painted.update(parts, look.file, width, look.solved, pause)
        return parts
    parts = painted.make(doc, look.file, width, look.solved, pause)
    parts.balloon.getParentGroup().Label = translate("Painted balloon")
    for each in (parts, *create.companions(parts)):
        each.balloon.ViewObject.DisplayMode = MODE
        pause()
    return parts


def show(document, names, shown: bool) -> None:
    """Show or hide objects of a document in the window; nothing in one that is being closed: None."""
    if document is None:
        return
    for obj in map(document.Document.getObject, names):
        if obj is not None:
            obj.ViewObject.Visibility = shown
