# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C ABI of the native solver (native/include/film_solver.h), by ctypes, which a few Pythons lack.

A ctypes call releases the interpreter, so a window stays alive while the library works.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.element import orthotropic
from BalloonWorkbench.core.solver.equilibrium import convergence, newton
from BalloonWorkbench.core.solver.native.load import library as loaded_library
from BalloonWorkbench.core.solver.problem import (
    Energies,
    Equilibrium,
    FilmProblem,
    NewtonSettings,
    Start,
    TangentSolution,
)
from BalloonWorkbench.core.types import Floats, Progress, no_progress

_CANCELLED, _OUT_OF_MEMORY = 3, 4
#: The numbers that steer both solvers: those in capitals of these modules, in their order.
CONSTANTS: dict[str, float] = {
    name.lower(): value
    for module in (newton, convergence, orthotropic)
    for name, value in vars(module).items()
    if name.isupper() and type(value) in (int, float)
}


class _Material(ctypes.Structure):
    _fields_ = [
        *((name, ctypes.c_double) for name in ("membrane_stiffness", "poisson_ratio", "flexural_rigidity")),
        *((name, ctypes.c_double) for name in ("pressure", "gradient", "across", "shear", "grain_angle")),
        *((name, ctypes.c_int32) for name in ("orthotropic", "tension_field", "in_space")),
    ]


class _NewtonStruct(ctypes.Structure):
    _fields_ = [("tolerance", ctypes.c_double), ("max_steps", ctypes.c_int32)]


class _Constants(ctypes.Structure):
    _fields_ = [
        (name, ctypes.c_int32 if isinstance(value, int) else ctypes.c_double)
        for name, value in CONSTANTS.items()
    ]


class _Result(ctypes.Structure):
    _fields_ = [(name, ctypes.c_int32) for name in ("steps", "factorisations", "converged")]


_ProgressCallback = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_double, ctypes.c_void_p)


class _Failure:
    """Keeps what the progress callback raises, which ctypes would print and drop, to be raised later."""

    error: BaseException | None = None

    def __enter__(self) -> None: ...

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> bool:
        self.error = error
        return True


def _constants(problem: FilmProblem) -> _Constants:
    """With the decrease that a step may bring at rest for this film, as in convergence.py."""
    still = CONSTANTS["still_decrement"] / problem.membrane_stiffness
    return _Constants(**{**CONSTANTS, "still_decrement": still})


def _pointer(array: np.ndarray | None) -> ctypes.c_void_p | None:  # type: ignore[type-arg]
    return None if array is None else array.ctypes.data_as(ctypes.c_void_p)


@contextmanager
def _solver(library: ctypes.CDLL, problem: FilmProblem) -> Iterator[ctypes.c_void_p]:
    rest = np.ascontiguousarray(problem.rest_positions, dtype=np.float64)
    triangles = np.ascontiguousarray(problem.triangles, dtype=np.int32)
    fixed = np.ascontiguousarray(problem.fixed, dtype=np.uint8)
    tied = None if problem.tied is None else np.ascontiguousarray(problem.tied, dtype=np.int32)
    loads = None if problem.loads is None else np.ascontiguousarray(problem.loads, dtype=np.float64)
    none = np.zeros((0, 3), dtype=np.int32)
    hinges = none if problem.hinges is None else np.ascontiguousarray(problem.hinges, dtype=np.int32)
    rigidities = problem.hinge_rigidities
    grain = problem.grain
    material = _Material(
        problem.membrane_stiffness,
        problem.poisson_ratio,
        problem.flexural_rigidity,
        problem.pressure,
        problem.gradient,
        *((1.0, 1.0, 0.0) if grain is None else (grain.across, grain.shear, grain.angle)),
        int(grain is not None),
        int(problem.tension_field),
        int(problem.in_space),
    )
    handle = ctypes.c_void_p()
    _check(
        library,
        library.film_create(
            ctypes.c_int32(len(rest)),
            _pointer(rest),
            ctypes.c_int32(len(triangles)),
            _pointer(triangles),
            _pointer(fixed),
            _pointer(loads),
            _pointer(tied),
            ctypes.c_int32(len(hinges)),
            _pointer(hinges),
            _pointer(rigidities),
            ctypes.byref(material),
            ctypes.byref(_constants(problem)),
            ctypes.byref(handle),
        ),
    )
    try:
        yield handle
    finally:
        library.film_destroy(handle)


def _check(library: ctypes.CDLL, status: int) -> None:
    if status == 0:
        return
    if status == _CANCELLED:
        raise Cancelled("The simulation was stopped.")
    text = library.film_last_error().decode()
    if status == _OUT_OF_MEMORY:
        raise MemoryError(text)
    raise SolverError(f"The simulation failed: {text}. Check the outline for degenerate parts.")


def solve(
    problem: FilmProblem,
    start: Start,
    settings: NewtonSettings,
    progress: Progress = no_progress,
) -> Equilibrium:
    """Bring the film to rest; the same contract and the same steps as newton.solve."""
    positions = np.array(start.positions, dtype=np.float64, order="C")
    directors = np.array(start.directors, dtype=np.float64, order="C")
    stiffnesses = np.array(start.levels, dtype=np.float64)
    library, result = loaded_library(), _Result()
    tolerance = convergence.film_tolerance(settings.tolerance, problem.membrane_stiffness)
    failure = _Failure()

    def report(fraction: float, _: object) -> int:
        with failure:
            return int(progress(fraction, "inflating"))
        return 0

    callback = _ProgressCallback(report)
    with _solver(library, problem) as handle:
        status = library.film_solve(
            handle,
            _pointer(positions),
            _pointer(directors),
            ctypes.c_int32(len(stiffnesses)),
            _pointer(stiffnesses),
            ctypes.byref(_NewtonStruct(tolerance, settings.max_steps)),
            callback,
            None,
            ctypes.byref(result),
        )
        if failure.error is not None:
            raise failure.error
        _check(library, status)
    return Equilibrium(positions, directors, result.steps, result.factorisations, bool(result.converged))


def energies(problem: FilmProblem, positions: Floats, directors: Floats) -> Energies:
    """Parts of the energy of a state."""
    library, parts = loaded_library(), np.zeros(5)
    positions = np.ascontiguousarray(positions, dtype=np.float64)
    directors = np.ascontiguousarray(directors, dtype=np.float64)
    with _solver(library, problem) as handle:
        _check(
            library, library.film_energies(handle, _pointer(positions), _pointer(directors), _pointer(parts))
        )
    return Energies(*(float(part) for part in parts))


def tangent_solve(
    problem: FilmProblem, positions: Floats, directors: Floats, loads: Floats
) -> TangentSolution:
    """How the film gives way to loads (n, 5, k); the same contract as newton.tangent_solve."""
    library, exact = loaded_library(), ctypes.c_int32()
    positions = np.ascontiguousarray(positions, dtype=np.float64)
    directors = np.ascontiguousarray(directors, dtype=np.float64)
    loads = np.ascontiguousarray(loads, dtype=np.float64)
    changes = np.empty((len(loads), 3, loads.shape[2]))
    with _solver(library, problem) as handle:
        status = library.film_tangent_solve(
            handle,
            _pointer(positions),
            _pointer(directors),
            ctypes.c_int32(loads.shape[2]),
            _pointer(loads),
            _pointer(changes),
            ctypes.byref(exact),
        )
        _check(library, status)
    return TangentSolution(changes, bool(exact.value))
