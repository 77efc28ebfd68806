# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows and sections of the validation page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    """A found value beside its reference; tolerance is relative to it, or None where nothing is asked."""

    what: str
    found: float
    reference: float
    tolerance: float | None = None
    digits: int = 6

    @property
    def error(self) -> float:
        """Relative to the reference."""
        return self.found / self.reference - 1.0

    @property
    def met(self) -> bool:
        """Whether the error is within the tolerance."""
        return self.tolerance is None or abs(self.error) <= self.tolerance

    @property
    def cells(self) -> tuple[str, ...]:
        """Cells of the table."""
        asked = "" if self.tolerance is None else f"{_percent(self.tolerance)}"
        verdict = "" if self.tolerance is None else "yes" if self.met else "**no**"
        found, reference = f"{self.found:.{self.digits}g}", f"{self.reference:.{self.digits}g}"
        error = f"{100.0 * self.error:+.2f} %" if abs(self.error) >= 1e-4 else f"{self.error:+.0e}"
        return self.what, found, reference, error, asked, verdict


@dataclass(frozen=True)
class Section:
    """A section of the page: text in Markdown, and the rows in it that ask for something."""

    title: str
    text: str
    rows: tuple[Row, ...] = ()


def _percent(value: float) -> str:
    return f"{100.0 * value:.3g} %" if value >= 1e-4 else f"{value:.0e}"


def rows_table(rows: Sequence[Row]) -> str:
    """The rows as a table."""
    return table(("", "found", "reference", "error", "tolerance", "within"), [row.cells for row in rows])


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in Markdown."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def section(title: str, intro: str, rows: Sequence[Row], more: str = "") -> Section:
    """A section of a text and one table."""
    return Section(
        title, "\n".join(part for part in (paragraphs(intro), rows_table(rows), more) if part), tuple(rows)
    )


def paragraphs(text: str) -> str:
    """Text with its line breaks set anew, one paragraph a line."""
    return "\n\n".join(" ".join(part.split()) for part in text.strip().split("\n\n")) + "\n"
