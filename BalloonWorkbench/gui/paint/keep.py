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

    width   mm
    sheet   values of the pattern
    shown   names of the objects that can be seen
    """

    file: Path
    width: float
    settings: Settings | None
    sheet: dict
    shown: tuple[str, ...]


def kept(parts: Parts) -> Kept:
    """The values of a balloon that was made before; no settings while its outline is of no use."""
    outline, settings = parts.outline, None
    if outline.LoopCounts:
        settings = replace(
            balloon.request(parts.balloon).settings,
            symmetry=SYMMETRY[outline.Symmetry],
            intake=parts.pattern.Intake,
        )
    everything = [obj for each in (parts, *create.companions(parts)) for obj in each]
    shown = tuple(obj.Name for obj in everything if obj.ViewObject.Visibility)
    return Kept(Path(outline.Drawing), outline.Width.Value, settings, pattern.values(parts.pattern), shown)


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
