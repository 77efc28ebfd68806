# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of Qt that our widgets keep or must not use."""

import ast
import enum
from pathlib import Path

import pytest

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


def values():
    """The names of the members of all enumerations of Qt, as QGraphicsView.FullViewportUpdate."""
    for module in MODULES.values():
        for owner in vars(module).values():
            for name, value in vars(owner).items() if isinstance(owner, type) else ():
                if isinstance(value, enum.EnumMeta):
                    yield from value.__members__
                elif hasattr(type(value), "values") and name[0].isupper():
                    yield name


@pytest.mark.slow
def test_values_of_qt_are_named_by_their_class():
    """self.FullViewportUpdate is none in Qt 6: AttributeError, in whatever line comes to it first."""
    known = set(values()) - {"Object"}  # what views of FreeCAD are called for
    assert len(known) > 1000
    by_object = [
        f"{path.name}:{node.lineno} {ast.unparse(node)}"
        for folder in (PACKAGE, Path(__file__).parent)
        for path in sorted(folder.rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute)
        and node.attr in known
        and ast.unparse(node.value) in ("self", "event")
    ]
    assert not by_object


def test_no_attribute_hides_a_method_of_qt():
    """An attribute `width` would stand in place of the method width()."""
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


def test_no_widget_asks_for_its_parent():
    """Python's shell of a parent that FreeCAD has made takes those of its children with it, when it goes.

    From then on their methods end with "Internal C++ object already deleted" (PySide2 of FreeCAD 1.0).
    """
    asked = [
        path.name
        for path in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute) and node.attr in ("parentWidget", "nativeParentWidget")
    ]
    assert not asked
