# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sparse factorisation by itself, under sanitizers: against SciPy and closed forms."""

import functools
import re
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from programs import (
    COMPILER,
    EIGEN,
    FACTORISATION,
    MEMORY,
    NATIVE,
    TESTS,
    THREADS,
    WARNINGS,
    compiled,
    folder,
    needs_compiler,
    run,
)
from scipy import sparse
from scipy.sparse.linalg import spsolve

from BalloonWorkbench.core.types import Floats, Ints

pytestmark = needs_compiler


@functools.cache
def comparison() -> Path:
    """The object file of the comparison with Eigen: nearly all Eigen's code, without sanitizers quick."""
    path = folder() / "cholesky_test.o"
    run(
        *(COMPILER, "-std=c++17", "-O1", *WARNINGS, "-I", NATIVE, "-isystem", EIGEN),
        *("-c", TESTS / "cholesky_test.cpp", "-o", path),
    )
    return path


@pytest.mark.slow
@pytest.mark.parametrize(
    "sanitizers", [pytest.param(MEMORY, id="memory"), pytest.param(THREADS, id="threads")]
)
def test_matrices_of_meshes(tmp_path: Path, sanitizers: tuple[str, str]) -> None:
    """Against dense factorisations; indefinite matrices; any number of threads; odd meshes; each kernel."""
    path = tmp_path / "cholesky_test"
    parts = [compiled(source, sanitizers) for source in FACTORISATION]
    run(COMPILER, *sanitizers, comparison(), *parts, "-pthread", "-o", path)
    run(path)


@dataclass
class System:
    """A symmetric matrix (n, n), the block of each unknown, the blocks' points, and a right-hand side."""

    matrix: sparse.csc_matrix
    right: Floats
    block_of_unknown: Ints
    points: Floats
    diagonal: Floats | float = 0.0

    def input(self, threads: int) -> bytes:
        lower = sparse.tril(self.matrix, format="csc")
        lower.sort_indices()
        return _input(
            *(lower.indptr, lower.indices, lower.data, self.block_of_unknown, self.points, threads),
            *(np.broadcast_to(self.diagonal, self.right.shape), self.right),
        )


def _input(
    starts: Ints,
    rows: Ints,
    values: Floats,
    block: Ints,
    points: Floats,
    threads: int,
    diagonal: Floats,
    right: Floats,
) -> bytes:
    whole = np.concatenate([[len(right), len(rows), len(points), threads], starts, rows, block])
    numbers = np.concatenate([values, diagonal, right, np.ravel(points)])
    return whole.astype(np.int32).tobytes() + numbers.astype(np.float64).tobytes()


@functools.cache
def program() -> Path:
    path = folder() / "solve_matrix"
    objects = [compiled(source, MEMORY) for source in (TESTS / "solve_matrix.cpp", *FACTORISATION)]
    run(COMPILER, *MEMORY, *objects, "-pthread", "-o", path)
    return path


def outcome(given: bytes) -> tuple[int, Floats]:
    """What the program says of a system, 0, 1 or 2, and the solution."""
    ended = subprocess.run([program()], input=given, capture_output=True, check=True)
    return int.from_bytes(ended.stdout[:4], sys.byteorder), np.frombuffer(ended.stdout[4:])


def laplacian(columns: int, rows: int) -> System:
    """The five-point Laplacian of a rectangle held at its rim, and its first mode."""
    x, y = np.meshgrid(np.arange(1, columns + 1), np.arange(1, rows + 1))
    line = [sparse.diags([-1.0, 2.0, -1.0], [-1, 0, 1], shape=(n, n)) for n in (columns, rows)]
    matrix = sparse.kron(np.eye(rows), line[0]) + sparse.kron(line[1], np.eye(columns))
    mode = np.sin(np.pi * x / (columns + 1)) * np.sin(np.pi * y / (rows + 1))
    points = np.column_stack([x.ravel(), y.ravel()]).astype(float)
    return System(sparse.csc_matrix(matrix), mode.ravel(), np.arange(columns * rows), points)


def first_eigenvalue(columns: int, rows: int) -> float:
    return 4.0 - 2.0 * np.cos(np.pi / (columns + 1)) - 2.0 * np.cos(np.pi / (rows + 1))


def random_system(count: int, seed: int) -> System:
    """Random entries anywhere, in blocks of one to five unknowns at points that say nothing of them."""
    random = np.random.default_rng(seed)
    part = sparse.random(count, count, min(1.0, 3.0 / count), random_state=seed)
    matrix = sparse.csc_matrix(part @ part.T + 0.01 * sparse.identity(count))
    block = np.repeat(np.arange(count), random.integers(1, 6, count))[:count]
    return System(matrix, random.normal(size=count), block, random.normal(size=(block[-1] + 1, 2)))


