# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the window plugs in: the document objects run without it, and it replaces these when it is there."""

from __future__ import annotations

from contextlib import contextmanager


def dress(obj) -> None:
    """Give a document object its view provider; without a window there is none."""


@contextmanager
def progress(title: str):
    """Yield a progress callback for work that happens inside a recompute; without a window it is silent."""
    from BalloonWorkbench.core.types import no_progress

    yield no_progress
