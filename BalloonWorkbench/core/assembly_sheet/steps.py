# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of the work, from resources/assembly/steps.json: those that fit the film and the intake."""

from __future__ import annotations

from functools import cache
from typing import Any

from BalloonWorkbench.core.assembly_sheet.work_settings import CARD, NO_SETTINGS, OWN, START, WorkSettings
from BalloonWorkbench.core.bag_pattern.bag_patterns import BagPatterns
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.pattern.intake.kinds import RIM, intake_kind
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import length_text, number_text, pressure_text

FILE = RESOURCES / "assembly" / "steps.json"


def steps(
    pattern: Pattern,
    film: Film,
    numbers: Numbers,
    say: Say = in_english,
    *,
    panels: BagPatterns | None = None,
    settings: WorkSettings = NO_SETTINGS,
) -> list[str]:
    """What to do, a few sentences each, in order. InputError when the data file is broken.

    panels  of a balloon of many; None for two equal ones
    """
    known = OWN if settings.weld else START if film.start_values.is_known else CARD
    kinds = [intake_kind(intake.kind) for intake in pattern.intakes]
    safe = numbers.safety.safe_pressure
    is_so = {
        "grain": film.lies is not None,
        "one_side": film.one_side,
        "some_grades": film.some_grades,
        "laser": film.laser,
        "holes": any(not hole.front for hole in pattern.of(Role.CUT_INNER)),
        "front_hole": any(hole.front for hole in pattern.of(Role.CUT_INNER)),
        "welds": bool(pattern.of(Role.WELD)),
        "neck": any(kind.place == RIM for kind in kinds),
        "many": panels is not None,
        "tabs": panels is not None and any(seam.tabs for seam in panels.seams),
        "caps": panels is not None and panels.caps > 0,
        "safe": None if safe is None else safe >= numbers.safety.pressure,
        "cut_settings": bool(settings.cut),
    }
    words = {
        "film": film.title or film.name,
        "seal": length_text(pattern.seal_width, 3),
        "pressure": pressure_text(numbers.safety.pressure),
        "safe": "" if safe is None else pressure_text(safe),
        "margin": number_text(numbers.safety.margin),
        "start_values": film.start_values.sentence(),
        "start_sources": "; ".join(film.start_values.sources),
        **vars(settings),
    }
    names = list(dict.fromkeys(kind.name for kind in kinds))
    sentences = []
    for step in _steps():
        if "notes" in step:
            sentences += [say(intake_kind(name).note) for name in names if name in step["notes"]]
        elif "intakes" in step and not set(names) & set(step["intakes"]):
            continue
        elif (
            film.joining in step.get("joining", [film.joining])
            and known in step.get("settings", [known])
            and all(is_so[key] is step[key] for key in is_so if key in step)
        ):
            sentences.append(say(str(step["text"]).format(**words)))
    return sentences


@cache
def _steps() -> list[dict[str, Any]]:
    """A text, or intakes whose notes are said here, and under which conditions."""
    try:
        return [dict(step) for step in read_data(FILE)["steps"]]
    except UNUSABLE as error:
        raise InputError(f"The file {FILE.name} is of no use: {error!r}. Install it anew.") from error