@pytest.mark.parametrize("count", [1, 2, 3, 17, 80, 81, 400])
def test_random_systems_as_scipy_solves_them(count: int) -> None:
    system = random_system(count, count)
    for diagonal in (0.0, np.linspace(0.0, 1.0, count)):
        status, solution = outcome(replace(system, diagonal=diagonal).input(2))
        matrix = system.matrix + sparse.diags(np.broadcast_to(diagonal, count), format="csc")
        assert status == 0
        np.testing.assert_allclose(solution, spsolve(matrix, system.right), rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("size", [(1, 1), (9, 1), (13, 7), (60, 50)])
def test_laplacian_with_a_known_solution(size: tuple[int, int]) -> None:
    system = laplacian(*size)
    status, solution = outcome(system.input(1))
    assert status == 0
    np.testing.assert_allclose(solution, system.right / first_eigenvalue(*size), rtol=1e-11, atol=1e-13)


def test_any_number_of_threads_gives_the_same_bits() -> None:
    given = laplacian(90, 80)
    solutions = [outcome(given.input(threads))[1].tobytes() for threads in (1, 2, 3, 4, 7)]
    assert len(solutions[0]) == 8 * 90 * 80
    assert len(set(solutions)) == 1


def test_another_numbering_has_the_same_solution() -> None:
    system = laplacian(30, 20)
    order = np.random.default_rng(1).permutation(600)
    mixed = System(
        system.matrix[order][:, order].tocsc(),
        system.right[order],
        system.block_of_unknown,
        system.points[order],
    )
    np.testing.assert_allclose(outcome(mixed.input(2))[1], outcome(system.input(2))[1][order], rtol=1e-11)


def test_parts_that_do_not_touch() -> None:
    """Three rectangles at one place and unknowns alone: each as if the others were not there."""
    sizes = [(12, 9), (25, 20), (3, 4)]
    parts = [laplacian(*size) for size in sizes]
    matrix = sparse.block_diag([part.matrix for part in parts] + [4.0 * sparse.identity(5)], format="csc")
    right = np.concatenate([part.right for part in parts] + [np.ones(5)])
    points = np.concatenate([part.points for part in parts] + [np.zeros((5, 2))])
    status, solution = outcome(System(matrix, right, np.arange(len(right)), points).input(2))
    assert status == 0
    scales = [np.full(w * h, first_eigenvalue(w, h)) for w, h in sizes] + [np.full(5, 4.0)]
    np.testing.assert_allclose(solution, right / np.concatenate(scales), rtol=1e-11, atol=1e-13)


def path_laplacian(count: int) -> sparse.csc_matrix:
    """Of a chain that nothing holds: each pivot is exactly one, the last exactly zero."""
    ends = np.r_[1.0, np.full(count - 2, 2.0), 1.0]
    return sparse.csc_matrix(
        sparse.diags([np.full(count - 1, -1.0), ends, np.full(count - 1, -1.0)], [-1, 0, 1])
    )


@pytest.mark.parametrize(
    ("matrix", "is_definite"),
    [
        pytest.param(path_laplacian(40), False, id="singular"),
        pytest.param(sparse.csc_matrix(np.ones((2, 2))), False, id="twice the same row"),
        pytest.param(sparse.csc_matrix(np.array([[1.0, 2.0], [2.0, 1.0]])), False, id="indefinite"),
        pytest.param(sparse.csc_matrix(np.array([[np.nan]])), False, id="not a number"),
        pytest.param(sparse.csc_matrix(np.array([[-1.0]])), False, id="negative"),
        pytest.param(path_laplacian(40) + sparse.diags([1.0] + 39 * [0.0]), True, id="held at its end"),
    ],
)
def test_what_is_not_definite_is_reported(matrix: sparse.csc_matrix, is_definite: bool) -> None:
    count = matrix.shape[0]
    points = np.column_stack([np.arange(count), np.zeros(count)])
    status, solution = outcome(
        System(sparse.csc_matrix(matrix), np.ones(count), np.arange(count), points).input(1)
    )
    assert (status, len(solution)) == ((0, count) if is_definite else (1, 0))


@pytest.mark.parametrize(
    "spoiled",
    [
        {"starts": [0, 2, 3, 5]},  # more than there are
        {"starts": [1, 2, 3, 4]},
        {"starts": [0, 3, 2, 4]},
        {"starts": [0, 2, 2, 4]},  # a column without its diagonal
        {"rows": [1, 0, 1, 2]},  # the diagonal not first
        {"rows": [0, 3, 1, 2]},
        {"rows": [0, 0, 1, 2]},
        {"rows": [0, -1, 1, 2]},
        {"block": [1, 0, 1]},  # that do not ascend
        {"block": [0, 1, 3]},  # without a point
        {"block": [-1, 0, 1]},
    ],
)
def test_what_is_no_pattern_is_refused(spoiled: dict[str, list[int]]) -> None:
    good = {"starts": [0, 2, 3, 4], "rows": [0, 1, 1, 2], "block": [0, 1, 2]}

    def status(parts: dict[str, list[int]]) -> int:
        starts, rows, block = (np.array(parts[name]) for name in ("starts", "rows", "block"))
        return outcome(
            _input(starts, rows, np.ones(4) + 1.0, block, np.zeros((3, 2)), 1, np.zeros(3), np.ones(3))
        )[0]

    assert status(good) == 0
    assert status(good | spoiled) == 2


def test_the_factorisation_knows_nothing_of_the_film() -> None:
    """It includes itself, simd and the standard library; the film includes its public headers alone."""

    def included(folder: str) -> set[str]:
        sources = [path for path in (NATIVE / folder).rglob("*") if path.suffix in {".h", ".cpp"}]
        assert sources
        texts = [path.read_text(encoding="utf-8") for path in sources]
        # a name in quotes without a folder is a file beside
        return {name for text in texts for name in re.findall(r'#include ["<]([^">]+/[^">]+)[">]', text)}

    public = {f"cholesky/{path.name}" for path in (NATIVE / "cholesky").glob("*.h")}
    assert included("cholesky") == {*public, "simd/vec4.h", "sys/mman.h"}
    assert included("simd") == set()
    assert {name for name in included("film") if not name.startswith("Eigen/")} == {*public, "simd/vec4.h"}
