# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reading one drawing may take, whatever is in it."""

from __future__ import annotations

import math
import time

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.units import number_text

#: Points of all lines of a drawing, curves flattened.
MOST_POINTS = 200_000
#: Things in a drawing, those in its blocks and copies counted each time, also those that show nothing.
MOST_ELEMENTS = 100_000
#: Nested groups, blocks and copies.
MOST_LEVELS = 200
#: Processor time of the thread that reads [s].
SECONDS = 8.0
_PAUSE = 0.02  # s between two looks at the processor's clock, which are slow on some machines


class Budget:
    """Points, elements and processor time that are left for one drawing, spent while it is read and checked.

    InputError past any of them; the text says of what there is too much.
    """

    def __init__(self, seconds: float = SECONDS) -> None:
        self._seconds = seconds
        self._began, self._looked = time.thread_time(), time.perf_counter()
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
            raise InputError(
                f"The drawing has more than {MOST_POINTS} points. Simplify it in the program it comes from, "
                "or leave only the outline and its holes in it."
            )

    def spend_elements(self, count: float = 1) -> None:
        """Take so many elements more."""
        self._elements += count
        self.check_time()
        if count == math.inf:
            raise InputError("The drawing has blocks or copies that show themselves. Remove those from it.")
        if not self._elements <= MOST_ELEMENTS:
            raise InputError(
                f"The drawing has more than {MOST_ELEMENTS} elements, with those of its blocks and copies. "
                "Leave only the outline and its holes in it."
            )

    def check_level(self, level: int) -> None:
        """Refuse groups, blocks or copies nested deeper than any program nests them."""
        if level > MOST_LEVELS:
            raise InputError(
                f"The drawing has more than {MOST_LEVELS} groups or blocks inside each other. "
                "Take them apart in the program it comes from."
            )

    def check_time(self, share: float = 1.0) -> None:
        """Refuse the drawing once its processor time is used up, or a share of it by the first steps."""
        now = time.perf_counter()
        if now - self._looked < _PAUSE:
            return
        self._looked = now
        if time.thread_time() - self._began > share * self._seconds:
            raise InputError(
                f"The drawing takes more than {number_text(self._seconds)} s to read. Simplify it in the"
                " program it "
                "comes from, or leave only the outline and its holes in it."
            )
