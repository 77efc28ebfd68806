# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the command line tells what it does, and who may end it; none of that may cost a file."""

from __future__ import annotations

import logging
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO

UNSHOWN = 74  # exit code: what was done cannot be shown


class Ended(BaseException):
    """A signal asks the program to end: SIGTERM, or SIGHUP when its terminal is closed."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number

    def end(self) -> int:
        """End as the signal does; the usual exit code of that where it does not."""
        signal.signal(self.number, signal.SIG_DFL)
        signal.raise_signal(self.number)
        return 128 + self.number


@contextmanager
def signals_are_errors() -> Iterator[None]:
    """Signals that end a program raise Ended, so that it can tidy up."""

    def end(number: int, _frame: Any) -> None:
        raise Ended(number)

    former = {}
    if threading.current_thread() is threading.main_thread():
        for name in ("SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) is signal.SIG_DFL:
                former[number] = signal.signal(number, end)
    try:
        yield
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)


def quiet() -> None:
    """Letters that the terminal does not know are shown as their codes; packages keep their remarks."""
    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # on a home folder that it cannot write to
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def show(text: str) -> OSError | None:
    """Write to where the output goes; why that failed, or None. That nobody reads it is no failure."""
    if sys.stdout is None:
        return None
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        _forget(sys.stdout)
        return None if isinstance(error, BrokenPipeError) else error
    return None


def readable(name: str) -> str:
    """The name of a file with a sign for each byte that is no letter: for titles and labels."""
    return os.fsencode(name).decode("utf-8", "replace")


def complain(text: object) -> None:
    """One line on stderr, where there is one."""
    if sys.stderr is None:
        return
    try:
        sys.stderr.write(f"balloon: {' '.join(str(text).split())}\n")
        sys.stderr.flush()
    except OSError:
        _forget(sys.stderr)


def _forget(stream: TextIO) -> None:
    """What a stream still holds goes nowhere: Python would try again at its end, and complain."""
    with suppress(OSError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


class StatusLine:
    """Progress on a terminal: one line that is written over; nothing elsewhere."""

    def __init__(self, stream: TextIO | None) -> None:
        self._stream = stream if stream is not None and stream.isatty() else None

    def show(self, fraction: float, text: str) -> bool:
        """Show the progress; never asks to stop."""
        self._write(f"\r\033[K{round(100.0 * fraction):3d} %  {text}")
        return True

    def clear(self) -> None:
        """Leave an empty line behind."""
        self._write("\r\033[K")

    def _write(self, text: str) -> None:
        if self._stream is not None:
            try:
                self._stream.write(text)
                self._stream.flush()
            except OSError:
                _forget(self._stream)
                self._stream = None
