# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where long work asks whether it is still wanted, without handing a progress through every function."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from BalloonWorkbench.core.errors import Cancelled
from BalloonWorkbench.core.types import Progress, no_progress

_progress: ContextVar[Progress] = ContextVar("progress", default=no_progress)  # each thread has its own


@contextmanager
def stoppable(progress: Progress) -> Iterator[None]:
    """Let every checkpoint of the work inside ask this progress."""
    before = _progress.set(progress)
    try:
        yield
    finally:
        _progress.reset(before)


def checkpoint(fraction: float = 0.0) -> None:
    """Raise Cancelled when the progress of the work around says stop."""
    if not _progress.get()(fraction, ""):
        raise Cancelled("Stopped.")
