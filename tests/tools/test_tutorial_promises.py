# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each sentence of the tutorial is held by the window test that plays it, and no other is."""

import ast
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).resolve().parents[1] / "users"))

from promises import BEYOND, TUTORIAL, sentences

_PLAYED = sorted((TUTORIAL.parents[1] / "tests" / "users").glob("test_tutorial*.py"))


def held():
    """What these tests say, word for word."""
    trees = [ast.parse(path.read_text(encoding="utf-8")) for path in _PLAYED]
    calls = [node for tree in trees for node in ast.walk(tree) if isinstance(node, ast.Call)]
    return [
        call.args[0].value for call in calls if isinstance(call.func, ast.Name) and call.func.id == "says"
    ]


@pytest.mark.slow
def test_every_sentence_of_the_tutorial_is_played():
    assert sorted(held()) == sorted(set(held())), "said twice"
    assert [told for told in sentences() if told not in (*held(), *BEYOND)] == []
    assert [told for told in (*held(), *BEYOND) if told not in sentences()] == []
