# SPDX-License-Identifier: LGPL-2.1-or-later
"""The maker's numbers of a balloon as names and texts for a panel."""

from __future__ import annotations

from BalloonWorkbench.app import maker, status
from BalloonWorkbench.app.create import Parts
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.units import to_grams, to_mm
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.sentences import tell


def rows(parts) -> list[tuple[str, str]]:
    """What it takes and whether it floats; nothing while something is not up to date."""
    if not all(status.is_ready(obj) for obj in (parts.balloon, parts.pattern)):
        return []
    try:
        numbers = maker.numbers(parts, exact=False)  # the window does not wait
    except BalloonError:
        return []
    return [
        (translate("Film needed"), _film(numbers)),
        (translate("Weld length"), translate("{:.2f} m").format(numbers.seam_length)),
        (translate("Weight"), _weight(numbers)),
        (translate("Safe pressure"), _strength(numbers)),
        (translate("Gas"), _gas(numbers)),
        (translate("Will it float?"), tell(numbers.sentence())),
    ]


def short_rows(balloon, pattern) -> list[tuple[str, str]]:
    """Those that a panel about something else has room for."""
    wanted = (translate("Film needed"), translate("Safe pressure"), translate("Will it float?"))
    found = rows(Parts(balloon.Outline, balloon, pattern)) if balloon.SolvedFor else []
    return [(name, text) for name, text in found if name in wanted]


def _film(numbers) -> str:
    if numbers.roll is None:
        return translate("{:.3g} m², wider than the usual roll").format(numbers.film_area)
    width, length = numbers.roll
    return translate("{:.2f} m of a roll of {:.0f} mm").format(length, to_mm(width))


def _weight(numbers) -> str:
    told = translate("{:.3g} g: film {:.3g}, weld and neck {:.2g}, valve {:.2g}")
    parts = (numbers.weight, numbers.inner, numbers.border, numbers.valve)
    return told.format(*map(to_grams, parts))


def _strength(numbers) -> str:
    safe = numbers.safety
    if safe.safe_pressure is None:
        return translate("unknown: this film has no strength")
    if safe.safe_pressure < safe.pressure:
        told = translate("less than its {:.3g} kPa with a margin of {:g} ({})")
        return told.format(1e-3 * safe.pressure, safe.margin, tell(safe.weakest))
    told = translate("{:.3g} kPa, margin {:g} ({})")
    return told.format(1e-3 * safe.safe_pressure, safe.margin, tell(safe.weakest))


def _gas(numbers) -> str:
    one = numbers.floating[0]
    told = translate("{:.3g} l of {}").format(1e3 * one.gas_needed, tell(one.gas))
    if one.cost is None:
        return told
    return told + translate(", about {:.2f} {}").format(one.cost, numbers.currency)
