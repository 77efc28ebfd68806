# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver in programs of their own that run under the sanitizers: factorisation, C boundary."""

import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from solver_cases import WITH_CONSTANTS

ROOT = Path(__file__).resolve().parents[3]
NATIVE = ROOT / "BalloonWorkbench" / "native"
FACTORISATION = sorted((NATIVE / "cholesky" / "src").glob("*.cpp"))
FILM = sorted((NATIVE / "film").glob("*.cpp"))
TESTS = ROOT / "tests" / "native"
EIGEN = next(
    (path for path in map(Path, ("/usr/include/eigen3", "/usr/local/include/eigen3")) if path.is_dir()), None
)
COMPILER, C_COMPILER = shutil.which("c++"), shutil.which("cc")
WARNINGS = ("-Wall", "-Wextra", "-Wshadow", "-Wpedantic", "-Werror")
MEMORY = ("-fsanitize=address", "-fsanitize=undefined")
THREADS = ("-fsanitize=thread", "-O1")

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or EIGEN is None or COMPILER is None or C_COMPILER is None,
    reason="needs a C++ compiler and Eigen",
)


def run(*words: str | Path | None) -> str:
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Path, tuple[str, str]], Path]:
    """Gives the object file of a source for a pair of sanitizers, compiled once."""
    folder = tmp_path_factory.mktemp("objects")

    def of(source: Path, sanitizers: tuple[str, str]) -> Path:
        path = folder / f"{source.stem}{sanitizers[0]}.o"
        if not path.exists():
            # most of the other sources' time would go into optimising Eigen
            level = "-O1" if source in FACTORISATION else "-O0"
            run(
                *(COMPILER, "-std=c++17", level, *WARNINGS, *sanitizers, "-fno-sanitize-recover=all"),
                *("-I", NATIVE, "-I", NATIVE / "include", "-isystem", EIGEN),
                *("-c", source, "-o", path),
            )
        return path

    return of


@pytest.fixture(scope="module")
def comparison(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The object file of the test of the factorisation: nearly all Eigen's code, without sanitizers quick."""
    path = tmp_path_factory.mktemp("comparison") / "cholesky_test.o"
    run(
        *(COMPILER, "-std=c++17", "-O1", *WARNINGS, "-I", NATIVE, "-isystem", EIGEN),
        *("-c", TESTS / "cholesky_test.cpp", "-o", path),
    )
    return path


@pytest.mark.parametrize(
    "sanitizers", [pytest.param(MEMORY, id="memory"), pytest.param(THREADS, id="threads")]
)
def test_factorisation(
    tmp_path: Path,
    compiled: Callable[[Path, tuple[str, str]], Path],
    comparison: Path,
    sanitizers: tuple[str, str],
) -> None:
    """Against dense factorisations; indefinite matrices; any number of threads; odd meshes; each kernel."""
    program = tmp_path / "cholesky_test"
    parts = [compiled(source, sanitizers) for source in FACTORISATION]
    run(COMPILER, *sanitizers, comparison, *parts, "-pthread", "-o", program)
    run(program)


def test_spoiled_arguments(tmp_path: Path, compiled: Callable[[Path, tuple[str, str]], Path]) -> None:
    """Missing arrays, sizes, indices and numbers that make no sense: a status each time, never a crash."""
    program, driver = tmp_path / "boundary_fuzz", tmp_path / "boundary_fuzz.o"
    run(
        *(C_COMPILER, "-std=c99", "-O1", *WARNINGS, *MEMORY, "-I", NATIVE / "include", WITH_CONSTANTS),
        *("-c", TESTS / "boundary_fuzz.c", "-o", driver),
    )
    objects = [compiled(source, MEMORY) for source in (*FACTORISATION, *FILM)]
    run(COMPILER, *MEMORY, driver, *objects, "-pthread", "-o", program)
    told = run(program, "1000")
    counts = [int(part.split()[0]) for part in told.split(",")]
    assert sum(counts) == 1000
    assert min(counts[:4]) > 20, told  # each of them was met
