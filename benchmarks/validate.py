# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy: every reference solution against the solver, to docs/validation.md and its figures."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from speed import machine
from validation import (
    accidents,
    bags,
    balloons,
    bands,
    coach,
    convergence,
    correction,
    gores,
    methods,
    panels,
    plates,
    strength,
    targets,
    trade,
    welds,
)
from validation.report import Section, paragraphs

DOCS = Path(__file__).resolve().parents[1] / "docs"


def main() -> int:
    """Compute everything and write it down."""
    parts = [
        balloons.disc,
        balloons.tube,
        balloons.ring,
        balloons.square,
        balloons.airbag,
        panels.panels,
        bags.bags,
        gores.gores,
        lambda: targets.targets(DOCS / "images"),
        plates.hencky,
        plates.bending,
        plates.wrinkled_beam,
        trade.trade,
        trade.inverse,
        balloons.relative_volume,
        balloons.solvers,
        lambda: convergence.convergence(DOCS / "images"),
        convergence.independence,
        strength.strength,
        lambda: correction.correction(DOCS / "images"),
        bands.bands,
        welds.welds,
        accidents.accidents,
        methods.methods,
        lambda: coach.coach(DOCS / "images"),
    ]
    sections: list[Section] = []
    for part in parts:
        began = time.process_time()
        found = part()
        sections += [found] if isinstance(found, Section) else list(found)
        sys.stdout.write(f"{sections[-1].title}: {time.process_time() - began:.0f} s of processor time\n")
        sys.stdout.flush()
    (DOCS / "validation.md").write_text(page(sections), encoding="utf-8")
    sys.stdout.write(summary(sections))
    return 0


def summary(sections: list[Section]) -> str:
    """What is within its tolerance and what is not."""
    rows = [(section, row) for section in sections for row in section.rows if row.tolerance is not None]
    missed = [(section, row) for section, row in rows if not row.met]
    lines = [f"{len(rows) - len(missed)} of {len(rows)} values are within their tolerance."]
    if missed:
        lines[0] += " Not these:\n"
    for section, row in missed:
        values = f"found {row.found:.{row.digits}g} for {row.reference:.{row.digits}g}"
        asked = f"{100 * row.error:+.1f} %, asked {100 * (row.tolerance or 0.0):g} %"
        lines.append(f"- {section.title}: {row.what}, {values} ({asked})")
    return "\n".join(lines) + "\n"


def page(sections: list[Section]) -> str:
    """The page."""
    computer = machine.description()
    head = f"""Written by `make validation` from runs of the solver; nothing is typed but the references.
    Processor seconds are those of all threads on {computer["processor"]} with {computer["threads"]}
    threads, other work going on beside.

    The references are closed forms, quadratures, published values and, for discs and rings, an energy of
    the profile alone (`benchmarks/validation/axisymmetric.py`). A comparison with another program on the
    same mesh, Surface Evolver, is in [benchmarks.md](benchmarks.md)."""
    parts = ["# Validation\n", paragraphs(head), summary(sections)]
    parts += [f"## {section.title}\n\n{section.text}" for section in sections]
    return "\n".join(parts)


if __name__ == "__main__":
    raise SystemExit(main())
