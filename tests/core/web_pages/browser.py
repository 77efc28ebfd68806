# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real browser without a window, which opens pages from files: Chromium, spoken to through a pipe.

https://chromedevtools.github.io/devtools-protocol: JSON messages that end with a zero byte.
"""

from __future__ import annotations

import base64
import fcntl
import io
import itertools
import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.image import imread

PROGRAM = shutil.which("chromium-headless-shell")
_OPTIONS = ("--no-sandbox", "--remote-debugging-pipe", "--hide-scrollbars", "--disable-dev-shm-usage",
            "--disable-gpu-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")  # fmt: skip
_WIDE, _TALL = 640, 560


class Browser:
    """A page of the browser; what it asked of networks and what its scripts complained of is kept."""

    def __init__(self, folder: Path) -> None:
        assert PROGRAM is not None
        theirs_in, ours_out = os.pipe()
        ours_in, theirs_out = os.pipe()
        theirs = [fcntl.fcntl(each, fcntl.F_DUPFD, 10) for each in (theirs_in, theirs_out)]
        os.close(theirs_in)
        os.close(theirs_out)
        command = [PROGRAM, *_OPTIONS, f"--user-data-dir={folder}", f"--window-size={_WIDE},{_TALL}"]
        # it reads from 3 and writes to 4
        wrapped = ["bash", "-c", f'exec "$@" 3<&{theirs[0]} 4>&{theirs[1]}', "bash", *command, "about:blank"]
        quiet = subprocess.DEVNULL
        self._process = subprocess.Popen(wrapped, pass_fds=theirs, stdin=quiet, stdout=quiet, stderr=quiet)
        for each in theirs:
            os.close(each)
        self._out, self._in = os.fdopen(ours_out, "wb"), os.fdopen(ours_in, "rb")
        self._rest, self._count, self._session = b"", itertools.count(1), None
        self.asked: list[str] = []
        self.complaints: list[str] = []
        page = self.call("Target.createTarget", url="about:blank", width=_WIDE, height=_TALL)["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """What the browser answers."""
        number = next(self._count)
        message = {"id": number, "method": method, "params": parameters}
        message |= {} if self._session is None else {"sessionId": self._session}
        self._out.write(json.dumps(message).encode() + b"\0")
        self._out.flush()
        while (answer := self._next()).get("id") != number:
            self._take_note(answer)
        assert "error" not in answer, answer
        return dict(answer["result"])

    def open(self, path: Path) -> None:
        """Open a page from its file and wait until all of it is drawn."""
        self.open_without_scripts(path)
        self.settle()

    def open_without_scripts(self, path: Path) -> None:
        """Open a page from its file and wait until all of it has come."""
        self.asked.clear()
        self.complaints.clear()
        self.call("Page.navigate", url=path.as_uri())
        while (answer := self._next()).get("method") != "Page.loadEventFired":
            self._take_note(answer)

    def settle(self) -> None:
        """Two pictures later, what was asked for is drawn."""
        self.run(
            "new Promise((done) =>"
            " requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50))))"
        )

    def run(self, script: str) -> Any:
        """The value of an expression in the page; a promise is waited for."""
        ran = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in ran, ran
        return ran["result"].get("value")

    def picture(self, *box: float) -> np.ndarray:
        """Pixels (h, w, 3) of the window, or of a box in it: left, top, width, height; what is in sight."""
        clip = {"clip": dict(zip(("x", "y", "width", "height"), box)) | {"scale": 1}} if box else {}
        data = self.call("Page.captureScreenshot", format="png", **clip)["data"]
        return np.rint(255 * imread(io.BytesIO(base64.b64decode(data)))[..., :3]).astype(int)

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """With the left button of the mouse."""
        self._mouse("mouseMoved", start)
        self._mouse("mousePressed", start, button="left", buttons=1, clickCount=1)
        for share in (0.3, 0.7, 1.0):
            at = tuple(a + share * (b - a) for a, b in zip(start, end))
            self._mouse("mouseMoved", at, button="left", buttons=1)
        self._mouse("mouseReleased", end, button="left", clickCount=1)
        self.settle()

    def wheel(self, at: tuple[float, float], down: float) -> None:
        """Turn the mouse's wheel."""
        self._mouse("mouseWheel", at, deltaX=0, deltaY=down)
        self.settle()

    def key(self, name: str) -> None:
        """Press a key."""
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name)
        self.settle()

    def _mouse(self, kind: str, at: tuple[float, ...], **more: Any) -> None:
        self.call("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], **more)

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            read = os.read(self._in.fileno(), 1 << 20)
            assert read, "the browser has ended"
            self._rest += read
        message, _, self._rest = self._rest.partition(b"\0")
        return dict(json.loads(message))

    def _take_note(self, event: dict[str, Any]) -> None:
        name, told = event.get("method"), event.get("params", {})
        if name == "Network.requestWillBeSent":
            self.asked.append(told["request"]["url"][:60])
        elif name == "Runtime.exceptionThrown":
            self.complaints.append(str(told["exceptionDetails"]))
        elif name == "Log.entryAdded":
            self.complaints.append(told["entry"]["text"])

    def close(self) -> None:
        """End the browser."""
        self._process.kill()
        self._process.wait()
        self._out.close()
        self._in.close()
