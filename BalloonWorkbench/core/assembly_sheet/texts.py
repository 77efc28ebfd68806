# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the assembly sheet says in its lists, and how text is broken into lines."""

from __future__ import annotations

import re
from collections.abc import Callable

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.making.numbers import Numbers
from BalloonWorkbench.core.making.safety import WELD
from BalloonWorkbench.core.pages.fonts import WIDE
from BalloonWorkbench.core.pattern.intake.kinds import intake_kind
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import (
    area_text,
    length_text,
    mass_text,
    money_text,
    number_text,
    pressure_text,
    volume_text,
    water_column_text,
)

# Japanese is broken between any two letters, but for these that end or begin a line.
_LAST, _FIRST = "、。，．・：；？！）」』】〕ーぁぃぅぇぉっゃゅょァィゥェォッャュョ々～)", "（「『【〔"
#: What stays whole, with the blanks before it: a word up to a hyphen in it, or one wide letter.
_PIECE = re.compile(
    rf" *[{_FIRST}]*(?:[{WIDE}]|[^ {WIDE}]+?(?<=[^\W\d])-(?=[^\W\d])|[^ {WIDE}]+)[{_LAST}]*|[ {_FIRST}]+"
)
_BLANK = "\u00a0"  # where no line ends


def material(film: Film, pattern: Pattern, numbers: Numbers, say: Say = in_english) -> list[tuple[str, str]]:
    """What it is made of: names and values."""
    rows = [
        (say("Film"), say(film.title or film.name)),
        (
            say("Thickness"),
            f"{number_text(1e6 * film.thickness)} µm, {number_text(1e3 * film.areal_density)} g/m²",
        ),
    ]
    if numbers.roll is None:
        rows.append((say("Needed"), say(f"{area_text(numbers.film_area)}; wider than the usual roll")))
    else:
        width, length = numbers.roll
        rows.append((say("Needed"), say(f"{length_text(length, 3)} of a roll {length_text(width)} wide")))
    wide = length_text(pattern.seal_width, 3)
    rows.append(
        (say(film.seam.capitalize()), say(f"{wide} wide, {length_text(numbers.seam_length, 3)} long"))
    )
    intakes = pattern.intakes
    if intakes:
        kind = intake_kind(intakes[0].kind)
        rows.append((say("Intake"), f"{say(kind.title)}, {length_text(intakes[0].width, 3)}"))
        if kind.stock is not None:
            rows.append((say("Strips"), say(kind.stock.title)))
    return rows


def figures(film: Film, numbers: Numbers, say: Say = in_english) -> list[tuple[str, str]]:
    """What it takes and bears: names and values."""
    safe, weight = numbers.safety, mass_text(numbers.weight)
    if numbers.valve:
        weight = say(f"{weight} with valve {mass_text(numbers.valve)}")
    rows = [
        (say("Volume"), volume_text(numbers.volume)),
        (say("Weight"), weight),
        (say("Pressure"), pressure_text(safe.pressure)),
    ]
    if safe.safe_pressure is not None:
        weakest = film.seam if safe.weakest == WELD else safe.weakest
        bears = say(f"{pressure_text(safe.safe_pressure)} ({weakest}, margin {number_text(safe.margin)})")
        rows.append((say("Safe to"), bears))
    least = safe.pressure if safe.safe_pressure is None else min(safe.pressure, safe.safe_pressure)
    rows.append((say("Water column"), say(f"at most {water_column_text(least)}")))
    one = numbers.floating[0]
    gas = volume_text(one.gas_needed)
    if one.cost is not None:
        gas = gas + say(f", about {money_text(one.cost, numbers.currency)}")
    rows.append((say(one.gas.capitalize()), gas))
    rows.append((say("Will it float?"), say(numbers.sentence())))
    return rows


def broken(text: str, fits: Callable[[str], bool]) -> list[str]:
    """Lines that fit; a number stays with its unit, a French mark with its word."""
    joined = re.sub(
        r"(\d) (?=(?:[µm]?m|cm[²³]?|m[²³]|mm[²³]|m?l|[mk]?g|[kM]?Pa|min)(?![^\W\d]))", rf"\1{_BLANK}", text
    )
    joined = re.sub(r" (?=[:;?!»%])|(?<=«) ", _BLANK, joined)
    lines, line = [], ""
    for piece in _PIECE.findall(joined):
        if line and not fits(line + piece):
            lines.append(line)
            line = ""
        line = line + piece if line else piece.lstrip(" ")
        while len(line) > 1 and not fits(line):  # a word longer than a line
            most = max(1, next(count for count in range(len(line) - 1, -1, -1) if fits(line[:count])))
            lines.append(line[:most])
            line = line[most:]
    return [*lines, line] if line or not lines else lines
