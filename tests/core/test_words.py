# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people read: numbers with a few digits and no exponent, one word for one thing."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from BalloonWorkbench.core import units

PACKAGE = Path(units.__file__).resolve().parents[1]
#: These write numbers for programs: files of machines, macros, fingerprints, and the functions themselves.
FOR_PROGRAMS = (
    *("core/export/machine_*.py", "core/export/pdf_text.py", "core/export/vtu.py", "core/units.py"),
    *("core/rounded.py", "app/solve.py", "app/values.py", "app/film_sheet.py", "app/material.py"),
)
_FORM = re.compile(r"[^{}]*[efgEFG%]")


def numbers_formatted(tree: ast.AST) -> Iterator[int]:
    """Lines in which a number becomes text by a format of its own: f"{x:.3g}", "{:.0f} mm"."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FormattedValue) and isinstance(node.format_spec, ast.JoinedStr):
            last = node.format_spec.values[-1]
            if isinstance(last, ast.Constant) and _FORM.fullmatch(str(last.value)):
                yield node.lineno
        elif (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and re.search(r"{\w*:[^{}]*[efgEFG%]}", node.value)
        ):
            yield node.lineno


def test_numbers_become_text_in_one_place() -> None:
    """One rule for digits, exponents and units: core/units.py, with the user's units gui/user_units.py."""
    wrong = []
    for path in sorted(PACKAGE.rglob("*.py")):
        if not any(path.match(pattern) for pattern in FOR_PROGRAMS):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            name = path.relative_to(PACKAGE)
            wrong += [f"{name}:{line}" for line in sorted(set(numbers_formatted(tree)))]
    assert not wrong


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (1574.3, 3, "1574"),
        (297.44, 4, "297.4"),
        (0.0834, 2, "0.083"),
        (9.996, 3, "10"),
        (2.0, 3, "2"),
        (0.0, 3, "0"),
        (-0.0, 3, "0"),
        (-1e-12, 3, "0"),
        (-0.26, 3, "-0.26"),
        (4.9e9, 3, "4900000000"),
        (25e-6, 3, "0.000025"),
        (float("inf"), 3, "?"),
    ],
)
def test_numbers_have_the_digits_that_count(value: float, digits: int, text: str) -> None:
    assert units.number_text(value, digits) == text


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (units.length_text(1.574), "1574 mm"),
        (units.length_text(12.3456), "12.35 m"),
        (units.length_text(4e-6), "4 µm"),
        (units.length_text(0.0), "0 mm"),
        (units.size_text(0.3, 0.297, 0.0893), "300 x 297 x 89.3 mm"),
        (units.size_text(30.0, 9.0), "30 x 9 m"),
        (units.volume_text(1.2549e-3), "1.25 l"),
        (units.volume_text(4.7e-9), "4.7 mm³"),
        (units.volume_text(2400.0), "2400 m³"),
        (units.mass_text(9e-7), "0.9 mg"),
        (units.mass_text(0.0123), "12.3 g"),
        (units.mass_text(62.4), "62.4 kg"),
        (units.area_text(0.0931), "931 cm²"),
        (units.pressure_text(2000.0), "2 kPa"),
        (units.pressure_text(35.0), "35 Pa"),
        (units.percent_text(0.0034), "0.34 %"),
        (units.place_text(units.from_mm(units.np.array([-1e-9, 1234.56]))), "(0, 1235) mm"),
    ],
)
def test_measures_have_the_unit_that_people_use(text: str, wanted: str) -> None:
    assert text == wanted
