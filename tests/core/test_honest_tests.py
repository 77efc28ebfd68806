# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests can fail: each checks something, whatever branch it takes, and no check is true of itself."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
#: What fails a test without `assert`.
_CHECKS = {"raises", "warns", "fail", "assert_allclose", "assert_array_equal", "check_call", "check_output"}


@cache
def trees() -> dict[str, ast.Module]:
    """Every Python file of the tests; calls of what is tested have lost their names: they check nothing."""
    parsed = {}
    for path in sorted(TESTS.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
        tested = {
            alias.asname or alias.name
            for node in imports
            if str(node.module).startswith("BalloonWorkbench")
            for alias in node.names
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and first_name(node.func) in tested:
                node.func = ast.Constant(None)
        parsed[str(path.relative_to(TESTS))] = tree
    return parsed


def first_name(node: ast.AST) -> str:
    """`a` of a.b.c, empty for what is no name."""
    while isinstance(node, ast.Attribute):
        node = node.value
    return getattr(node, "id", "")


def called(node: ast.AST) -> str:
    """Name of the function or method that is called, empty where none is."""
    return getattr(node.func, "id", getattr(node.func, "attr", "")) if isinstance(node, ast.Call) else ""


def functions(tree: ast.AST) -> Iterator[ast.FunctionDef]:
    yield from (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))


def inside(node: ast.AST) -> Iterator[ast.AST]:
    """A node and what is in it, in the order of the text, without functions that are defined there."""
    yield node
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, (ast.FunctionDef, ast.Lambda, ast.ClassDef)):
            yield from inside(child)


@cache
def checkers() -> dict[str, set[str]]:
    """By file, the functions that fail a test when something is wrong, by themselves or through others.

    A name is that of the file's own function, else of one that has this name in another file.
    """
    does = {
        name: [(each.name, *what_is_in(each)) for each in functions(tree)] for name, tree in trees().items()
    }
    written = {name: {function for function, _, _ in each} for name, each in does.items()}
    own: dict[str, set[str]] = {name: set() for name in does}
    while True:
        everywhere = _CHECKS.union(*own.values())
        known = {name: (everywhere - written[name]) | own[name] for name in does}
        for name, each in does.items():
            own[name] |= {function for function, fails, calls in each if fails or calls & known[name]}
        if everywhere == _CHECKS.union(*own.values()):
            return known


def what_is_in(function: ast.FunctionDef) -> tuple[bool, set[str]]:
    """Whether a function fails by itself, and what it calls."""
    nodes = list(ast.walk(function))
    return any(is_check(node, set()) for node in nodes), {called(node) for node in nodes} - {""}


def is_check(node: ast.AST, known: set[str]) -> bool:
    if isinstance(node, ast.Call) and any(
        word.arg == "check" and getattr(word.value, "value", False) is True for word in node.keywords
    ):
        return True  # subprocess.run(..., check=True)
    return isinstance(node, (ast.Assert, ast.Raise)) or called(node) in known


def checks(statements: list[ast.stmt], known: set[str]) -> bool:
    """Whether something is checked on every way through these statements."""
    for statement in statements:
        if isinstance(statement, ast.Return):
            return statement.value is not None and is_checked(statement.value, known)
        if isinstance(statement, ast.Continue):
            return False
        if isinstance(statement, (ast.If, ast.Try, ast.For, ast.While, ast.With)):
            if checks_inside(statement, known):
                return True
        elif not isinstance(statement, ast.FunctionDef) and is_checked(statement, known):
            return True
    return False


def checks_inside(statement: ast.If | ast.Try | ast.For | ast.While | ast.With, known: set[str]) -> bool:
    """The same for a statement that has others in it."""
    if isinstance(statement, ast.If):
        both = checks(statement.body, known) and checks(statement.orelse, known)
        return both or is_checked(statement.test, known)
    if isinstance(statement, ast.Try):
        all_ways = checks([*statement.body, *statement.orelse], known)
        all_ways = all_ways and all(checks(handler.body, known) for handler in statement.handlers)
        return all_ways or checks(statement.finalbody, known)
    heads = [statement.iter] if isinstance(statement, ast.For) else []
    heads += [item.context_expr for item in getattr(statement, "items", [])]
    return any(is_checked(head, known) for head in heads) or checks(statement.body, known)


def is_checked(node: ast.AST, known: set[str]) -> bool:
    return any(is_check(each, known) for each in inside(node))


def leaves_early(function: ast.FunctionDef, known: set[str]) -> bool:
    """Whether a test may return, or pass over all rounds of a loop, without having checked anything."""
    places = [node.lineno for node in inside(function) if is_check(node, known)]
    ends = [each.end_lineno or 0 for each in function.body if isinstance(each, (ast.For, ast.While))]
    for node in inside(function):
        if isinstance(node, (ast.Return, ast.Continue)) and not any(place < node.lineno for place in places):
            loop = next((end for end in ends if end >= node.lineno), None)
            if isinstance(node, ast.Return) or not any(place > (loop or node.lineno) for place in places):
                return True
    return False


def true_of_itself(node: ast.Assert) -> bool:
    test = node.test
    if (
        isinstance(test, ast.Compare)
        and len(test.ops) == 1
        and isinstance(test.ops[0], (ast.Eq, ast.Is, ast.LtE))
    ):
        return ast.dump(test.left) == ast.dump(test.comparators[0]) and not any(
            isinstance(each, ast.Call) for each in ast.walk(test)
        )
    if isinstance(test, ast.BoolOp) and isinstance(test.op, ast.Or):
        return any(isinstance(value, ast.Constant) and value.value for value in test.values)
    return isinstance(test, (ast.Constant, ast.JoinedStr, ast.Tuple)) and bool(getattr(test, "value", True))


def written_tests() -> list[tuple[str, ast.FunctionDef, set[str]]]:
    return [
        (f"{name}::{function.name}", function, checkers()[name])
        for name, tree in trees().items()
        if Path(name).name.startswith("test_")
        for function in functions(tree)
        if function.name.startswith("test_")
    ]


def test_every_test_checks_something() -> None:
    assert len(written_tests()) > 500
    assert not [name for name, function, known in written_tests() if not checks(function.body, known)]


def test_no_test_returns_in_silence() -> None:
    assert not [name for name, function, known in written_tests() if leaves_early(function, known)]


def test_no_check_is_true_of_itself() -> None:
    assert not [
        f"{name}:{node.lineno}"
        for name, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Assert) and true_of_itself(node)
    ]


@pytest.mark.parametrize(
    ("code", "honest"),
    [
        ("assert f() == 1", True),
        ("f()", False),
        ("if f():\n  assert g()", False),
        ("if f():\n  return\nassert g()", False),
        ("for x in f():\n  if x:\n    continue\n  assert x", False),
        ("for x in f():\n  assert x", True),
        ("try:\n  assert f()\nexcept ValueError:\n  pass", False),
        ("with raises(ValueError):\n  f()", True),
        ("def g():\n  assert x\nf(g)", False),
    ],
)
def test_what_is_honest(code: str, honest: bool) -> None:
    """The judge itself, on cases that are known."""
    function = ast.FunctionDef(
        "test", ast.arguments([], [], None, [], [], None, []), ast.parse(code).body, []
    )
    assert (checks(function.body, _CHECKS) and not leaves_early(function, _CHECKS)) == honest
