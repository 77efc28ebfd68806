# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver, loaded through its C ABI (native/include/film_solver.h).

A ctypes call releases the interpreter, so a window stays alive while the library works.
"""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.solver.library import FOLDER, candidates, damage, file_name, to_load, unusable
from BalloonWorkbench.core.solver.problem import Energies, Equilibrium, FilmProblem, NewtonSettings
from BalloonWorkbench.core.solver.seam_band import hinge_rigidities, seam_hinges
from BalloonWorkbench.core.types import Floats, Progress, no_progress

ABI_VERSION = 4
_CANCELLED = 3
_FOLDER = FOLDER


class _Material(ctypes.Structure):
    _fields_ = [
        ("membrane_stiffness", ctypes.c_double),
        ("poisson_ratio", ctypes.c_double),
        ("flexural_rigidity", ctypes.c_double),
        ("pressure", ctypes.c_double),
        ("across", ctypes.c_double),
        ("shear", ctypes.c_double),
        ("grain_angle", ctypes.c_double),
        ("orthotropic", ctypes.c_int32),
        ("tension_field", ctypes.c_int32),
    ]


class _Newton(ctypes.Structure):
    _fields_ = [("tolerance", ctypes.c_double), ("max_steps", ctypes.c_int32)]


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


@functools.cache
def _load() -> tuple[ctypes.CDLL | None, str | None]:
    """The library, or why there is none: what is wrong with the best one that is there."""
    why = None
    for path in candidates(_FOLDER):
        loaded, problem = _loaded(path)
        if loaded is not None:
            return loaded, None
        why = why or problem
    return None, why or f"{file_name()} has not been built."


def _loaded(path: Path) -> tuple[ctypes.CDLL | None, str | None]:
    damaged = damage(path)
    if damaged is not None:
        return None, damaged
    try:
        loaded = ctypes.CDLL(str(to_load(path)))
        version = loaded.film_abi_version()
    except (OSError, AttributeError) as error:
        return None, f"{path.name} cannot be loaded ({error})."
    if version != ABI_VERSION:
        return None, f"{path.name} has interface {version}, but {ABI_VERSION} is needed."
    loaded.film_last_error.restype = ctypes.c_char_p
    loaded.film_destroy.argtypes = [ctypes.c_void_p]
    loaded.film_destroy.restype = None
    return loaded, None


def problem_with_library() -> str | None:
    """Why the native solver cannot be used, or None when it can."""
    return _load()[1]


def unusable_library() -> str | None:
    """A sentence for the user where a library is there, but of no use; None where none was built."""
    why = problem_with_library() if any(candidates(_FOLDER)) else None
    return why and unusable(why)


def _library() -> ctypes.CDLL:
    loaded, why = _load()
    if loaded is None:
        raise SolverError(f"The native solver is not available: {why} Use the NumPy solver.")
    return loaded


def _pointer(array: np.ndarray | None) -> ctypes.c_void_p | None:  # type: ignore[type-arg]
    return None if array is None else array.ctypes.data_as(ctypes.c_void_p)


@contextmanager
def _solver(problem: FilmProblem) -> Iterator[tuple[ctypes.CDLL, ctypes.c_void_p]]:
    library = _library()
    rest = np.ascontiguousarray(problem.rest_positions, dtype=np.float64)
    triangles = np.ascontiguousarray(problem.triangles, dtype=np.int32)
    fixed = np.ascontiguousarray(problem.fixed, dtype=np.uint8)
    tied = None if problem.tied is None else np.ascontiguousarray(problem.tied, dtype=np.int32)
    loads = None if problem.loads is None else np.ascontiguousarray(problem.loads, dtype=np.float64)
    hinges = np.ascontiguousarray(seam_hinges(problem.seams, problem.welds))
    rigidities = hinge_rigidities(problem.seams, problem.seam_rigidities, problem.welds)
    grain = problem.grain
    material = _Material(
        problem.membrane_stiffness,
        problem.poisson_ratio,
        problem.flexural_rigidity,
        problem.pressure,
        *((1.0, 1.0, 0.0) if grain is None else (grain.across, grain.shear, grain.angle)),
        int(grain is not None),
        int(problem.tension_field),
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
            ctypes.byref(handle),
        ),
    )
    try:
        yield library, handle
    finally:
        library.film_destroy(handle)


def _check(library: ctypes.CDLL, status: int) -> None:
    if status == 0:
        return
    if status == _CANCELLED:
        raise Cancelled("The simulation was stopped.")
    text = library.film_last_error().decode()
    raise SolverError(f"The simulation failed: {text}. Check the outline for degenerate parts.")


def solve(
    problem: FilmProblem,
    positions: Floats,
    directors: Floats,
    levels: Sequence[float],
    settings: NewtonSettings,
    progress: Progress = no_progress,
) -> Equilibrium:
    """Bring the film to rest; the same contract and the same steps as newton.solve."""
    positions = np.array(positions, dtype=np.float64, order="C")
    directors = np.array(directors, dtype=np.float64, order="C")
    stiffnesses = np.array(levels, dtype=np.float64)
    result = _Result()
    failure = _Failure()

    def report(fraction: float, _: object) -> int:
        with failure:
            return int(progress(fraction, "inflating"))
        return 0

    callback = _ProgressCallback(report)
    with _solver(problem) as (library, handle):
        status = library.film_solve(
            handle,
            _pointer(positions),
            _pointer(directors),
            ctypes.c_int32(len(stiffnesses)),
            _pointer(stiffnesses),
            ctypes.byref(_Newton(settings.tolerance, settings.max_steps)),
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
    parts = np.zeros(5)
    positions = np.ascontiguousarray(positions, dtype=np.float64)
    directors = np.ascontiguousarray(directors, dtype=np.float64)
    with _solver(problem) as (library, handle):
        _check(
            library, library.film_energies(handle, _pointer(positions), _pointer(directors), _pointer(parts))
        )
    return Energies(*(float(part) for part in parts))
