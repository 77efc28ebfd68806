# SPDX-License-Identifier: LGPL-2.1-or-later
"""A function as what a worker is asked."""

from __future__ import annotations

from collections.abc import Callable

from BalloonWorkbench.core.checkpoint import stoppable


class Call:
    """A function without arguments as a request; when it is stopped, it ends at its next step."""

    def __init__(self, function: Callable):
        self._function = function

    def solve(self, progress):
        """What the function returns."""
        with stoppable(progress):
            return self._function()
