# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse and the keyboard of the X server itself: what they do reaches FreeCAD as from a hand, through the
server's queue.

Speaks the X protocol over the server's socket ("X Window System Protocol", X11R7; XTEST 2.2, FakeInput).
"""

import os
import socket
import struct
from pathlib import Path

_KEY_PRESS, _KEY_RELEASE, _PRESS, _RELEASE, _MOVE = 2, 3, 4, 5, 6  # kinds of events
LEFT, MIDDLE, RIGHT, WHEEL_UP, WHEEL_DOWN = 1, 2, 3, 4, 5
_QUERY_EXTENSION, _KEYBOARD_MAPPING, _FAKE_INPUT = 98, 101, 2  # requests
#: Names of keys that are no letters, and their numbers ("keysyms").
_KEYS = {
    "Return": 0xFF0D,
    "Escape": 0xFF1B,
    "Tab": 0xFF09,
    "BackSpace": 0xFF08,
    "Delete": 0xFFFF,
    "Home": 0xFF50,
    "End": 0xFF57,
    "Up": 0xFF52,
    "Down": 0xFF54,
    "Shift": 0xFFE1,
    "Ctrl": 0xFFE3,
    "Alt": 0xFFE9,
}


class Pointer:
    """A connection to the server of this display."""

    def __init__(self):
        number = os.environ["DISPLAY"].rpartition(":")[2].partition(".")[0]
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.connect(f"/tmp/.X11-unix/X{number}")
        name, key = _cookie(number.encode())
        self._socket.sendall(
            struct.pack("<BxHHHHxx", ord("l"), 11, 0, len(name), len(key)) + _padded(name) + _padded(key)
        )
        accepted, length = struct.unpack("<BxxxxxH", self._read(8))
        screen = self._read(4 * length)
        assert accepted == 1, "the X server accepts no connection"
        extension = b"XTEST"
        request = struct.pack("<BxHHxx", _QUERY_EXTENSION, 4, len(extension))
        self._socket.sendall(request + _padded(extension))
        there, self._xtest = struct.unpack("<xxxxxxxxBB22x", self._read(32))
        assert there, "the X server has no XTEST"
        self._keys = self._keyboard(*screen[26:28])

    def move(self, x, y):
        """To a pixel of the screen."""
        self._fake(_MOVE, 0, x, y)

    def press(self, button=LEFT):
        self._fake(_PRESS, button)

    def release(self, button=LEFT):
        self._fake(_RELEASE, button)

    def key(self, *names):
        """Keys that are pressed together, such as "Ctrl", "z"; signs are where a keyboard has them."""
        held = []
        for name in names:
            code, shifted = self._keys[_KEYS.get(name) or ord(name)]
            if shifted:
                held.append(self._keys[_KEYS["Shift"]][0])
            held.append(code)
        for kind, codes in ((_KEY_PRESS, held), (_KEY_RELEASE, reversed(held))):
            for code in codes:
                self._fake(kind, code)

    def _keyboard(self, first, last):
        """Code of the key, and whether Shift is held, for each sign of the server's keyboard."""
        self._socket.sendall(struct.pack("<BxHBBxx", _KEYBOARD_MAPPING, 2, first, last - first + 1))
        each, length = struct.unpack("<xBxxI24x", self._read(32))
        signs = struct.unpack(f"<{length}I", self._read(4 * length))
        keys = {}
        for place, sign in enumerate(signs):
            code, level = first + place // each, place % each
            if sign and level < 2:
                keys.setdefault(sign, (code, level == 1))
        return keys

    def close(self):
        self._socket.close()

    def _fake(self, kind, detail, x=0, y=0):
        self._socket.sendall(
            struct.pack("<BBHBBxxII8xhh8x", self._xtest, _FAKE_INPUT, 9, kind, detail, 0, 0, int(x), int(y))
        )

    def _read(self, count):
        found = b""
        while len(found) < count:
            part = self._socket.recv(count - len(found))
            assert part, "the X server has closed the connection"
            found += part
        return found


def _cookie(number):
    """Name and content of what lets us in: the entry for this display in the file of xauth."""
    content, place = Path(os.environ["XAUTHORITY"]).read_bytes(), 0
    while place < len(content):
        place += 2
        fields = []
        for _ in range(4):
            (length,) = struct.unpack_from(">H", content, place)
            fields.append(content[place + 2 : place + 2 + length])
            place += 2 + length
        if fields[1] in (number, b""):
            return fields[2], fields[3]
    return b"", b""


def _padded(text):
    return text + b"\0" * (-len(text) % 4)
