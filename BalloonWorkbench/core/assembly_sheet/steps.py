# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of the work, from resources/assembly/steps.json: those that fit the film and the intake."""

from __future__ import annotations

from dataclasses import dataclass
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
from BalloonWorkbench.core.units import length_text, mass_text, number_text, pressure_text, water_column_text

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
    facts = _facts_of(pattern, film, numbers, panels, settings, say)
    sentences = []
    for step in _entries("steps"):
        if "notes" in step:
            sentences += [say(intake_kind(name).note) for name in facts.intakes if name in step["notes"]]
        elif facts.fits(step):
            sentences.append(say(facts.text(step)))
    return sentences


def work_pictures(
    pattern: Pattern,
    film: Film,
    numbers: Numbers,
    say: Say = in_english,
    *,
    panels: BagPatterns | None = None,
) -> list[tuple[str, str]]:
    """Which figures show the work, and what is said beside each; see `work_figures`. Errors as `steps`."""
    facts = _facts_of(pattern, film, numbers, panels, NO_SETTINGS, say)
    fitting = [entry for entry in _entries("pictures") if facts.fits(entry)]
    return [(str(entry["figure"]), say(facts.text(entry))) for entry in fitting]


@dataclass(frozen=True)
class _BalloonFacts:
    """What a balloon is and has: truths by their keys in the data, words for the texts, names of its intakes,
    how its film is joined, and where settings of a weld are from."""

    is_so: dict[str, bool | None]
    words: dict[str, str]
    intakes: tuple[str, ...]
    joining: str
    known: str

    def fits(self, entry: dict[str, Any]) -> bool:
        """Whether an entry is about this balloon."""
        return (
            ("intakes" not in entry or bool(set(self.intakes) & set(entry["intakes"])))
            and self.joining in entry.get("joining", [self.joining])
            and self.known in entry.get("settings", [self.known])
            and all(self.is_so[key] is entry[key] for key in self.is_so if key in entry)
        )

    def text(self, entry: dict[str, Any]) -> str:
        """What an entry says of it."""
        return str(entry["text"]).format(**self.words)


def _facts_of(
    pattern: Pattern,
    film: Film,
    numbers: Numbers,
    panels: BagPatterns | None,
    settings: WorkSettings,
    say: Say,
) -> _BalloonFacts:
    kinds = [intake_kind(intake.kind) for intake in pattern.intakes]
    safe, pressure = numbers.safety.safe_pressure, numbers.safety.pressure
    floating = numbers.floating[0]
    is_so = {
        "grain": film.lies is not None,
        "one_side": film.one_side,
        "some_grades": film.some_grades,
        "laser": film.laser,
        "holes": any(not hole.front for hole in pattern.of(Role.CUT_INNER)),
        "front_hole": any(hole.front for hole in pattern.of(Role.CUT_INNER)),
        "welds": bool(pattern.of(Role.WELD)),
        "neck": any(kind.place == RIM for kind in kinds),
        "filled": bool(kinds),
        "floats": floating.left > 0.0,
        "many": panels is not None,
        "tabs": panels is not None and any(seam.tabs for seam in panels.seams),
        "caps": panels is not None and panels.caps > 0,
        "safe": None if safe is None else safe >= pressure,
        "cut_settings": bool(settings.cut),
    }
    words = {
        "film": film.title or film.name,
        "seal": length_text(pattern.seal_width, 3),
        "pressure": pressure_text(pressure),
        "safe": "" if safe is None else pressure_text(safe),
        "margin": number_text(numbers.safety.margin),
        "column": water_column_text(pressure if safe is None else min(safe, pressure)),
        "gas": floating.gas,
        "lift": mass_text(max(floating.left, 0.0)),
        "start_values": film.start_values.sentence(say),
        "start_sources": "; ".join(film.start_values.sources),
        **vars(settings),
    }
    known = OWN if settings.weld else START if film.start_values.is_known else CARD
    return _BalloonFacts(is_so, words, tuple(dict.fromkeys(kind.name for kind in kinds)), film.joining, known)


@cache
def _entries(part: str) -> list[dict[str, Any]]:
    """A text, or intakes whose notes are said here, and under which conditions; of pictures also which."""
    try:
        return [dict(entry) for entry in read_data(FILE)[part]]
    except UNUSABLE as error:
        raise InputError(f"The file {FILE.name} is of no use: {error!r}. Install it anew.") from error
