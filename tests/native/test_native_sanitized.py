# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C interface of the native solver, under sanitizers."""

from pathlib import Path

import pytest
from programs import (
    C_COMPILER,
    COMPILER,
    FACTORISATION,
    FILM,
    MEMORY,
    NATIVE,
    TESTS,
    WARNINGS,
    WITH_CONSTANTS,
    compiled,
    needs_compiler,
    run,
)

pytestmark = needs_compiler


@pytest.mark.slow
def test_spoiled_arguments(tmp_path: Path) -> None:
    """Missing arrays, sizes, indices and numbers that make no sense: a status each time, never a crash."""
    program, driver = tmp_path / "boundary_fuzz", tmp_path / "boundary_fuzz.o"
    run(
        *(C_COMPILER, "-std=c99", "-O1", *WARNINGS, *MEMORY, "-I", NATIVE / "include", WITH_CONSTANTS),
        *("-c", TESTS / "boundary_fuzz.c", "-o", driver),
    )
    objects = [compiled(source, MEMORY) for source in (*FACTORISATION, *FILM)]
    run(COMPILER, *MEMORY, driver, *objects, "-pthread", "-o", program)
    report = run(program, "1000")
    counts = [int(part.split()[0]) for part in report.split(",")]
    assert sum(counts) == 1000
    assert min(counts[:4]) > 20, report  # each of them was met
