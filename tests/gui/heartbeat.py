# SPDX-License-Identifier: LGPL-2.1-or-later
"""A timer that beats in the window: how long it was deaf, and how much of that was our own work."""

import os
import time

import hands

from BalloonWorkbench.gui.paint.preview import preload

#: s in which the window does not answer that a test takes for a freeze. The aim is 0.1 s; what is reached is
#: measured on a quiet machine (docs/benchmarks.md), since a test beside others cannot tell it.
LIMIT = 0.3
_SUM = 4000  # numbers that are added up to see how fast the processor is just now
_SLOWEST = 3.0


class Heartbeat:
    """Beats every few milliseconds.

    longest  s by the clock between two beats: other programs of a busy machine are in it
    work     s of the processor that the window's own thread worked between two beats, at most but for one
    most     that one: the first pictures of a new 3D view take longer where no graphics card draws them
    own      s between two beats, or what this process with all its threads can account for: a window that
             waits for a thread of ours is deaf by our doing. All beats but one in a hundred

    A processor that others use as well does less in a second: work and own are what it takes while a small
    sum takes as long as when it was quickest.
    """

    _quickest = 1.0

    def __init__(self):
        hands.wait_until(lambda: not preload._missing)  # what loads while the window has nothing else to do
        self._timer = hands.QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)
        self.reset()

    def reset(self):
        self.longest = 0.0
        self._works, self._owns = [0.0, 0.0, 0.0], [0.0]
        self.skip()

    def skip(self):
        """What the test itself did since the last beat, such as saving a picture, does not count."""
        self._last = self._now()

    def stop(self):
        self._timer.stop()

    @property
    def work(self):
        return sorted(self._works)[-2]

    @property
    def most(self):
        return max(self._works)

    def answers(self, new_view=False):
        """The window has answered all the time, but for the first two pictures of a new view."""
        if new_view:
            return max(sorted(self._works)[-3], self.own) < LIMIT
        return max(self.work, self.own, 0.5 * self.most) < LIMIT

    @property
    def own(self):
        return sorted(self._owns)[int(0.99 * (len(self._owns) - 1))]

    @staticmethod
    def _now():
        return time.perf_counter(), time.thread_time(), time.process_time()

    def _beat(self):
        clock, mine, everybody = (b - a for a, b in zip(self._last, self._now(), strict=True))
        slowness = self._slowness()
        self.longest = max(self.longest, clock)
        self._works.append(mine / slowness)
        self._owns.append(min(clock, everybody / (os.cpu_count() or 1)) / slowness)
        self._last = self._now()

    @classmethod
    def _slowness(cls):
        begun = time.thread_time()
        sum(range(_SUM))
        taken = time.thread_time() - begun
        cls._quickest = min(cls._quickest, taken)
        return min(taken / cls._quickest, _SLOWEST)
