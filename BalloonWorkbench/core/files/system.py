# SPDX-License-Identifier: LGPL-2.1-or-later
"""What writing a set of files asks of the system: exchange of folders, a lock, signals that wait."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

from BalloonWorkbench.core.packages import lacks_ctypes

PATIENCE = 60.0  # s, for another run that writes beside us
_POLL = 0.02  # s
_AT_FDCWD, _RENAME_EXCHANGE = -100, 2  # linux/fcntl.h, linux/fs.h
_RENAME_SWAP = 2  # sys/stdio.h of macOS
_SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")


def exchange(one: Path, other: Path) -> bool:
    """Exchange two folders in one step; False, and nothing has changed, where system or disk cannot."""
    if lacks_ctypes():
        return False
    import ctypes

    first, second = os.fsencode(one), os.fsencode(other)
    try:
        library = ctypes.CDLL(None, use_errno=True)
        if sys.platform == "darwin":
            return bool(library.renamex_np(first, second, ctypes.c_uint(_RENAME_SWAP)) == 0)
        here = ctypes.c_int(_AT_FDCWD)
        return bool(library.renameat2(here, first, here, second, ctypes.c_uint(_RENAME_EXCHANGE)) == 0)
    except (OSError, AttributeError, TypeError):  # TypeError: Windows has no library of all libraries
        return False


def keep_on_disk(folder: Path) -> None:
    """Have the entries of a folder outlive a power failure, where the system can do that."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


@contextlib.contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Keep other runs out that lock the same folder; they wait. No lock where the system has none.

    Nothing of it remains when a run is killed. Raises TimeoutError when another one takes too long.
    """
    try:
        import fcntl

        handle = os.open(folder, os.O_RDONLY)
    except (ImportError, OSError):  # Windows; a folder that may be entered but not listed
        yield
        return
    try:
        until = time.monotonic() + PATIENCE
        while True:
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > until:
                    raise TimeoutError("another run has been writing there for a minute") from None
                time.sleep(_POLL)
            except OSError:  # some network disks
                break
        yield
    finally:
        os.close(handle)


@contextlib.contextmanager
def signals_wait() -> Iterator[None]:
    """Ctrl-C and the signals that end a program take effect at the end; only in the main thread, where
    Python handles them.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    arrived: list[int] = []
    former = {}
    try:
        for name in _SIGNALS:
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) not in (None, signal.SIG_IGN):
                former[number] = signal.signal(number, lambda got, _frame: arrived.append(got))
        yield
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)
        for got in arrived[:1]:
            signal.raise_signal(got)
