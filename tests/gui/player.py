# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hand that draws by itself: strokes with the X server's mouse from a process of its own, at its own pace
whatever the window is doing. `python3 player.py` plays what it reads, a stroke a line.
"""

import json
import select
import subprocess
import sys
import time


class Player:
    """Plays strokes beside the window.

    pressed, released  when the button went down and came up in the last one [s of time.monotonic()]
    """

    def __init__(self):
        self.pressed = self.released = 0.0
        self._process = subprocess.Popen(
            ["/usr/bin/python3", __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def play(self, places, seconds):
        """Draw through places (x, y) px of the screen within some time; comes back at once."""
        places = [(round(x), round(y)) for x, y in places]
        self._process.stdin.write(json.dumps({"places": places, "seconds": seconds}) + "\n")
        self._process.stdin.flush()

    def has_played(self):
        """The stroke is over; ask once more than that it becomes so, not oftener."""
        if not select.select([self._process.stdout], [], [], 0.0)[0]:
            return False
        self.pressed, self.released = json.loads(self._process.stdout.readline())
        return True

    def close(self):
        self._process.stdin.close()
        self._process.wait(10)


def _play(pointer, places, seconds):
    """One stroke; the times of press and release."""
    pointer.move(*places[0])
    time.sleep(0.02)
    pressed = time.monotonic()
    pointer.press()
    for number, place in enumerate(places, 1):
        time.sleep(max(0.0, pressed + seconds * number / len(places) - time.monotonic()))
        pointer.move(*place)
    released = time.monotonic()
    pointer.release()
    return pressed, released


def _main():
    from pointer import Pointer

    pointer = Pointer()
    for line in sys.stdin:
        stroke = json.loads(line)
        sys.stdout.write(json.dumps(_play(pointer, stroke["places"], stroke["seconds"])) + "\n")
        sys.stdout.flush()
    pointer.close()


if __name__ == "__main__":
    _main()
