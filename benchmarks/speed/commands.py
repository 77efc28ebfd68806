# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole commands, each in a process of its own, with what it starts, in processor time and in yardsticks."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from speed import cases, machine
from speed.worker import summary, timed

from BalloonWorkbench.core.solver.inflate import inflate

_ROOT = Path(__file__).resolve().parents[2]
_EXAMPLES = _ROOT / "resources" / "examples"
_FISH = ("design", str(_EXAMPLES / "pictures" / "fish.png"), "--width", "300mm")
_WITHOUT_LOOKS = ("--only", "report", "--only", "pattern", "--only", "balloon")
#: What is run, by what the page calls it, and the aim in seconds of an idle processor.
COMMANDS: dict[str, tuple[tuple[str, ...], float | None]] = {
    "fish, all files": (_FISH, 2.0),
    "fish, without preview and document": ((*_FISH, *_WITHOUT_LOOKS), 1.2),
    "fish, report alone": ((*_FISH, "--only", "report"), 0.5),
    "line-fish, all files": (
        ("design", str(_EXAMPLES / "pictures" / "line-fish.png"), "--width", "300mm"),
        None,
    ),
    "airship of 8 gores, all files": (
        ("design", str(_EXAMPLES / "profiles" / "airship.json"), "--gores", "8"),
        None,
    ),
    "cube, all files": (("inflate", str(_EXAMPLES / "bags" / "cube.json")), None),
}
_REPEATS = 3


def measure(folder: Path) -> list[dict[str, Any]]:
    """Of each command the processor time and its number of yardsticks, the median of some runs.

    The yardstick is one cold inflation of the disc with 2 000 vertices, right before and after.
    """
    return [
        {"command": name, "aim": aim, **_measured(arguments, folder)}
        for name, (arguments, aim) in COMMANDS.items()
    ]


def loading() -> float:
    """Processor time to load the command line [s], with Python and NumPy."""
    return min(
        _seconds([sys.executable, "-c", "import BalloonWorkbench.cli.command_line"]) for _ in range(_REPEATS)
    )


def _measured(arguments: tuple[str, ...], folder: Path) -> dict[str, Any]:
    command = [sys.executable, "-m", "BalloonWorkbench", *arguments, "--out", str(folder / "command")]
    times, shares = [], []
    for _ in range(_REPEATS):
        before, used, after = _yardstick(), _seconds(command), _yardstick()
        times.append((used, used))
        shares.append(2.0 * used / (before + after))
    return {**summary(times), "yardsticks": sorted(shares)[len(shares) // 2], "load": machine.load()}


def _yardstick() -> float:
    panel, film = cases.panel("disc", 2000), cases.sealed_film()
    return float(timed(lambda: inflate(panel, film, cases.PRESSURE))[1][0])


def _seconds(command: list[str]) -> float:
    """Processor time of a command, and of the processes that it waits for."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    started = subprocess.Popen(command, cwd=_ROOT, env=environment, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(started.pid, 0)
    started.returncode = os.waitstatus_to_exitcode(status)
    if started.returncode:
        raise RuntimeError(f"{command} ended with {started.returncode}.")
    return used.ru_utime + used.ru_stime
