# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reading one drawing may take, whatever is in it."""

from __future__ import annotations

import time

from BalloonWorkbench.core.errors import InputError

#: Points of all lines of a drawing, curves flattened.
MOST_POINTS = 200_000
#: Things in a drawing, those in its blocks and copies counted each time, also those that show nothing.
MOST_ELEMENTS = 100_000
#: Nested groups, blocks and copies.
MOST_LEVELS = 200
#: Processor time of the thread that reads [s].
SECONDS = 7.0

_ADVICE = "Simplify it in the program it comes from, or leave only the outline and its holes in it."


class Budget:
    """Points, elements and processor time that are left for one drawing, spent while it is read and checked.

    InputError past any of them; the text says of what there is too much.
    """

    def __init__(self, seconds: float = SECONDS) -> None:
        self._seconds = seconds
        self._began = time.thread_time()
        self._points = 0.0
        self._elements = 0.0

    def spend_points(self, count: float) -> None:
        """Take so many points more."""
        self._points += count
        self.allow_points(self._points)

    def allow_points(self, count: float) -> None:
        """Whether one piece of a drawing has too many points, before they are made."""
        self.check_time()
        if not count <= MOST_POINTS:
            raise InputError(f"The drawing has more than {MOST_POINTS} points. {_ADVICE}")

    def spend_elements(self, count: float = 1) -> None:
        """Take so many elements more."""
        self._elements += count
        self.check_time()
        if not self._elements <= MOST_ELEMENTS:
            raise InputError(
                f"The drawing has more than {MOST_ELEMENTS} elements, with those of its blocks and copies. "
                f"{_ADVICE}"
            )

    def check_level(self, level: int) -> None:
        """Refuse groups, blocks or copies nested deeper than any program nests them."""
        if level > MOST_LEVELS:
            raise InputError(
                f"The drawing has more than {MOST_LEVELS} groups or blocks inside each other. {_ADVICE}"
            )

    def check_time(self) -> None:
        """Refuse the drawing once its processor time is used up."""
        if time.thread_time() - self._began > self._seconds:
            raise InputError(f"The drawing takes more than {self._seconds:.0f} s to read. {_ADVICE}")
