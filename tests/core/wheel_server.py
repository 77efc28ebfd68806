# SPDX-License-Identifier: LGPL-2.1-or-later
"""A release on a server of our own, with all that goes wrong on the way from one."""

from __future__ import annotations

import hashlib
import http.server
import importlib
import json
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from BalloonWorkbench import __version__
from BalloonWorkbench.core.solver.native import library, load

ROOT = Path(__file__).resolve().parents[2]
NAME = "the.whl"


def wheel_of(content: Path) -> bytes:
    """The wheel that the release would make of a library."""
    sys.path.insert(0, str(ROOT / "tools"))
    try:
        release = importlib.import_module("release")
    finally:
        sys.path.remove(str(ROOT / "tools"))
    made = release.wheel(content, "any", __version__, (2026, 1, 1))
    assert isinstance(made, bytes)
    return made


def wheel_list(path: Path, address: str, wheel: bytes) -> Path:
    """A list of wheels as it comes with the source, for this platform."""
    entry = {"file": NAME, "size": len(wheel), "sha256": hashlib.sha256(wheel).hexdigest()}
    listed = {
        "version": __version__,
        "interface": load.ABI_VERSION,
        "address": address,
        "wheels": {library.platform_name(): entry},
    }
    path.write_text(json.dumps(listed), encoding="utf-8")
    return path


class Answer(http.server.BaseHTTPRequestHandler):
    """One answer to a request; which one is the server's."""

    def do_GET(self) -> None:
        self.server.answers[self.server.fault](self, self.server.wheel)  # type: ignore[attr-defined]

    def log_message(self, format: str, *values: object) -> None: ...

    def send(self, content: bytes, *, code: int = 200, length: int | None = None) -> None:
        self.send_response(code)
        self.send_header("Content-Length", str(len(content) if length is None else length))
        self.end_headers()
        self.wfile.write(content)


def _endless(answer: Answer, wheel: bytes) -> None:
    answer.send_response(200)
    answer.end_headers()
    try:
        for _ in range(1000):
            answer.wfile.write(wheel)
    except OSError:  # who asked has gone
        return


def _loop(answer: Answer, wheel: bytes) -> None:
    answer.send_response(302)
    answer.send_header("Location", answer.path)
    answer.end_headers()


def _silence(answer: Answer, wheel: bytes) -> None:
    time.sleep(1.0)


def _something(answer: Answer, wheel: bytes) -> None:
    answer.wfile.write(b"\x16\x03\x01 hello\r\n\r\n")


def _torn(answer: Answer, wheel: bytes) -> None:
    answer.send_response(200)
    answer.send_header("Transfer-Encoding", "chunked")
    answer.end_headers()
    answer.wfile.write(b"10000\r\n" + wheel[:1000])


def _drip(answer: Answer, wheel: bytes) -> None:
    answer.send(wheel[:100], length=len(wheel))
    time.sleep(1.0)


#: By name: what is sent, and what the user reads of it.
FAULTS: dict[str, tuple[Callable[[Answer, bytes], None], str]] = {
    "not there": (lambda answer, wheel: answer.send(b"", code=404), "(answer 404)"),
    "server broken": (lambda answer, wheel: answer.send(wheel, code=503), "(answer 503)"),
    "may not": (lambda answer, wheel: answer.send(b"<html>", code=407), "(answer 407)"),
    "web page": (lambda answer, wheel: answer.send(b"\n<!DOCTYPE html><p>Sign in"), "web page"),
    "long web page": (lambda answer, wheel: answer.send(b"<p>" * len(wheel)), "web page"),
    "nothing": (lambda answer, wheel: answer.send(b""), "ended before"),
    "half": (lambda answer, wheel: answer.send(wheel[: len(wheel) // 2]), "ended before"),
    "cut off": (lambda answer, wheel: answer.send(wheel[:-1], length=len(wheel)), "ended before"),
    "another byte": (lambda answer, wheel: answer.send(wheel[:-1] + b"!"), "SHA-256 is another"),
    "one byte more": (lambda answer, wheel: answer.send(wheel + b"!"), "SHA-256 is another"),
    "endless": (_endless, "SHA-256 is another"),
    "in a circle": (_loop, "(answer 302)"),
    "no HTTP": (_something, "the answer is not HTTP"),
    "torn in a part": (_torn, "ended"),
    "silence": (_silence, "the connection timed out"),
    "stuck": (_drip, "the connection timed out"),
}


@contextmanager
def server(wheel: bytes, fault: str = "") -> Iterator[str]:
    """The address of a folder with the wheel, where asking for it ends in one of FAULTS."""
    answers = {name: answer for name, (answer, _) in FAULTS.items()}
    answers[""] = lambda answer, wheel: answer.send(wheel)
    running = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Answer)
    running.daemon_threads = True
    running.wheel, running.fault, running.answers = wheel, fault, answers  # type: ignore[attr-defined]
    thread = threading.Thread(target=running.serve_forever, args=(0.02,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{running.server_address[1]}/releases"
    finally:
        running.shutdown()
        running.server_close()
