# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse of the X server itself: what it does reaches FreeCAD as from a hand, through the server's queue.

Speaks the X protocol over the server's socket ("X Window System Protocol", X11R7; XTEST 2.2, FakeInput).
"""

import os
import socket
import struct
from pathlib import Path

_PRESS, _RELEASE, _MOVE = 4, 5, 6  # kinds of events
_LEFT = 1
_QUERY_EXTENSION, _FAKE_INPUT = 98, 2  # requests


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
        self._read(4 * length)
        assert accepted == 1, "the X server accepts no connection"
        extension = b"XTEST"
        request = struct.pack("<BxHHxx", _QUERY_EXTENSION, 4, len(extension))
        self._socket.sendall(request + _padded(extension))
        there, self._xtest = struct.unpack("<xxxxxxxxBB22x", self._read(32))
        assert there, "the X server has no XTEST"

    def move(self, x, y):
        """To a pixel of the screen."""
        self._fake(_MOVE, 0, x, y)

    def press(self):
        self._fake(_PRESS, _LEFT)

    def release(self):
        self._fake(_RELEASE, _LEFT)

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
