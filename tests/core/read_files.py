# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads files one after the other in a process of its own, and writes down what that took.

As a program: FIRST STOP reads the files of `mutated_files` with these numbers, NAME ... those of `too_much`.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
#: What one file may take: processor time [s] and memory [MB].
SECONDS, MEGABYTES = 10.0, 1024.0


def outcomes(*words: str) -> list[dict[str, Any]]:
    """What the program says: for each file its name, text of the refusal or none, seconds and megabytes."""
    ended = subprocess.run(
        [sys.executable, __file__, *words], capture_output=True, text=True, check=False, cwd=ROOT
    )
    lines = [json.loads(line) for line in ended.stdout.splitlines() if line.startswith("{")]
    begun = [line["begin"] for line in lines if "begin" in line]
    done = [line for line in lines if "name" in line]
    assert ended.returncode == 0, f"ended at {begun[-1:]} ({ended.returncode}): {ended.stderr[-3000:]}"
    return done


def _say(what: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(what) + "\n")
    sys.stdout.flush()


def _peak(reset: bool = False) -> float:
    """Most memory that this process had since the last reset [MB]."""
    if reset:
        Path("/proc/self/clear_refs").write_text("5")
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) / 1024
    raise AssertionError("no peak of memory here")


def _read(name: str, path: Path) -> dict[str, Any]:
    import numpy as np

    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.readers.read import read_drawing

    _say({"begin": name})
    used = resource.getrusage(resource.RUSAGE_SELF)
    limit = int(used.ru_utime + used.ru_stime + 2 * SECONDS) + 1  # past it this process is ended
    resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))
    _peak(reset=True)
    began, refusal, finite = time.process_time(), None, True
    try:
        drawing, _ = read_drawing(path, 0.1)
        finite = max(drawing.size) < 100.1
        finite &= all(np.isfinite(loop).all() for part in drawing.parts for loop in part.loops)
    except BalloonError as error:
        refusal = str(error)
    seconds = time.process_time() - began
    return {
        "name": name,
        "refusal": refusal,
        "finite": bool(finite),
        "seconds": seconds,
        "megabytes": _peak(),
    }


def _cases(words: list[str]) -> Iterator[tuple[str, Callable[[], tuple[str, bytes]]]]:
    """Names, and what makes their files."""
    if words[0].isdigit():
        import mutated_files

        for number in range(int(words[0]), int(words[1])):
            yield str(number), partial(mutated_files.file, number)
    else:
        import too_much

        for name in words:
            yield name, too_much.FILES[name]


def _main(words: list[str]) -> None:
    sys.path[:0] = [str(ROOT), str(Path(__file__).parent)]
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, resource.RLIM_INFINITY))
    with tempfile.TemporaryDirectory() as folder:
        for name, make in _cases(words):
            ending, content = make()
            path = Path(folder, f"case {name}.{ending}")
            path.write_bytes(content)
            del content
            _say(_read(name, path))
            path.unlink()


if __name__ == "__main__":
    _main(sys.argv[1:])
