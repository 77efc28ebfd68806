# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finished results are those of the exact request, whatever was asked before."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from test_house import layer, named, tree

from BalloonWorkbench.core.arcs import fit_arcs as arcs
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.memoize import forget, hand_over, memoized, results
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Request:
    """A request as a value."""

    points: Floats
    size: float | None = None
    path: str = field(default="", compare=False)


def test_every_bit_of_a_request_counts() -> None:
    asked: list[object] = []

    @memoized(most=100)
    def echo(request: object, progress: object = None) -> int:
        asked.append(request)
        return len(asked)

    base = np.arange(6.0).reshape(3, 2)
    different = [
        Request(base),
        Request(base + 1e-16 * np.eye(3, 2)),
        Request(np.nextafter(base, 9.0)),
        Request(-0.0 * base),
        Request(0.0 * base),
        Request(base.ravel()),
        Request(base.astype(np.float32)),
        Request(base, 1.0),
        Request(base, np.nextafter(1.0, 2.0)),
        (base, 1.0),
        ((base,), 1.0),
        (1, 1.0, True, "1", b"1", None),
        (1.0, 1, True, "1", b"1", None),
        ("ab", "c"),
        ("a", "bc"),
    ]
    answers = [echo(request) for request in different]
    equal = [np.array_equal(different[0].points, different[1].points)]  # type: ignore[attr-defined]
    assert len(set(answers)) == len(different) - sum(equal)
    assert [echo(request, progress=print) for request in different] == answers
    assert echo(replace(different[0], path="elsewhere")) == answers[0]  # type: ignore[type-var]
    assert echo.knows(different[-1])
    forget()
    assert not echo.knows(different[-1])


def test_results_are_handed_over_to_another_process() -> None:
    """Also to functions that are loaded after that; what was asked there is not worked out again."""
    calls: list[int] = []

    def double(number: int) -> int:
        calls.append(number)
        return 2 * number

    first = memoized(most=2)(double)
    first(4)
    known = {name: kept for name, kept in results().items() if name == first.name}
    forget()
    hand_over(known)
    assert [first(4), memoized(most=2)(double)(4), calls] == [8, 8, [4]]
    assert [first(5), calls] == [10, [4, 5]]
    forget()
    assert [memoized(most=2)(double)(4), calls] == [8, [4, 5, 4]]


def test_what_is_no_value_is_refused() -> None:
    with pytest.raises(TypeError, match="no value"):
        memoized(most=1)(lambda value: value)(object())


def test_the_oldest_go_and_errors_are_not_kept() -> None:
    calls: list[int] = []

    @memoized(most=2)
    def half(number: int) -> float:
        calls.append(number)
        if number < 0:
            raise ValueError
        return number / 2

    assert [half(number) for number in (1, 2, 2, 3, 1)] == [0.5, 1.0, 1.0, 1.5, 0.5]
    assert calls == [1, 2, 3, 1]
    for _ in range(2):
        with pytest.raises(ValueError):
            half(-1)
    assert calls[-2:] == [-1, -1]


def test_a_curve_does_not_depend_on_those_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same polyline a trillionth of its size away, or shifted, asked for before: nothing changes."""
    turn = np.linspace(0.0, 2.0 * np.pi, 90, endpoint=False)
    points = np.column_stack([0.1 * np.cos(turn) + 0.01 * np.cos(5.0 * turn), 0.07 * np.sin(turn)])
    alone = fit_curve(points, True)
    for other in (points + 3e-12 * np.sin(9.0 * turn)[:, None], points + np.array([0.1234567, 1.0 / 3.0])):
        forget()
        fit_curve(other, True)
        again = fit_curve(points, True)
        assert np.array_equal(again.joints, alone.joints)
        assert np.array_equal(again.bulges, alone.bulges)
    monkeypatch.setattr(arcs, "_fit", None)
    copy = fit_curve(points + np.array([0.5, -0.25]), True)  # copies are alike, and found once
    assert np.allclose(copy.joints - alone.joints, (0.5, -0.25), rtol=0.0, atol=1e-15)


def test_there_is_no_other_memory() -> None:
    """What is cached elsewhere is one of a few things, made once: data files, icons, packages."""
    bounded = [
        f"{named(path)}: {node.name}"
        for path in layer()
        for node in ast.walk(tree(path))
        if isinstance(node, ast.FunctionDef)
        for decorator in node.decorator_list
        if re.search(r"lru_cache\((?!maxsize=1\))", ast.unparse(decorator))
    ]
    assert not bounded
