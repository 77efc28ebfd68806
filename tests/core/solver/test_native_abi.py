# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver's C interface, used from C."""

import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, film, needs_native

from BalloonWorkbench.core.errors import Cancelled
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.native import load

ROOT = Path(__file__).resolve().parents[3]
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
    assert f"FILM_ABI_VERSION = {load.ABI_VERSION} " in header


def test_cancel_does_not_wait_for_a_large_factorisation() -> None:
    """Processor time counts: other programs may keep the clock busy."""
    outline = NAMED["disc"]
    large = triangulate(outline, size_for(outline, 12000))
    asked: list[float] = []
    stopped_at = 0.0

    def stop_amid_first_step(fraction: float, text: str) -> bool:
        nonlocal stopped_at
        asked.append(fraction)
        stopped_at = time.process_time()
        return False

    with pytest.raises(Cancelled):
        inflate(large, film(100), PRESSURE, backend="native", progress=stop_amid_first_step)
    assert asked == [0.0]
    assert time.process_time() - stopped_at < 0.1
