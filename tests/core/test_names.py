# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names say what they hold: words that fit everything are not among them."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import BalloonWorkbench

PACKAGE = Path(BalloonWorkbench.__file__).parent
LAYERS = ["core", "app", "gui", "cli"]

#: They fit a radius as well as a list of files, a report, or the options of a pattern.
VAGUE = {"found", "told", "tell", "wanted", "given"}


_NAMED = (
    ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.ExceptHandler | ast.MatchAs | ast.MatchStar
)


def names_bound(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """The line and the name of each variable, field, parameter, function, class and import."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.lineno, node.id if isinstance(node, ast.Name) else node.attr
        elif isinstance(node, ast.arg):
            yield node.lineno, node.arg
        elif isinstance(node, _NAMED) and node.name:
            yield node.lineno, node.name
        elif isinstance(node, ast.Import | ast.ImportFrom):
            yield from ((node.lineno, alias.asname or alias.name) for alias in node.names)


def vague(source: str) -> list[tuple[int, str]]:
    return [(line, name) for line, name in names_bound(ast.parse(source)) if name.strip("_").lower() in VAGUE]


@pytest.mark.parametrize("layer", LAYERS)
def test_names_say_what_they_hold(layer: str) -> None:
    files = sorted((PACKAGE / layer).rglob("*.py"))
    assert files
    assert not [
        f"{path.relative_to(PACKAGE)}:{line} {name}"
        for path in files
        for line, name in vague(path.read_text(encoding="utf-8"))
    ]


@pytest.mark.parametrize(
    "source",
    [
        "found = 1",
        "found: int = 1",
        "for told in (): pass",
        "a = [b for given in ()]",
        "(x, *wanted) = 1, 2",
        "def tell(): pass",
        "def f(*given): pass",
        "f = lambda wanted: 0",
        "self._told = 0",
        "with f() as found: pass",
        "if (found := f()): pass",
        "from a import b as told",
        "class A:\n    wanted: int",
        "try: pass\nexcept E as found: pass",
        "match a:\n    case [*found]: pass",
    ],
)
def test_a_vague_name_is_seen_wherever_it_is_bound(source: str) -> None:
    assert len(vague(source)) == 1


def test_what_others_call_so_is_free() -> None:
    assert not vague("f(wanted=1); a = b.found; c = 'told'; well_given = 1")
