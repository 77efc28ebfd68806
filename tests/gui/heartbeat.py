# SPDX-License-Identifier: LGPL-2.1-or-later
"""A timer that beats in the window: how long it was deaf, and how much of that was our own work."""

import os
import time

import hands


class Heartbeat:
    """Beats every few milliseconds.

    longest  s by the clock between two beats: other programs of a busy machine are in it
    gui      s of the processor that the window's own thread worked between two beats
    own      s between two beats, or what this process with all its threads can account for: a window that
             waits for a thread of ours is deaf by our doing. Of all beats but one in a hundred: the 3D view
             without a graphics card draws slowly at times.
    """

    def __init__(self):
        self._timer = hands.QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)
        self.reset()

    def reset(self):
        self.longest = self.gui = 0.0
        self._owns = [0.0]
        self._last = self._now()

    def skip(self):
        """What the test itself did since the last beat, such as saving a picture, does not count."""
        self._last = self._now()

    def stop(self):
        self._timer.stop()

    @property
    def own(self):
        return sorted(self._owns)[int(0.99 * (len(self._owns) - 1))]

    @staticmethod
    def _now():
        return time.perf_counter(), time.thread_time(), time.process_time()

    def _beat(self):
        now = self._now()
        clock, mine, everybody = (b - a for a, b in zip(self._last, now, strict=True))
        self.longest, self.gui = max(self.longest, clock), max(self.gui, mine)
        self._owns.append(min(clock, everybody / (os.cpu_count() or 1)))
        self._last = now
