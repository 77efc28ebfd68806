# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the processor time of a cold inflation goes, against what its arithmetic needs at the least."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

TITLE = "Where the time of a cold inflation goes"
_TEXT = """\
## {title}

{run}A cold inflation is a start, the order of elimination, which is looked for once, and Newton steps: each
assembles the tangent, factors it, substitutes both ways and looks along the step. Before the steps: start and
order, from a run of no step. Factorisation: the solver's own with both substitutions, timed by itself on one
thread, times their number. The rest is assembly, line search and, where there are two threads, what they lose
on each other. The operations are those that CHOLMOD would do in the better order of AMD and METIS; fastest is
OpenBLAS's product of two dense matrices on one thread, which no factorisation exceeds; so the bound is the
part of our time that these operations would take by themselves at that speed.

{table}"""


#: Writes a table from its head and its rows.
Table = Callable[[tuple[str, ...], list[tuple[str, ...]]], str]


def section(solves: list[dict[str, Any]], table: Table, run: str = "") -> str:
    """The part of the page, of solves that were timed before their first step, too."""
    head = (
        "outline",
        "vertices",
        "cold, s",
        "before the steps",
        "factorisation",
        "the rest",
        "factorisations",
        "operations, G",
        "ours, G/s",
        "CHOLMOD, G/s",
        "fastest, G/s",
        "bound",
    )
    return _TEXT.format(title=TITLE, run=run, table=table(head, [_row(one) for one in solves]))


def _row(one: dict[str, Any]) -> tuple[str, ...]:
    rod, count, cold = one["yardstick"], one["cold"]["factorisations"], one["cold"]["cpu"]
    before = one["begun"]["cpu"]
    factored = count * rod["ours"]["factor_and_solve_seconds"]
    rest = cold - before - factored
    operations = count * rod["flops"]
    return (
        one["shape"],
        str(one["vertices"]),
        f"{cold:.3g}",
        *(f"{100 * part / cold:.0f} %" for part in (before, factored, rest)),
        str(count),
        f"{operations / 1e9:.3g}",
        f"{rod['flops'] / rod['ours']['factor_seconds'] / 1e9:.0f}",
        f"{rod['flops'] / rod['factor_seconds'] / 1e9:.0f}",
        f"{rod['fastest'] / 1e9:.0f}",
        f"**{100 * operations / rod['fastest'] / cold:.0f} %**",
    )


def replaced(text: str, part: str) -> str:
    """The page with this part, or with it for the first time, behind those about cold and warm solves."""
    parts = [one for one in text.split("\n## ") if not one.startswith(TITLE)]
    at = next((k + 1 for k, one in enumerate(parts) if one.startswith("Cold and warm")), len(parts))
    return "\n## ".join([*parts[:at], part.removeprefix("## "), *parts[at:]])
