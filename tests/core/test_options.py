# SPDX-License-Identifier: LGPL-2.1-or-later
"""One declaration for each option: what the engine, the command line and the documentation say follows."""

from __future__ import annotations

import argparse
import ast
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import pytest
from test_house import tree

from BalloonWorkbench.cli.options import help_text, parser, typed
from BalloonWorkbench.core.artwork.border import BLEED
from BalloonWorkbench.core.artwork.sheet import DPI
from BalloonWorkbench.core.assembly_sheet.page import PAGES
from BalloonWorkbench.core.film.filling import Filling, gases
from BalloonWorkbench.core.film.film import JOININGS, Film
from BalloonWorkbench.core.film.library import films
from BalloonWorkbench.core.job import DEFAULT_PRESSURE, Settings
from BalloonWorkbench.core.machines.bed import OVERSIZE
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.writers.pdf import TILES
from BalloonWorkbench.core.nesting.layout import GrainRule, Stock
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.core.options.film import DEFAULT_FILM, FilmOptions, MaterialOptions
from BalloonWorkbench.core.options.option import Kind, Option, options_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions
from BalloonWorkbench.core.options.table import DECLARED, options
from BalloonWorkbench.core.outline.chambers import PASSAGE
from BalloonWorkbench.core.outline.symmetry import CHOICES
from BalloonWorkbench.core.pattern.intake.kinds import intake_kinds
from BalloonWorkbench.core.pattern.intake.places import PLACES
from BalloonWorkbench.core.results.result_files import FORMATS
from BalloonWorkbench.core.solver.backend import SOLVERS
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.tracing.segment import DRAWN_AS

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "tools"))
PACKAGE = ROOT / "BalloonWorkbench"
KNOWN = {
    (declaring.__name__, option.name): option for declaring in DECLARED for option in options_of(declaring)
}
#: Files of other programs and of ours have names of their own for what a film is.
OF_FILES = {"app/properties/material.py": "FreeCAD's material cards"}


@pytest.mark.parametrize("option", options(), ids=lambda option: option.flag_name or option.property_name)
def test_an_option_says_what_it_is(option: Option) -> None:
    assert re.fullmatch(r"[A-Z].*[^.]", option.text)
    assert option.flag_name or option.property_name
    assert not option.label or option.property_name
    if option.kind is Kind.CHOICE and option.property_name and option.prop != "Film":
        assert next(iter(option.titles)) == option.default, "an enumeration begins with its first entry"
        assert all(option.value(option.title(value)) == value for value in option.titles)
    if option.flag_name:
        assert help_text(option)


def test_names_are_there_once() -> None:
    """On the command line, and in a macro: but for the weld of the film, see app/properties/values.py."""
    flags = [option.flag_name for option in options() if option.flag_name]
    assert len(flags) == len(set(flags)) > 50
    names = [option.api_name for option in options() if option.property_name]
    assert sorted(name for name in set(names) if names.count(name) > 1) == ["seal_width"]


def test_the_engine_begins_with_what_is_declared() -> None:
    settings, filling = Settings(), Filling()
    for made, declaring in (
        (settings, InflationOptions),
        (settings, ReadingOptions),
        (settings.pattern, PatternOptions),
        (settings.model, ModelOptions),
        (Model(), ModelOptions),
    ):
        for option in options_of(declaring):
            assert getattr(made, option.name) == option.default, option.name
    assert filling.gas.name == KNOWN["FillingOptions", "gas"].default
    for name in ("gas_temperature", "air_temperature", "altitude"):
        assert getattr(filling, name) == KNOWN["FillingOptions", name].default
    defaults = {
        ("InflationOptions", "pressure"): DEFAULT_PRESSURE,
        ("ReadingOptions", "passage"): PASSAGE,
        ("ArtworkOptions", "bleed"): BLEED,
        ("ArtworkOptions", "dpi"): DPI,
        ("SheetOptions", "spacing"): Stock(1.0).spacing,
        ("SheetOptions", "grain"): Stock(1.0).grain.value,
    }
    assert {key: KNOWN[key].default for key in defaults} == defaults
    assert settings.film.name == options_of(MaterialOptions)[0].begins == DEFAULT_FILM
    assert {option.name for option in options_of(FilmOptions)} <= {item.name for item in fields(Film)}
    width = KNOWN["PatternOptions", "intake_width"]
    assert width.begins == intake_kinds()[PatternOptions().intake_kind].width


@pytest.mark.parametrize(
    ("declaring", "name", "known"),
    [
        ("ReadingOptions", "symmetry", CHOICES),
        ("ReadingOptions", "drawn_as", DRAWN_AS),
        ("FillingOptions", "gas", gases()),
        ("MaterialOptions", "material", films()),
        ("FilmOptions", "joining", JOININGS),
        ("InflationOptions", "backend", (None, *SOLVERS)),
        ("PatternOptions", "intake_kind", intake_kinds()),
        ("PatternOptions", "intake_place", PLACES),
        ("MachineOptions", "machine", machines()),
        ("MachineOptions", "oversize", OVERSIZE),
        ("MachineOptions", "tiled", TILES),
        ("ResultOptions", "results", FORMATS),
        ("SheetOptions", "grain", [grain.value for grain in GrainRule]),
        ("AssemblyOptions", "assembly", PAGES),
    ],
)
def test_what_may_be_chosen_is_what_the_engine_knows(declaring: str, name: str, known: object) -> None:
    assert set(KNOWN[declaring, name].titles) == set(known)  # type: ignore[call-overload]


