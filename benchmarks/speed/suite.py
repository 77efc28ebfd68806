# SPDX-License-Identifier: LGPL-2.1-or-later
"""All measurements of speed, one after the other, each in a process of its own."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from dataclasses import asdict
from datetime import date
from pathlib import Path
from typing import Any, TextIO

from speed import cases, commands, evolver, machine, startup, strokes

SHAPES = ("disc", "square", "star")
EVOLVER_SHAPES = ("disc", "square", "heart")
NUMPY_SIZE = 2000
#: A case expected to need more processor seconds than this is left out, and the page says so.
TOO_LONG = 180.0
#: A case is repeated within so many seconds, at most so often.
REPEAT_WITHIN, MOST_REPEATS = 4.0, 5
EVOLVER_LIMIT = {2000: 60.0, 10000: 400.0}
#: Shifts tried for a definite tangent; its pattern and therefore the yardstick are the same with each.
SHIFTS = (1.0, 30.0, 1000.0)

_WORKER = Path(__file__).parent / "worker.py"


def measure(folder: Path, sizes: list[int], evolver_sizes: list[int], log: TextIO) -> dict[str, Any]:
    """Every measurement, also written to folder/*.json as soon as it is there."""
    measured: dict[str, Any] = {
        "date": date.today().isoformat(),
        "machine": machine.description(),
        "load_before": machine.load(),
        "start_ms": startup.milliseconds(folder),
        "strokes": strokes.measure(folder),
        "commands": commands.measure(folder),
        "loading": commands.loading(),
        "solves": [],
        "numpy": [],
        "evolver": [],
    }
    for shape in SHAPES:
        known: list[dict[str, Any]] = []
        for vertices in sizes:
            expected = _expected(known, vertices)
            if expected > TOO_LONG:
                found: dict[str, Any] = {"shape": shape, "wanted": vertices, "expected": expected}
            else:
                found = _solve(folder, shape, vertices, expected)
                known.append(found)
            measured["solves"].append(found)
            _note(folder, "solves", measured, log, found)
    for shape in SHAPES:
        job = _job(shape, NUMPY_SIZE, backend="numpy")
        found = {"shape": shape, "wanted": NUMPY_SIZE, **_worker(job)}
        native = next(
            (one for one in measured["solves"] if (one["shape"], one["wanted"]) == (shape, NUMPY_SIZE)), None
        )
        found["native_cpu"] = (native or _worker(_job(shape, NUMPY_SIZE)))["cold"]["cpu"]
        measured["numpy"].append(found)
        _note(folder, "numpy", measured, log, found)
    if evolver.installed():
        for vertices in evolver_sizes:
            for shape in EVOLVER_SHAPES:
                found = _peer(folder, shape, vertices)
                measured["evolver"].append(found)
                _note(folder, "evolver", measured, log, found)
    measured["load_after"] = machine.load()
    (folder / "machine.json").write_text(
        json.dumps(
            {key: measured[key] for key in ("date", "machine", "load_before", "load_after", "start_ms")},
            indent=1,
        ),
        encoding="utf-8",
    )
    return measured


def measure_account(folder: Path, sizes: list[int]) -> dict[str, Any]:
    """Solves of the disc alone, and the machine they ran on."""
    measured: dict[str, Any] = {
        "date": date.today().isoformat(),
        "machine": machine.description(),
        "load_before": machine.load(),
        "solves": [_solve(folder, "disc", vertices, REPEAT_WITHIN / 3.0) for vertices in sizes],
        "load_after": machine.load(),
    }
    (folder / "account.json").write_text(json.dumps(measured, indent=1), encoding="utf-8")
    return measured


def _job(shape: str, vertices: int, **other: Any) -> dict[str, Any]:
    job = {"shape": shape, "vertices": vertices, "backend": "native", "repeats": 1}
    return {
        **job,
        "bare": False,
        "warm": False,
        "visible": False,
        "matrix": None,
        "shift": SHIFTS[0],
        **other,
    }


def _worker(job: dict[str, Any]) -> dict[str, Any]:
    ended = subprocess.run(
        [sys.executable, str(_WORKER), json.dumps(job)], capture_output=True, text=True, check=False
    )
    if ended.returncode:
        raise RuntimeError(f"{job} failed:\n{ended.stderr}")
    return dict(json.loads(ended.stdout.splitlines()[-1]))


def _solve(folder: Path, shape: str, vertices: int, expected: float) -> dict[str, Any]:
    """Cold and warm solves, and the yardstick for them right after."""
    matrix = folder / f"{shape}-{vertices}.tangent"
    repeats = int(min(max(REPEAT_WITHIN / expected, 1), MOST_REPEATS)) if expected else MOST_REPEATS
    for shift in SHIFTS:
        job = _job(shape, vertices, repeats=repeats, warm=True, matrix=str(matrix), shift=shift)
        found = _worker(job)
        ended = subprocess.run(
            [str(folder / "yardstick" / "yardstick"), str(matrix)],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )
        matrix.unlink()
        rod = json.loads(ended.stdout)
        if rod["definite"]:
            return {
                "shape": shape,
                "wanted": vertices,
                **found,
                "yardstick": {**rod, "file": matrix.name},
                "load": machine.load(),
            }
    raise RuntimeError(
        f"The tangent of {shape} at {vertices} vertices is not definite with a shift of {shift}."
    )


def _peer(folder: Path, shape: str, vertices: int) -> dict[str, Any]:
    repeats = 3 if vertices <= 2000 else 1
    ours = _worker(_job(shape, vertices, repeats=repeats, bare=True, visible=True))
    sealed = _worker(_job(shape, vertices, repeats=repeats))
    limit = EVOLVER_LIMIT.get(vertices, 0.06 * vertices)
    theirs = evolver.run(cases.panel(shape, vertices), cases.bare_film(), cases.PRESSURE, folder, limit)
    other = {"sealed": sealed["cold"], "load": machine.load()}
    return {"shape": shape, "wanted": vertices, **ours, **other, "evolver": asdict(theirs)}


def _expected(known: list[dict[str, Any]], vertices: int) -> float:
    """Processor seconds of the next size if they grow as up to here, at least with the power 1.3; or 0."""
    if not known:
        return 0.0
    last = known[-1]
    power = 1.3
    if len(known) > 1:
        before = known[-2]
        power = max(power, _power(before, last))
    return float(last["cold"]["cpu"] * (vertices / last["vertices"]) ** power)


def _power(one: dict[str, Any], other: dict[str, Any]) -> float:
    return math.log(other["cold"]["cpu"] / one["cold"]["cpu"]) / math.log(other["vertices"] / one["vertices"])


def _note(folder: Path, name: str, measured: dict[str, Any], log: TextIO, found: dict[str, Any]) -> None:
    (folder / f"{name}.json").write_text(json.dumps(measured[name], indent=1), encoding="utf-8")
    what = f"{name} {found['shape']} {found['wanted']}"
    if "cold" not in found:
        log.write(f"{what}: left out, {found['expected']:.0f} s expected\n")
    else:
        log.write(f"{what}: {found['cold']['cpu']:.3f} s of processor time, {found['cold']['steps']} steps\n")
    log.flush()
