# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which solver is taken, and what is said when one is missing."""

import hashlib
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from solver_cases import PRESSURE, film, held, needs_native, panel

from BalloonWorkbench.core.errors import InputError, MissingPackageError, SolverError
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.equilibrium import newton
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.native import c_interface, load
from BalloonWorkbench.core.solver.problem import FilmProblem, NewtonSettings, Start
from BalloonWorkbench.core.types import no_progress

LIBRARY = load._FOLDER / "libfilm_solver.so"


@pytest.fixture(autouse=True)
def _choose_anew() -> Iterator[None]:
    """The choice is made once: forget it before and after."""
    for cached in (load._load, backend.available):
        cached.cache_clear()
    yield
    for cached in (load._load, backend.available):
        cached.cache_clear()


@pytest.fixture
def no_library(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setattr(load, "_FOLDER", tmp_path)
    return tmp_path


@pytest.fixture
def no_scipy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)


@needs_native
def test_native_comes_first() -> None:
    assert load.problem_with_library() is None
    assert backend.active_backend() == "native"
    assert [one.name for one in backend.available()] == ["native", "numpy"]


def test_without_a_library_numpy_is_taken(no_library: Path) -> None:
    assert backend.active_backend() == "numpy"
    result = inflate(panel("disc", 100), film(100), PRESSURE)
    assert result.report.backend == "numpy"
    with pytest.raises(InputError, match=r"libfilm_solver.so has not been built\. Use the NumPy solver"):
        inflate(panel("disc", 100), film(100), PRESSURE, backend="native")


def test_library_that_does_not_load(no_library: Path) -> None:
    content = b"not a library"
    (no_library / "libfilm_solver.so").write_bytes(content)
    (no_library / "libfilm_solver.so.sha256").write_text(hashlib.sha256(content).hexdigest())
    assert backend.active_backend() == "numpy"
    assert "cannot be loaded" in str(load.problem_with_library())


@needs_native
def test_library_of_another_interface(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(load, "ABI_VERSION", 999)
    assert backend.active_backend() == "numpy"
    assert "but 999 is needed" in str(load.problem_with_library())


@pytest.mark.usefixtures("no_scipy")
@needs_native
def test_without_scipy_native_is_taken() -> None:
    assert [one.name for one in backend.available()] == ["native"]
    with pytest.raises(InputError, match="needs the Python package scipy"):
        backend.backend_named("numpy")


@pytest.mark.usefixtures("no_scipy", "no_library")
def test_without_both_it_says_what_to_do() -> None:
    with pytest.raises(MissingPackageError, match="install the package scipy"):
        backend.active_backend()


def test_unknown_solver() -> None:
    with pytest.raises(InputError, match="no solver named 'abacus'"):
        inflate(panel("disc", 100), film(100), PRESSURE, backend="abacus")


@pytest.mark.parametrize("solver", [pytest.param(c_interface, marks=needs_native), newton])
@pytest.mark.parametrize("case", ["not finite", "lonely vertex"])
def test_broken_meshes_are_refused(solver: object, case: str) -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]])
    triangles = np.array([[0, 1, 2], [1, 3, 2]], dtype=np.int32)
    if case == "not finite":
        points[3] = np.nan
    else:
        triangles = triangles[:1]
    problem = FilmProblem(points, triangles, held(4), 10.0, 0.3, 1e-6)
    lifted = np.column_stack([np.nan_to_num(points), [0.0, 0.0, 0.0, 0.1]])
    with pytest.raises(SolverError):
        solver.solve(
            problem, Start(lifted, np.tile([0.0, 0.0, 1.0], (4, 1)), (10.0,)), NewtonSettings(), no_progress
        )


@needs_native
def test_wrong_index_is_an_error_not_a_crash() -> None:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    problem = FilmProblem(points, np.array([[0, 1, 7]], dtype=np.int32), held(3), 10.0, 0.3, 1e-6)
    with pytest.raises(SolverError, match="index is out of range"):
        c_interface.energies(problem, np.zeros((3, 3)), np.tile([0.0, 0.0, 1.0], (3, 1)))
