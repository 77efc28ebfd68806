# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choice of solver, made once: native when its library loads, NumPy otherwise.

Both are the same quasi-static Newton method. Motion in time (Newmark) is slower and is taken on demand only.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from BalloonWorkbench.core import packages
from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.solver.problem import (
    Energies,
    Equilibrium,
    FilmProblem,
    NewtonSettings,
    Start,
    TangentSolution,
)
from BalloonWorkbench.core.types import Floats, Progress

SOLVERS = ("native", "numpy", "newmark")


class Solve(Protocol):
    """Signature of a solver; see newton.solve."""

    def __call__(
        self,
        problem: FilmProblem,
        start: Start,
        settings: NewtonSettings,
        progress: Progress,
    ) -> Equilibrium:
        """Bring the film to rest."""


@dataclass(frozen=True)
class Backend:
    """A solver and its name in reports."""

    name: str
    solve: Solve
    energies: Callable[[FilmProblem, Floats, Floats], Energies]
    tangent_solve: Callable[
        [FilmProblem, Floats, Floats, Floats], TangentSolution
    ]  # see newton.tangent_solve


@functools.cache
def available() -> tuple[Backend, ...]:
    """The solvers that work here, best first."""
    working = []
    if load.problem_with_library() is None:
        from BalloonWorkbench.core.solver.native import c_interface

        working.append(Backend("native", c_interface.solve, c_interface.energies, c_interface.tangent_solve))
    if _scipy_is_there():
        working.append(Backend("numpy", newton.solve, newton.energies, newton.tangent_solve))
    if not working and packages.lacks_ctypes():
        raise MissingPackageError(f"No solver works here: {packages.NO_CTYPES}")
    if not working:
        raise MissingPackageError(
            f"No solver works here: {load.problem_with_library()} Build it or install the package scipy."
        )
    return tuple(working)


def active_backend() -> str:
    """Name of the solver used when none is asked for. Raises MissingPackageError when there is none."""
    return available()[0].name


def _scipy_is_there() -> bool:
    """Some FreeCADs lack it, and it does not load in a Python without ctypes."""
    try:
        import scipy  # noqa: F401
    except ImportError:
        return False
    return True


def backend_named(name: str | Backend | None) -> Backend:
    """The named solver, or the best one for None. Raises InputError when it is not available."""
    if isinstance(name, Backend):
        return name
    if name is None:
        return available()[0]
    if name == "newmark" and _scipy_is_there():
        from BalloonWorkbench.core.solver.dynamics import motion  # most balloons do not move

        return Backend("newmark", motion.solve, newton.energies, newton.tangent_solve)
    for backend in available():
        if backend.name == name:
            return backend
    if name == "native":
        raise InputError(
            f"The native solver is not available: {load.problem_with_library()} Use the NumPy solver."
        )
    if name in ("numpy", "newmark"):
        raise InputError(
            f"The solver '{name}' needs the Python package scipy. Install it or use the native solver."
        )
    raise InputError(f"There is no solver named '{name}'. Use 'native', 'numpy' or 'newmark'.")
