# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver's C interface, used from C."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from solver_cases import needs_native

from BalloonWorkbench.core.solver import native

ROOT = Path(__file__).resolve().parents[2]
NATIVE = ROOT / "BalloonWorkbench" / "native"
LIBRARY = NATIVE / "lib" / "libfilm_solver.so"

pytestmark = [
    needs_native,
    pytest.mark.skipif(sys.platform != "linux", reason="the program is linked as on Linux"),
]


def run(*words: str | Path) -> str:
    ended = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended.stdout


def test_program_in_c(tmp_path: Path) -> None:
    """Compiles without a warning as C99, links, inflates a disc and meets each return code."""
    program = tmp_path / "small_disc"
    run(
        shutil.which("cc") or "cc",
        *("-std=c99", "-Wall", "-Wextra", "-Wshadow", "-Wpedantic", "-Werror", "-O1"),
        *("-I", NATIVE / "include", ROOT / "tests" / "native" / "small_disc.c"),
        *("-o", program, LIBRARY, f"-Wl,-rpath,{LIBRARY.parent}", "-lm"),
    )
    assert run(program).startswith("volume 0.15")


def test_only_the_interface_is_visible() -> None:
    """Nothing of Eigen or the C++ runtime: FreeCAD may bring others."""
    symbols = run("nm", "--dynamic", "--defined-only", "--format=posix", LIBRARY)
    names = {line.split()[0] for line in symbols.splitlines()}
    declared = re.findall(
        r"\b(film_\w+)\(", (NATIVE / "include" / "film_solver.h").read_text(encoding="utf-8")
    )
    assert names == set(declared)


def test_needs_no_cpp_runtime() -> None:
    needed = re.findall(r"NEEDED\s+(\S+)", run("objdump", "--private-headers", LIBRARY))
    assert needed
    assert not [name for name in needed if "stdc++" in name or "gcc_s" in name]


def test_header_and_python_agree_on_the_version() -> None:
    header = (NATIVE / "include" / "film_solver.h").read_text(encoding="utf-8")
    assert f"FILM_ABI_VERSION = {native.ABI_VERSION} " in header
