# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the measurements ran on, and how busy that was."""

from __future__ import annotations

import os
import platform
from pathlib import Path
from typing import Any

import numpy as np


def description() -> dict[str, Any]:
    """Processor, number of threads and versions."""
    import scipy

    return {
        "processor": _processor(),
        "threads": os.cpu_count(),
        "system": platform.platform(),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "scipy": scipy.__version__,
    }


def load() -> float:
    """Processes that wanted a processor, on average over the last minute."""
    return os.getloadavg()[0]


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


class PeakMemory:
    """Growth of this process's resident memory to its peak, in bytes, from a start that can be set anew.

    Linux only: elsewhere growth is None.
    """

    def __init__(self) -> None:
        self._before = 0
        self.restart()

    def restart(self) -> None:
        """Forget the peak so far."""
        try:
            Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
        except OSError:
            return
        self._before = _status("VmRSS") or 0

    @property
    def growth(self) -> int | None:
        """Bytes from the start to the peak."""
        peak = _status("VmHWM")
        return None if peak is None else max(0, peak - self._before)


def _status(name: str) -> int | None:
    status = Path("/proc/self/status")
    if not status.is_file():
        return None
    for line in status.read_text(encoding="ascii").splitlines():
        if line.startswith(name + ":"):
            return 1024 * int(line.split()[1])
    return None