def read(*words: str) -> argparse.Namespace:
    return parser().parse_args(["design", "heart.png", "--out", "out", *words])


def test_what_is_typed_is_what_the_engine_gets() -> None:
    """Units, what stands for a yes or no too, what is left to the engine; nothing typed is the default."""
    for declaring in DECLARED:
        for option in options_of(declaring):
            if option.flag_name and not isinstance(option.default, tuple) and not option.switch:
                assert getattr(typed(read(), declaring), option.name) == option.default, option.name
    assert typed(read(), PatternOptions) == PatternOptions()
    words = "--seal-width 4mm --notches 6 --notch-depth 0.1in --mirror --tie-tab 90 --intake film-valve"
    wanted = PatternOptions(
        seal_width=0.004,
        notches=6,
        notch_depth=pytest.approx(0.00254),
        mirror=True,
        tie_tab=True,
        tie_tab_angle=pytest.approx(1.5707963),
        intake_kind="film-valve",
    )
    assert typed(read(*words.split()), PatternOptions) == wanted
    none = typed(read("--intake", "none", "--tie-tab", "--seal-width", "0mm"), PatternOptions)
    assert none == PatternOptions(intake=False, tie_tab=True)
    model = typed(
        read(
            "--plain-shell", "--no-bending", "--two-panels", "--bending-floor", "1e-5", "--weld", "crumpled"
        ),
        ModelOptions,
    )
    assert model == ModelOptions(False, False, 1e-5, True, "crumpled")


def naming(path: Path, names: set[str]) -> Iterator[str]:
    """Where a file names an option for another reason than to use its value."""
    told = {id(node.value) for node in ast.walk(tree(path)) if isinstance(node, ast.Expr)}
    whole = re.compile(rf"(?<![\w-])({'|'.join(map(re.escape, names))})(?![\w])")
    for node in ast.walk(tree(path)):
        text = isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in told
        if (
            (text and whole.search(str(node.value)))  # type: ignore[attr-defined]
            or (isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and node.attr in names)
            or (isinstance(node, ast.keyword) and node.arg in names)
            or (
                isinstance(node, ast.AnnAssign)
                and ast.unparse(node.target) in names
                and isinstance(node.value, ast.Constant)
            )
        ):
            yield f"{path.name}:{getattr(node, 'lineno', getattr(getattr(node, 'value', None), 'lineno', 0))}"


@pytest.mark.parametrize(
    ("names", "least"),
    [
        ({"notch_depth", "NotchDepth", "notch-depth", "--notch-depth"}, 1),
        ({"seal_width", "SealWidth", "seal-width", "--seal-width"}, 5),
    ],
)
def test_an_option_is_named_where_it_acts_alone(names: set[str], least: int) -> None:
    """Files that name it for any other reason than to use its value: none."""
    paths = [path for path in sorted(PACKAGE.rglob("*.py")) if path.parent != PACKAGE / "core" / "options"]
    used = min(names, key=lambda name: (not name.islower() or "-" in name, name))
    assert sum(f".{used}" in path.read_text(encoding="utf-8") for path in paths) >= least
    found = {
        str(path.relative_to(PACKAGE)): [*naming(path, names)]
        for path in paths
        if str(path.relative_to(PACKAGE)) not in OF_FILES
    }
    # the film's own weld, from its data file
    found.pop("core/film/library.py", None)
    assert {name: lines for name, lines in found.items() if lines} == {}


ADDED = """    sparkle: float = MARKS(Kind.LENGTH, 0.0025, "How wide the glitter is strewn", label="Glitter")
"""


def test_one_entry_adds_an_option(tmp_path: Path) -> None:
    """On the command line with help, unit and default, in the engine, in report and documentation."""
    shutil.copytree(
        PACKAGE, tmp_path / "BalloonWorkbench", ignore=shutil.ignore_patterns("__pycache__", "lib")
    )
    (tmp_path / "resources").symlink_to(ROOT / "resources")
    shutil.copy(ROOT / "package.xml", tmp_path)
    declared = tmp_path / "BalloonWorkbench" / "core" / "options" / "pattern.py"
    text = declared.read_text(encoding="utf-8")
    declared.write_text(text.replace("    tie_tab: bool", f"{ADDED}    tie_tab: bool", 1), encoding="utf-8")
    program = """
from BalloonWorkbench.cli.options import parser, typed, help_text
from BalloonWorkbench.core.options.option import options_of, unusual
from BalloonWorkbench.core.options.pattern import PatternOptions
words = ["design", "a.png", "--out", "out"]
print(typed(parser().parse_args(words), PatternOptions).sparkle)
made = typed(parser().parse_args([*words, "--sparkle", "7mm"]), PatternOptions)
print(unusual(made))
option = next(option for option in options_of(PatternOptions) if option.name == "sparkle")
print(help_text(option), option.property_name, option.api_name)
"""
    ended = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert ended.stdout.splitlines() == [
        "0.0025",
        "{'sparkle': 0.007}",
        "How wide the glitter is strewn (default 2.5mm) Sparkle sparkle",
    ], ended.stderr


@pytest.mark.parametrize("name", ["command-line.md", "api.md", "studies.md"])
def test_documentation_has_the_table(name: str) -> None:
    """tools/option_tables.py writes it."""
    import option_tables

    path = ROOT / "docs" / name
    assert option_tables.renewed(path) == path.read_text(encoding="utf-8")
    assert option_tables.TABLES[name]().count("\n") > 20
