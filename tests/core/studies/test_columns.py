# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a study are the options of the command line, and mean the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from BalloonWorkbench.cli.options import parser
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.table import options
from BalloonWorkbench.core.studies.columns import column_named, columns
from BalloonWorkbench.core.studies.results import RESULTS

HERE = Path(__file__).parent


def test_every_option_of_the_command_line_is_a_column() -> None:
    flags = {option.flag_name.lstrip("-") for option in options() if option.flag_name}
    assert {*columns()} == flags | {"input", "command"}


def test_results_have_names_of_their_own() -> None:
    assert not {*columns()} & {result.name for result in RESULTS}


@pytest.mark.parametrize(
    ("name", "written", "arguments", "meaning"),
    [
        ("width", "30cm", ("--width=30cm",), 0.3),
        ("width", 0.25, ("--width=0.25",), 0.25),
        ("pressure", "2000", ("--pressure=2000",), None),  # as it is without
        ("pressure", "2kPa", ("--pressure=2kPa",), None),
        ("pressure", "-3", ("--pressure=-3",), -3.0),
        ("gores", 8.0, ("--gores=8",), 8),
        ("target-lift", "5", ("--target-lift=5",), 0.005),
        ("no-bending", "yes", ("--no-bending",), True),
        ("no-bending", False, (), None),
        ("mesh-size", "", (), None),
        ("solver", "numpy", ("--solver=numpy",), "numpy"),
        ("machine", "a; b", ("--machine=a", "--machine=b"), ["a", "b"]),
        ("machine", ["a"], ("--machine=a",), ["a"]),
    ],
)
def test_a_value_means_what_it_does_on_the_command_line(
    name: str, written: object, arguments: tuple[str, ...], meaning: object
) -> None:
    value = column_named(name).read(written, HERE)
    assert value.arguments == arguments
    assert value.meaning == (pytest.approx(meaning) if isinstance(meaning, float) else meaning)
    parser().parse_args(["design", "x", "--out=y", *value.arguments])


@pytest.mark.parametrize(
    ("name", "written"),
    [
        ("width", "wide"), ("width", True), ("gores", "2.5"), ("gores", "nan"), ("solver", "best"),
        ("no-bending", "perhaps"), ("width", [1]), ("accuracy", "inf"), ("command", "study"),
        ("artwork", "nothing.png"), ("input", "nothing.png"), ("input", "."), ("width", {"a": 1}),
    ],
)  # fmt: skip
def test_nonsense_is_told(name: str, written: object) -> None:
    with pytest.raises(InputError, match=r"[A-Za-z'].*\.$"):
        column_named(name).read(written, HERE)


def test_what_an_option_names_is_known_by_its_content(tmp_path: Path) -> None:
    for name in "ab":
        (tmp_path / f"{name}.png").write_bytes(b"1")
    first, second = (column_named("artwork").read(f"{name}.png", tmp_path).meaning for name in "ab")
    assert first == second
    (tmp_path / "b.png").write_bytes(b"22")
    assert column_named("artwork").read("b.png", tmp_path).meaning != first


@pytest.mark.parametrize("text", ["--seal-width", "Seal_Width", " seal width "])
def test_names_are_taken_as_people_write_them(text: str) -> None:
    assert column_named(text).name == "seal-width"


@pytest.mark.parametrize(
    ("text", "near"), [("pressures", "pressure"), ("widths", "width"), ("mesh", "mesh-size")]
)
def test_an_unknown_column_is_told_with_the_nearest(text: str, near: str) -> None:
    with pytest.raises(InputError, match=rf"'{text}'.*\b{near}\b"):
        column_named(text)
