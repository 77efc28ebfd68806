# SPDX-License-Identifier: LGPL-2.1-or-later
"""One balloon, timed in a process of its own: worker.py JOB prints a line of JSON.

A job: {"shape", "vertices", "backend", "repeats", "bare": without a sealed band, "warm": also edit it,
"visible": also time it until its volume is nearly the last one, "matrix": file for the tangent or null,
"shift"}. Times are processor seconds of all threads, and seconds on the clock.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from speed import cases
from speed.evolver import TOLERANCE
from speed.machine import PeakMemory
from speed.tangent import tangent, write_matrix

from BalloonWorkbench.core.solver.element.kinematics import facet_volume
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.problem import NewtonSettings


def main(job: dict[str, Any]) -> dict[str, Any]:
    """Do a job; the numbers found."""
    panel, meshing = timed(lambda: cases.panel(job["shape"], job["vertices"]))
    film = cases.bare_film() if job["bare"] else cases.sealed_film()
    backend, repeats = job["backend"], job["repeats"]
    inflate(cases.panel("disc", 60), film, cases.PRESSURE, backend=backend)  # loads what is loaded once

    memory = PeakMemory()
    result, first = timed(lambda: inflate(panel, film, cases.PRESSURE, backend=backend))
    peak = memory.growth
    times = [first]
    times += [
        timed(lambda: inflate(panel, film, cases.PRESSURE, backend=backend))[1] for _ in range(repeats - 1)
    ]
    none = NewtonSettings(max_steps=0)
    begun = [
        timed(lambda: inflate(panel, film, cases.PRESSURE, backend=backend, settings=none))[1]
        for _ in range(repeats)
    ]
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    found = {
        "vertices": len(panel.rest_positions),
        "triangles": len(panel.triangles),
        "mesh": summary([meshing]),
        "cold": {**summary(times), **report(result)},
        "begun": summary(begun),
        "peak_bytes": peak,
        "volume": result.volume / size**3,
        "facet_volume": 2.0 * facet_volume(result.positions, panel.triangles) / size**3,
    }
    if job["warm"]:
        edit = cases.edited(panel)
        runs = [
            timed(lambda: inflate(edit, film, cases.PRESSURE, backend=backend, start=result))
            for _ in range(repeats)
        ]
        found["warm"] = {**summary([seconds for _, seconds in runs]), **report(runs[0][0])}
    if job["visible"]:

        def stopped(steps: int) -> Inflation:
            settings = NewtonSettings(max_steps=steps)
            return inflate(panel, film, cases.PRESSURE, backend=backend, settings=settings)

        found["visible"] = until_visible(stopped, result, found["cold"]["cpu"])
    if job["matrix"]:
        write_matrix(Path(job["matrix"]), *tangent(result, film, cases.PRESSURE, job["shift"]))
    return found


def timed(work: Callable[[], Any]) -> tuple[Any, tuple[float, float]]:
    """The result, and seconds of the processor and of the clock."""
    clock, processor = time.perf_counter(), time.process_time()
    result = work()
    return result, (time.process_time() - processor, time.perf_counter() - clock)


def until_visible(stopped: Callable[[int], Inflation], last: Inflation, seconds: float) -> dict[str, Any]:
    """Steps and processor time from which on the volume stays within TOLERANCE of the last one's.

    stopped(steps) ends a solve early; seconds is what the whole one took.
    """
    volume = facet_volume(last.positions, last.panel.triangles)
    steps = last.report.newton_steps
    while steps > 1:
        early, (processor, _) = timed(partial(stopped, steps - 1))
        if abs(facet_volume(early.positions, last.panel.triangles) / volume - 1.0) > TOLERANCE:
            break
        steps, seconds = steps - 1, processor
    return {"steps": steps, "cpu": seconds}


def summary(times: list[tuple[float, float]]) -> dict[str, Any]:
    """Medians, and the least and greatest processor time."""
    processor, clock = np.array(times).T
    return {
        "cpu": float(np.median(processor)),
        "cpu_least": float(processor.min()),
        "cpu_most": float(processor.max()),
        "wall": float(np.median(clock)),
        "repeats": len(times),
    }


def report(result: Inflation) -> dict[str, Any]:
    """What the solver says about its run."""
    return {
        "steps": result.report.newton_steps,
        "factorisations": result.report.factorisations,
        "converged": result.report.converged,
        "backend": result.report.backend,
    }


if __name__ == "__main__":
    sys.stdout.write(json.dumps(main(json.loads(sys.argv[1]))) + "\n")
