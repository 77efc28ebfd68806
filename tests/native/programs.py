# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs in C and C++ that tests compile from the native solver's sources, under sanitizers."""

import functools
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from BalloonWorkbench.core.solver.native.c_interface import CONSTANTS

TESTS = Path(__file__).resolve().parent
NATIVE = TESTS.parents[1] / "BalloonWorkbench" / "native"
FACTORISATION = sorted((NATIVE / "cholesky" / "src").glob("*.cpp"))
FILM = sorted((NATIVE / "film").glob("*.cpp"))
EIGEN = next(
    (path for path in map(Path, ("/usr/include/eigen3", "/usr/local/include/eigen3")) if path.is_dir()), None
)
COMPILER, C_COMPILER = shutil.which("c++"), shutil.which("cc")
WARNINGS = ("-Wall", "-Wextra", "-Wshadow", "-Wpedantic", "-Werror")
MEMORY = ("-fsanitize=address", "-fsanitize=undefined")
THREADS = ("-fsanitize=thread", "-O1")
#: What Python hands over, for programs in C.
WITH_CONSTANTS = f"-DCONSTANTS={','.join(map(repr, CONSTANTS.values()))}"

needs_compiler = pytest.mark.skipif(
    sys.platform != "linux" or EIGEN is None or COMPILER is None or C_COMPILER is None,
    reason="needs a C++ compiler and Eigen",
)
_folder = tempfile.TemporaryDirectory()


def folder() -> Path:
    """Where the objects are, until Python ends."""
    return Path(_folder.name)


def run(*words: str | Path | None) -> str:
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


@functools.cache
def compiled(source: Path, sanitizers: tuple[str, str]) -> Path:
    """The object file of a source for a pair of sanitizers."""
    path = folder() / f"{source.stem}{sanitizers[0]}.o"
    # the factorisation needs no Eigen; most of the film's time would go into optimising it
    options = ("-O0", "-I", NATIVE / "include", "-isystem", EIGEN) if source in FILM else ("-O1",)
    run(
        *(COMPILER, "-std=c++17", *WARNINGS, *sanitizers, "-fno-sanitize-recover=all"),
        *("-I", NATIVE, *options, "-c", source, "-o", path),
    )
    return path
