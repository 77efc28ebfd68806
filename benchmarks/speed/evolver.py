# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same balloon in Surface Evolver (Brakke 1992, "The Surface Evolver", Experimental Mathematics 1).

Its facet energy `relaxed_elastic_A` is the tension field of core/solver/element/membrane.py: energy density
of a St Venant-Kirchhoff film in plane stress with E t = 1, uniaxial where it is wrinkled, times the rest
area, from the Gram matrix of the flat triangle (`form_factors`). So

    quantity film  modulus E t / (p L)   method relaxed_elastic_A
    quantity gas   modulus -1            method facet_volume

is the energy of our film without bending and without a sealed band. The rim is held in z = 0, the start is
our dome. Evolver gets the schedule that served it best: a softer film first, then conjugate gradients with
line search. (Its Newton step `hessian_seek` comes to a halt away from the minimum, because slack facets have
no stiffness.)
"""

from __future__ import annotations

import math
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver import start as starts
from BalloonWorkbench.core.types import Floats, Ints

PROGRAM = "evolver-nox-d"
#: Its volume counts as found when it stays within this part of the last one.
TOLERANCE = 1e-3
#: The first level is softer by these factors; the faster of the two runs counts.
SOFTENINGS = (5.0, 25.0)

_HEAD = """\
define facet attribute poisson_ratio real
define facet attribute form_factors real[3]
quantity film energy modulus {soft:.15g} method relaxed_elastic_A global
quantity gas energy modulus -1 method facet_volume global
constraint 1
formula: z = 0
"""

# g 20: twenty steps of conjugate gradients, each with a line search. The run ends when the volume moves
# by less than 5e-5 in a window of steps that grows with the diameter of the mesh.
_SCRIPT = """\
read
quiet
steps := 0
say := {{ printf "AT %.3f %d %.12g\\n", clock, steps, -gas.value }}
relax := {{ g 20; steps += 20; say }}
say
conj_grad on
relax 10
film.modulus := {stiff:.15g}
conj_grad off
conj_grad on
before := 0; moved := 0
change := {{ before := gas.value; relax {window}; moved := abs(gas.value - before)/abs(gas.value) }}
do {{ change }} while (moved > 5e-5 && clock < {limit:g})
printf "AT REST\\n"
quit
"""


@dataclass(frozen=True)
class EvolverRun:
    """What a run gave.

    seconds    processor time from the loaded file until the volume stays within TOLERANCE of the last one
    total      processor time of the whole run, which goes on until the volume rests
    steps      conjugate-gradient steps until then
    all_steps  of the whole run
    volume     of the whole balloon, in units of the panel's size cubed
    converged  it came to rest before its time was up
    """

    seconds: float
    total: float
    steps: int
    all_steps: int
    volume: float
    converged: bool


def installed() -> bool:
    """Whether Surface Evolver is there."""
    return shutil.which(PROGRAM) is not None


def run(panel: Panel, film: Film, pressure: float, folder: Path, limit: float) -> EvolverRun:
    """Inflate a panel with Surface Evolver, with each of SOFTENINGS; the faster run.

    limit: processor seconds for each.
    """
    runs = []
    for softening in SOFTENINGS:
        path = folder / f"evolver-{softening:g}.fe"
        path.write_text(datafile(panel, film, pressure, softening, limit), encoding="ascii")
        ended = subprocess.run(
            [PROGRAM, str(path)], input="quit\n", capture_output=True, text=True, check=True, cwd=folder
        )
        runs.append(_read(ended.stdout, limit))
    done = [one for one in runs if one.converged] or runs
    return min(done, key=lambda one: one.seconds)


def _read(output: str, limit: float) -> EvolverRun:
    lines = output.splitlines()
    if "AT REST" not in lines:
        raise RuntimeError(f"Surface Evolver did not end its run: {lines[-1:]}")
    rows = [line.split()[1:] for line in lines if line.startswith("AT ") and line != "AT REST"]
    clock, steps, volume = np.array(rows, dtype=np.float64).T
    away = np.flatnonzero(np.abs(volume / volume[-1] - 1.0) > TOLERANCE)
    found = min(int(away[-1]) + 1, len(volume) - 1)
    return EvolverRun(
        float(clock[found] - clock[0]),
        float(clock[-1] - clock[0]),
        int(steps[found]),
        int(steps[-1]),
        2.0 * float(volume[-1]),
        bool(clock[-1] < limit),
    )


def datafile(panel: Panel, film: Film, pressure: float, softening: float, limit: float) -> str:
    """The text of Evolver's datafile: film, mesh, start and the commands to run."""
    size = float(np.ptp(panel.rest_positions, axis=0).max())
    stiff = film.membrane_stiffness / (pressure * size)
    rest, positions = panel.rest_positions / size, starts.dome(panel) / size
    rim = np.zeros(len(rest), dtype=bool)
    rim[np.concatenate(panel.loops)] = True
    edges, sides = oriented_edges(panel.triangles)
    lines = [_HEAD.format(soft=stiff / softening), "vertices"]
    lines += [
        f"{index} {x:.15g} {y:.15g} {z:.15g}" + (" constraint 1" if on_rim else "")
        for index, ((x, y, z), on_rim) in enumerate(zip(positions, rim), 1)
    ]
    lines += ["", "edges"]
    lines += [f"{index} {tail} {head}" for index, (tail, head) in enumerate(edges + 1, 1)]
    lines += ["", "faces"]
    lines += [
        f"{index} {a} {b} {c} tension 0 poisson_ratio {film.poisson_ratio:.15g}"
        f" form_factors {{{uu:.15g},{uv:.15g},{vv:.15g}}}"
        for index, ((a, b, c), (uu, uv, vv)) in enumerate(zip(sides, gram(rest[panel.triangles])), 1)
    ]
    window = max(10, round(0.5 * math.sqrt(len(rest))))
    return "\n".join([*lines, "", _SCRIPT.format(stiff=stiff, window=window, limit=limit)])


def oriented_edges(triangles: Ints) -> tuple[Ints, Ints]:
    """Edges (e, 2) of a mesh, and the sides (m, 3) of its triangles: from 1, negative where reversed."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    edges, number = np.unique(np.sort(ends, axis=1), axis=0, return_inverse=True)
    forward = np.where(ends[:, 0] < ends[:, 1], 1, -1)
    return edges, (forward * (number.ravel() + 1)).reshape(-1, 3)


def gram(corners: Floats) -> Floats:
    """Products u.u, u.v and v.v (m, 3) of the sides from the first corner of triangles (m, 3, 2)."""
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.stack([(u * u).sum(1), (u * v).sum(1), (v * v).sum(1)], axis=1)
