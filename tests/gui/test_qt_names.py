# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our widgets keep what Qt calls by name: an attribute `width` would stand in place of the method width()."""

import ast
from pathlib import Path

from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets

PACKAGE = Path(__file__).resolve().parents[2] / "BalloonWorkbench" / "gui"
MODULES = {"QtCore": QtCore, "QtGui": QtGui, "QtWidgets": QtWidgets}


def given(owner):
    """Names of attributes that a class gives its instances."""
    for node in ast.walk(owner):
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        for target in targets:
            for each in target.elts if isinstance(target, ast.Tuple) else [target]:
                if isinstance(each, ast.Attribute) and getattr(each.value, "id", "") == "self":
                    yield each.attr


def test_no_attribute_hides_a_method_of_qt():
    hidden, classes = [], 0
    for path in sorted(PACKAGE.rglob("*.py")):
        for owner in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for base in owner.bases if isinstance(owner, ast.ClassDef) else ():
                module = MODULES.get(getattr(getattr(base, "value", None), "id", ""))
                if module is not None:
                    classes += 1
                    known = dir(getattr(module, base.attr))
                    hidden += [f"{path.name}: {owner.name}.{name}" for name in given(owner) if name in known]
    assert classes > 20
    assert not hidden
