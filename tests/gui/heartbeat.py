# SPDX-License-Identifier: LGPL-2.1-or-later
"""A timer that beats in the window: how long it was deaf, and how much of that was our own work."""

import os
import time

import hands


class Heartbeat:
    """Beats every few milliseconds.

    longest  s by the clock between two beats: other programs of a busy machine are in it
    gui      s of the processor that the window's own thread worked between two beats; `most` at the worst
    own      s between two beats, or what this process with all its threads can account for: a window that
             waits for a thread of ours is deaf by our doing

    gui and own are of all beats but one in a hundred: without a graphics card the 3D view is slow at times.
    """

    def __init__(self):
        self._timer = hands.QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)
        self.reset()

    def reset(self):
        self.longest = 0.0
        self._works, self._owns = [0.0], [0.0]
        self._last = self._now()

    def skip(self):
        """What the test itself did since the last beat, such as saving a picture, does not count."""
        self._last = self._now()

    def stop(self):
        self._timer.stop()

    @property
    def gui(self):
        return _nearly_all(self._works)

    @property
    def own(self):
        return _nearly_all(self._owns)

    @property
    def most(self):
        return max(self._works)

    @staticmethod
    def _now():
        return time.perf_counter(), time.thread_time(), time.process_time()

    def _beat(self):
        now = self._now()
        clock, mine, everybody = (b - a for a, b in zip(self._last, now, strict=True))
        self.longest = max(self.longest, clock)
        self._works.append(mine)
        self._owns.append(min(clock, everybody / (os.cpu_count() or 1)))
        self._last = now


def _nearly_all(values):
    return sorted(values)[int(0.99 * (len(values) - 1))]
