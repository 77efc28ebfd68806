# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native solver's C interface, used from C."""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from drawn_shapes import NAMED
from solver_cases import PRESSURE, WITH_CONSTANTS, film, needs_native

from BalloonWorkbench.core.errors import Cancelled, SolverError
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.solver.native.c_interface import CONSTANTS

ROOT = Path(__file__).resolve().parents[4]
NATIVE = ROOT / "BalloonWorkbench" / "native"
LIBRARY = NATIVE / "lib" / "libfilm_solver.so"
#: Numbers of the formulas of the element, beside those that every formula has.
ELASTICITY = {"dkt.h": {"1.5", "3.0"}}

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
        *("-I", NATIVE / "include", WITH_CONSTANTS, ROOT / "tests" / "native" / "small_disc.c"),
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


def test_constants_are_declared_once() -> None:
    """In Python, which hands them over: each is a field of the header in its place; C++ has none of its own.

    What is left in the sources of the iteration are halves, powers of two and guards against zero.
    """
    header = (NATIVE / "include" / "film_solver.h").read_text(encoding="utf-8")
    body = re.search(r"typedef struct \{([^}]*)\} film_constants;", header)
    assert body is not None
    fields = [
        (name, kind)
        for kind, names in re.findall(r"(double|int32_t) ([\w, ]+);", body[1])
        for name in names.split(", ")
    ]
    kinds = {float: "double", int: "int32_t"}
    assert fields == [(name, kinds[type(value)]) for name, value in CONSTANTS.items()]

    harmless = {"0.0", "1.0", "0.5", "0.25", "2.0", "4.0", "6.0", "1e-300"}
    for source in sorted((NATIVE / "film").glob("*")):
        text = re.sub(r"//.*|\bkPi = [\d.]+", "", source.read_text(encoding="utf-8"))
        numbers = set(re.findall(r"(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?|(?<![\w.])\d+e[-+]?\d+", text))
        assert numbers <= harmless | ELASTICITY.get(source.name, set()), source.name


@pytest.mark.parametrize("name", sorted(CONSTANTS))
def test_each_constant_reaches_the_native_solver(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A value that makes no sense is refused by it."""
    monkeypatch.setitem(CONSTANTS, name, 0 if isinstance(CONSTANTS[name], int) else 0.0)
    with pytest.raises(SolverError, match="constant"):
        inflate(
            triangulate(NAMED["disc"], size_for(NAMED["disc"], 60)), film(100), PRESSURE, backend="native"
        )


SHORT_OF_MEMORY = """
import resource, sys
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.solver.inflate import inflate
from solver_cases import PRESSURE, film, panel
large = panel("disc", 6000)
inflate(panel("disc", 60), film(100), PRESSURE, backend="native")  # loads what is loaded once
pages = int(open("/proc/self/statm").read().split()[0])
limit = pages * resource.getpagesize() + int(sys.argv[1])
resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
try:
    inflate(large, film(100), PRESSURE, backend="native")
except MemoryError as error:
    print("MemoryError:", error)
"""


def test_too_little_memory_is_no_fault_of_the_outline() -> None:
    """It arrives as Python's own error, for which the borders have a sentence."""
    paths = os.pathsep.join([str(ROOT), str(ROOT / "tests" / "core")])
    environment = os.environ | {"PYTHONPATH": paths, "OPENBLAS_NUM_THREADS": "1"}
    ended = subprocess.run(
        [sys.executable, "-c", SHORT_OF_MEMORY, "8000000"],
        capture_output=True,
        text=True,
        check=False,
        env=environment,
    )
    assert ended.stdout == "MemoryError: out of memory\n", ended.stderr


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
