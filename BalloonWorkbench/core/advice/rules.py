# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules as data: what is measured, from where on it matters and how it is said."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

from BalloonWorkbench.core.advice.findings import Severity
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data

FILE = RESOURCES / "advice" / "rules.json"


@dataclass(frozen=True)
class Limit:
    """From where on a measure has a severity: `times` the scale named `of`; and how that is said."""

    severity: Severity
    times: float
    of: str
    sentence: str


@dataclass(frozen=True)
class Rule:
    """One rule; `above` where large measures are bad. Its sentences have {places} for numbers."""

    name: str
    title: str
    measure: str
    above: bool
    limits: tuple[Limit, ...]
    sources: tuple[str, ...]

    def judge(self, measured: float, scales: dict[str, float]) -> tuple[Limit, float] | None:
        """The worst limit that a measure breaks, and its value; None where all is well.

        scales  values of the names that limits are given in
        """
        broken = [
            (limit, value)
            for limit in self.limits
            for value in (limit.times * scales[limit.of],)
            if (measured > value if self.above else measured < value)
        ]
        return max(broken, key=lambda pair: pair[0].severity.rank, default=None)

    def first(self, scales: dict[str, float]) -> float:
        """The limit at which a measure begins to matter."""
        values = [limit.times * scales[limit.of] for limit in self.limits]
        return min(values) if self.above else max(values)


@cache
def rules() -> dict[str, Rule]:
    """All rules by name. Raises InputError when the file is broken."""
    try:
        data: dict[str, Any] = read_data(FILE)
        return {name: _rule(name, entry) for name, entry in data.items()}
    except UNUSABLE as error:
        raise InputError(
            f"The file of rules {FILE.name} is of no use: {error!r}. Install it anew."
        ) from error


def _rule(name: str, entry: dict[str, Any]) -> Rule:
    if entry["worse"] not in ("above", "below"):
        raise ValueError(f'"worse" of {name} is neither "above" nor "below"')
    limits = tuple(
        Limit(
            Severity(limit["severity"]),
            float(limit["times"]),
            str(limit["of"]),
            str(limit.get("sentence", entry["sentence"])),  # a hint may be said more mildly
        )
        for limit in entry["limits"]
    )
    return Rule(
        name,
        str(entry["title"]),
        str(entry["measure"]),
        entry["worse"] == "above",
        limits,
        tuple(str(source) for source in entry["sources"]),
    )
