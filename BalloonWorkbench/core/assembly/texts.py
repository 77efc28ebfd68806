# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the assembly sheet says in its lists, and how text is broken into lines."""

from __future__ import annotations

import re
import textwrap

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.maker.numbers import Numbers
from BalloonWorkbench.core.pattern.intake_kinds import intake_kind
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.units import to_grams, to_mm


def material(film: Film, pattern: Pattern, numbers: Numbers) -> list[tuple[str, str]]:
    """What it is made of: names and values."""
    found = [
        ("Film", film.title or film.name),
        ("Thickness", f"{1e6 * film.thickness:.3g} µm, {1e3 * film.areal_density:.3g} g/m²"),
    ]
    if numbers.roll is None:
        found.append(("Needed", f"{numbers.film_area:.3g} m²; wider than the usual roll"))
    else:
        width, length = numbers.roll
        found.append(("Needed", f"{length:.2f} m of a roll {to_mm(width):.0f} mm wide"))
    found.append(("Weld", f"{to_mm(pattern.seal_width):.3g} mm wide, {numbers.seam_length:.2f} m long"))
    intakes = pattern.intakes
    if intakes:
        kind = intake_kind(intakes[0].kind).title
        found.append(("Intake", f"{kind}, {to_mm(intakes[0].width):.3g} mm"))
    return found


def figures(numbers: Numbers) -> list[tuple[str, str]]:
    """What it takes and bears: names and values."""
    safe = numbers.safety
    valve = f", valve {to_grams(numbers.valve):.2g} g" if numbers.valve else ""
    found = [
        ("Volume", f"{1e3 * numbers.volume:.3g} litres"),
        ("Weight", f"{to_grams(numbers.weight):.3g} g{' with' * bool(valve)}{valve.lstrip(',')}"),
        ("Pressure", f"{1e-3 * safe.pressure:.3g} kPa"),
    ]
    if safe.safe_pressure is not None:
        found.append(
            ("Safe to", f"{1e-3 * safe.safe_pressure:.3g} kPa ({safe.weakest}, margin {safe.margin:g})")
        )
    one = numbers.floating[0]
    price = "" if one.cost is None else f", about {one.cost:.2f} {numbers.currency}"
    found.append((one.gas.capitalize(), f"{1e3 * one.gas_needed:.3g} litres{price}"))
    found.append(("Will it float?", numbers.sentence()))
    return found


def broken(text: str, letters: int) -> list[str]:
    """Lines of so many letters; a number stays with its unit."""
    kept = re.sub(r"(\d) (?=(?:mm|cm|m|µm|g|kPa|litres)\b)", "\\1\u00a0", text)
    return textwrap.wrap(kept, letters) or [""]
