# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of one process have worked out stays known, by the exact value of the request.

A test that looks at the work itself, how it is stopped, shown or counted, is marked `works_out`, and one that
puts something in the place of our code asks for `monkeypatch`. To those nothing is known, and nothing of
theirs is kept. What only stands in for an answer of the user is put there by `stand_in`.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from inspect import signature

import pytest

from BalloonWorkbench.core import memoize

_MOST = 2000  # results of each kind


@contextmanager
def remembered(item: pytest.Function) -> Iterator[None]:
    """All that tests before have worked out, or nothing for one that works everything out."""
    for memory in memoize._memories:
        memory._most = _MOST
    if not _works_out(item):
        yield
        return
    kept = [(memory, dict(memory._results)) for memory in memoize._memories]
    memoize.forget()
    yield
    memoize.forget()
    for memory, results in kept:
        memory._results.update(results)


def _works_out(item: pytest.Function) -> bool:
    own = signature(item.function).parameters
    return "monkeypatch" in own or item.get_closest_marker("works_out") is not None
