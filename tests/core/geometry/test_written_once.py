# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane geometry is written once: elsewhere in the package nobody spells out what core/geometry has."""

import ast
import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from test_house import tree

PACKAGE = Path(__file__).resolve().parents[3] / "BalloonWorkbench"

_V = r"[\w.]+"  # a variable
_I = r"\[(?:[:.]+, )?"  # before the number of a component: v[0], v[:, 0], v[..., 0]
_X, _Y = _I + r"0\]", _I + r"1\]"
_PAIR = r"(?:np\.\w*stack|np\.array)\([\[(]"

#: What gives a copy away, as Python writes the syntax tree again, by the helper that does it.
TELLTALES = {
    "edge_vectors": rf"np\.roll\(({_V}), -1, axis=0\) - \1(?![\w.])",
    "tangents": rf"np\.roll\(({_V}), -1, axis=0\) - np\.roll\(\1, 1, axis=0\)",
    "ring": rf"np\.(?:concatenate|vstack)\(\[({_V}), \1\[:1\]\]\)",
    "line_lengths": r"np\.cumsum\(np\.(?:hypot|linalg\.norm)\(",
    "length": r"np\.(?:linalg\.norm|hypot)\(\*?np\.diff\([^()]*\)(?:\.T|, axis=1)\)\.sum\(\)",
    "cross": rf"({_V}){_X} \* ({_V}){_Y} - (?:\1{_Y} \* \2{_X}|\2{_X} \* \1{_Y})",
    "perpendicular": rf"{_PAIR}-({_V}){_Y}, \1{_X}|{_PAIR}({_V}){_Y}, -\2{_X}",
    "direction": rf"{_PAIR}np\.cos\(([^()]*)\), np\.sin\(\1\)[\])]",
    "rotation": r"\[\[(\w*c\w*|np\.cos\(\w+\)), -?(\w*s\w*|np\.sin\(\w+\))\], \[-?\2, \1\]\]",
    "foot": r"/ (?:np\.maximum\(|max\()?(?:float\()?(?:"
    rf"({_V}) @ \1(?![\w.])|\(?({_V}) \* \2(?![\w.])(?: \+ |\)?\.sum)|np\.einsum\('[^']*', ({_V}), \3\))",
    "extent": r"np\.ptp\([^()]*, axis=0\)\.max\(\)",
    "bounds": rf"\b({_V})\.min\(axis=0\), \1\.max\(axis=0\)",
    "point_on": rf"np\.interp\({_V}, {_V}, {_V}\[:, {_V}\]\)",
    "gaps": r"np\.minimum\((\w+), [\w.\[\]-]+ - \1\)",
    "oriented": rf"signed_area\({_V}\) > 0\.0 else",
    "signed_area": r"np\.dot\((\w+), np\.roll\((\w+), -1\)\)",
    "kd_tree": r"import cKDTree",
    "wrapped": r"np\.pi\) % \(2\.0 \* np\.pi\) - np\.pi",
}

#: Where one of them is right in its place, and why.
ALLOWED = {
    ("core/results/colour_map.py", "point_on"): "colours along a scale, one for each value of an array",
    ("core/outline/chambers.py", "gaps"): "to the nearer end of an open line",
    (
        "core/solver/element/seam_band.py",
        "rotation",
    ): "a matrix for each hinge, from edges instead of an angle",
}


@cache
def _written(path: Path) -> str:
    """A file without comments and in one way of writing; texts of two lines are one."""
    return ast.unparse(tree(path))


def copies(text: str) -> Counter[str]:
    """How often each helper is written out in a text."""
    return Counter({name: len(re.findall(pattern, text)) for name, pattern in TELLTALES.items()})


def test_geometry_is_written_once() -> None:
    sources = [path for path in PACKAGE.rglob("*.py") if path.parent.name != "geometry"]
    assert len(sources) > 200
    again = {
        (str(path.relative_to(PACKAGE)), helper)
        for path in sources
        for helper, count in copies(_written(path)).items()
        if count
    }
    assert not sorted(again - set(ALLOWED)), "call the helper of core/geometry instead"
    assert not sorted(set(ALLOWED) - again), "these no longer write it themselves: they leave the list"


@pytest.mark.parametrize(
    ("line", "helper"),
    [
        ("steps = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)", "edge_vectors"),
        ("ahead = np.roll(rim, -1, axis=0) - np.roll(rim, 1, axis=0)", "tangents"),
        ("edges = np.diff(np.vstack([loop, loop[:1]]), axis=0)", "ring"),
        ("line = np.concatenate([cut.points, cut.points[:1]])", "ring"),
        ("along = np.append(0.0, np.cumsum(np.hypot(*np.diff(loop, axis=0).T)))", "line_lengths"),
        ("return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())", "length"),
        ("turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]", "cross"),
        ("area = one[0] * other[1] - other[0] * one[1]", "cross"),
        ("side = np.array([-axis[1], axis[0]])", "perpendicular"),
        ("normals = np.column_stack([along[:, 1], -along[:, 0]])", "perpendicular"),
        ("axis = np.array([np.cos(intake.angle), np.sin(intake.angle)])", "direction"),
        ("turn = np.array([[cosine, sine], [-sine, cosine]])", "rotation"),
        ("turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])", "rotation"),
        ("share = np.clip(away @ along / float(along @ along), 0, 1)", "foot"),
        ("share = (away * edges).sum(axis=2) / np.maximum((edges * edges).sum(axis=1), 1e-12)", "foot"),
        ("share = a / np.einsum('ij,ij->i', ahead, ahead)", "foot"),
        ("t = (x * dx + y * dy) / max(dx * dx + dy * dy, 1e-9)", "foot"),
        ("size = float(np.ptp(loop, axis=0).max())", "extent"),
        ("low, high = points.min(axis=0), points.max(axis=0)", "bounds"),
        ("at = np.stack([np.interp(places, along, loop[:, k]) for k in range(2)], axis=1)", "point_on"),
        ("way = np.minimum(gap, lengths[-1] - gap)", "gaps"),
        ("return points if signed_area(points) > 0.0 else points[::-1]", "oriented"),
        ("return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y))", "signed_area"),
        ("turn = (angles + np.pi) % (2.0 * np.pi) - np.pi", "wrapped"),
    ],
)
def test_a_copy_gives_itself_away(line: str, helper: str) -> None:
    """Each of these stood in the package, some in eight places."""
    written = ast.unparse(ast.parse(line if not line.startswith("return") else f"def f():\n    {line}"))
    assert copies(written)[helper] == 1
