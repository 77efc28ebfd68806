# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver's sparse factorisation, from a program of its own that runs under the sanitizers."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "BalloonWorkbench" / "native" / "src"
TESTS = ROOT / "tests" / "native"
PARTS = (
    *("cholesky", "cholesky_plan", "front_kernels", "fronts", "minimum_degree", "ordering"),
    *("schedule", "separator", "workers"),
)
EIGEN = next(
    (path for path in map(Path, ("/usr/include/eigen3", "/usr/local/include/eigen3")) if path.is_dir()), None
)
COMPILER = shutil.which("c++")

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or EIGEN is None or COMPILER is None, reason="needs a C++ compiler and Eigen"
)


def run(*words: str | Path) -> None:
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout + ended.stderr


@pytest.mark.parametrize(
    ("all_code", "our_code"),
    [
        pytest.param("-fsanitize=address", "-fsanitize=undefined", id="memory"),
        pytest.param("-fsanitize=thread", "-O1", id="threads"),
    ],
)
def test_program(tmp_path: Path, all_code: str, our_code: str) -> None:
    """Against dense factorisations; indefinite matrices; any number of threads; odd meshes; each kernel.

    The test itself, nearly all Eigen's code, goes without the check for undefined behaviour: it would
    compile for half a minute.
    """
    flags = ("-std=c++17", "-O1", "-Wall", "-Wextra", "-Wshadow", "-Wpedantic", "-Werror", all_code)
    include = ("-I", SOURCES, "-isystem", EIGEN)
    objects = []
    for part in PARTS:
        objects.append(tmp_path / f"{part}.o")
        run(
            *(COMPILER, *flags, our_code, "-fno-sanitize-recover=all", *include),
            *("-c", SOURCES / f"{part}.cpp", "-o", objects[-1]),
        )
    program = tmp_path / "cholesky_test"
    run(
        *(COMPILER, *flags, *include, TESTS / "cholesky_test.cpp", *objects),
        *("-pthread", our_code, "-o", program),
    )
    run(program)
