# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts how often the work of the engine is done: what its memory answers is no work."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from typing import Any

import pytest

from BalloonWorkbench.core import job
from BalloonWorkbench.core.correction import fit
from BalloonWorkbench.core.pattern import build
from BalloonWorkbench.core.reports import report
from BalloonWorkbench.core.tracing import picture

_USERS = [job]  # loaded before anything is watched: they keep what they import
_WORK = {
    "trace": [(picture, "placed_drawing")],
    "design": [(fit, "fit"), (fit, "inflate_outline")],
    "pattern": [(build, "build_pattern")],
    "report": [(report, "build")],
}


def _is_quick(work: Any, given: tuple[Any, ...], named: dict[str, Any]) -> bool:
    """A quick preview, whose picture and pattern are others, however its arguments are passed."""
    values = signature(work).bind(*given, **named).arguments
    return values.get("fair") is False or values.get("step") == 0.0


@contextmanager
def counted() -> Iterator[Counter[str]]:
    """How often a drawing was traced, a balloon designed, a pattern made, a report written."""
    done: Counter[str] = Counter()

    def watched(name: str, work: Any) -> Any:
        @wraps(work)
        def count(*given: Any, **named: Any) -> Any:
            if not _is_quick(work, given, named):
                done[name] += 1
            return work(*given, **named)

        return count

    with pytest.MonkeyPatch.context() as patch:
        for name, functions in _WORK.items():
            for module, function in functions:
                work = getattr(module, function)
                if hasattr(work, "_function"):
                    patch.setattr(work, "_function", watched(name, work._function))
                    continue
                for user in list(sys.modules.values()):
                    ours = getattr(user, "__name__", "").startswith("BalloonWorkbench.")
                    if ours and vars(user).get(function) is work:
                        patch.setattr(user, function, watched(name, work))
        yield done
