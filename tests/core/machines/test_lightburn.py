# SPDX-License-Identifier: LGPL-2.1-or-later
"""LightBurn projects, read by the grammar of published ones: layers, shapes, what is burnt and how."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.machine import FOLDER, Machine, machine, read_machine
from BalloonWorkbench.core.machines.machine_file import checked_files, machine_file
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

#: What a project may be off the pattern [mm].
NEAR = 0.01
VERTEX = re.compile(r"V(-?\d+(?:\.\d+)?) (-?\d+(?:\.\d+)?)c0x1c1x1")
LINE = re.compile(r"L(\d+) (\d+)")


class Layer(NamedTuple):
    """A <CutSetting>: whether it is burnt, its place in the order, its name, all other values."""

    burnt: bool
    priority: int
    name: str
    others: dict[str, float]


class Project(NamedTuple):
    """Layers by number; shapes with their layer, points (n, 2) mm and whether they are closed."""

    layers: dict[int, Layer]
    shapes: list[tuple[int, np.ndarray, bool]]


def read_project(content: bytes) -> Project:
    """As LightBurn's own files are built; anything else fails."""
    root = ElementTree.fromstring(content)
    assert root.tag == "LightBurnProject"
    assert root.get("FormatVersion") == "1"
    assert root.get("MirrorX") == root.get("MirrorY") == "False"
    assert {child.tag for child in root} == {"CutSetting", "Shape"}
    layers: dict[int, Layer] = {}
    for setting in root.findall("CutSetting"):
        values = {value.tag: value.get("Value") for value in setting}
        assert len(values) == len(setting)
        number, kind = int(values.pop("index")), setting.get("type")
        assert number not in layers
        assert (kind, number < 30) in {("Cut", True), ("Tool", False)}
        name, priority = values.pop("name"), int(values.pop("priority"))
        layers[number] = Layer(kind == "Cut", priority, name, {key: float(at) for key, at in values.items()})
    assert sorted(layer.priority for layer in layers.values()) == list(range(len(layers)))
    return Project(layers, [_shape(shape) for shape in root.findall("Shape")])


def _shape(shape: ElementTree.Element) -> tuple[int, np.ndarray, bool]:
    assert shape.get("Type") == "Path"
    a, b, c, d, x, y = map(float, shape.findtext("XForm").split())
    text = shape.findtext("VertList")
    assert VERTEX.sub("", text) == ""
    points = np.array(VERTEX.findall(text), dtype=float) @ np.array([[a, b], [c, d]]) + [x, y]
    edges = shape.findtext("PrimList")
    if edges == "LineClosed":
        return int(shape.get("CutIndex")), points, True
    assert LINE.sub("", edges) == ""
    assert [tuple(map(int, edge)) for edge in LINE.findall(edges)] == [
        (k, k + 1) for k in range(len(points) - 1)
    ]
    return int(shape.get("CutIndex")), points, False


def project_machine(folder: Path, layers: dict[str, dict[str, object]], **values: object) -> Machine:
    """The project's machine with more said of some layers, as a user writes it."""
    data = json.loads((FOLDER / "lightburn-project.json").read_text(encoding="utf-8"))
    for role, more in layers.items():
        data["layers"][role] |= more
    path = folder / f"{data['name']}.json"
    path.write_text(json.dumps(data | values), encoding="utf-8")
    return read_machine(path)


@pytest.fixture(scope="module")
def pattern() -> Pattern:
    """A shape with holes, a weld, notches, a label and an intake."""
    return make_pattern(NAMED["holes"], 0.005, PatternOptions(notches=5, label="8"))


def test_shapes_are_the_pattern_and_close(pattern: Pattern) -> None:
    made_for = machine("lightburn-project")
    project = read_project(machine_file(pattern, made_for))
    wanted = [
        (made_for.layers[each.role].pen, each) for each in pattern.contours if each.role in made_for.layers
    ]
    bar = made_for.layers[Role.REGISTRATION].pen
    shapes = list(project.shapes)
    low = np.min([points.min(axis=0) for _, points, _ in shapes], axis=0)
    assert low == pytest.approx([0.0, 0.0], abs=1e-9)
    cut = (
        np.concatenate([each.points for layer, each in wanted if each.role is Role.CUT]).min(axis=0) * 1000.0
    )
    shift = np.concatenate([points for layer, points, _ in shapes if layer == 2]).min(axis=0) - cut
    for layer, contour in wanted:
        goal = _line(contour.points * 1000.0 + shift, contour.closed)
        near = [k for k, (own, points, closed) in enumerate(shapes)
                if (own, closed) == (layer, contour.closed)
                and _apart(_line(points, closed), goal) < NEAR]  # fmt: skip
        assert near, (contour.role, contour.points[0])
        del shapes[near[0]]
    assert [(layer, closed) for layer, _, closed in shapes] == [(bar, False)] * 3
    assert all(closed for layer, _, closed in project.shapes if project.layers[layer].burnt and layer != 5)


def _line(points: np.ndarray, closed: bool) -> shapely.Geometry:
    return shapely.LinearRing(points) if closed else shapely.LineString(points)


def _apart(one: shapely.Geometry, other: shapely.Geometry) -> float:
    """The largest distance of a vertex of one line from the other."""
    return max(
        float(shapely.distance(shapely.points(shapely.get_coordinates(a)), b).max())
        for a, b in ((one, other), (other, one))
    )


def test_layers_have_names_and_the_order_of_the_work(pattern: Pattern) -> None:
    project = read_project(machine_file(pattern, machine("lightburn-project")))
    order = sorted(project.layers.values(), key=lambda layer: layer.priority)
    burnt = [layer.name for layer in order if layer.burnt]
    assert burnt == ["NOTCH", "CUT_INNER", "CUT"]
    assert not project.layers[30].burnt
    assert "SEAL" in project.layers[30].name
    assert set(project.layers) <= {1, 2, 5, 30, 31}


def test_nothing_is_said_of_speed_and_power_that_nobody_gave(pattern: Pattern, tmp_path: Path) -> None:
    own = project_machine(tmp_path, {"CUT": {"speed_mm_s": 20, "max_power_percent": 35.5}})
    contents, remarks = checked_files(pattern, [own])
    (content,) = contents.values()
    project = read_project(content)
    said = {number: layer.others for number, layer in project.layers.items() if layer.others}
    assert said == {2: {"maxPower": 35.5, "speed": 20.0, "kerf": 0.0}}
    (told,) = (remark for remark in remarks if "power" in remark)
    assert re.search(r"for CUT_INNER, NOTCH, so none are written", told)
    _, plain = checked_files(pattern, [machine("lightburn-project")])
    assert any("for CUT, CUT_INNER, NOTCH, so" in remark for remark in plain)
    known = {"speed_mm_s": 5, "max_power_percent": 80, "min_power_percent": 20, "passes": 2}
    all_known = project_machine(tmp_path, dict.fromkeys(("CUT", "CUT_INNER", "NOTCH"), known))
    contents, remarks = checked_files(pattern, [all_known])
    assert not any("power" in remark for remark in remarks)
    said = read_project(next(iter(contents.values()))).layers[1].others
    assert said == {"minPower": 20.0, "maxPower": 80.0, "speed": 5.0, "kerf": 0.0, "numPasses": 2.0}


def test_a_layer_for_a_later_turn_is_burnt_as_its_role(tmp_path: Path) -> None:
    """A panel in the hole of another: the hole waits, on a layer of its own with the same power."""
    square = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    hole, small = 0.6 * square[::-1] + 0.02, 0.3 * square + 0.03
    rings = [
        Contour(Role.CUT, square, True),
        Contour(Role.CUT_INNER, hole, True),
        Contour(Role.CUT, small, True),
    ]
    own = project_machine(tmp_path, {"CUT_INNER": {"speed_mm_s": 20, "max_power_percent": 30}})
    project = read_project(machine_file(Pattern(tuple(rings), None, 0.005, 0.4), own))
    (later,) = (layer for layer in project.layers.values() if layer.name == "CUT_INNER-2")
    assert later.others["maxPower"] == 30.0
    order = sorted((project.layers[layer].priority, np.ptp(points[:, 0])) for layer, points, closed in
                   project.shapes if closed)  # fmt: skip
    assert [width for _, width in order] == pytest.approx([30.0, 60.0, 100.0])


def test_kerf_is_in_the_lines_alone(tmp_path: Path) -> None:
    square = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    rings = (Contour(Role.CUT, square, True), Contour(Role.CUT_INNER, 0.2 * square[::-1] + 0.04, True))
    known = {"speed_mm_s": 20, "max_power_percent": 30}
    own = project_machine(tmp_path, {"CUT": known, "CUT_INNER": known}, kerf_mm=0.2)
    contents, remarks = checked_files(Pattern(rings, None, 0.005, 0.4), [own])
    project = read_project(next(iter(contents.values())))
    widths = {layer: np.ptp(points[:, 0]) for layer, points, closed in project.shapes if closed}
    assert widths == pytest.approx({2: 100.2, 1: 19.8})
    assert all(project.layers[layer].others["kerf"] == 0.0 for layer in widths)
    assert [remark for remark in remarks if "kerf of 0.2 mm" in remark]


@pytest.mark.parametrize(
    ("layers", "text"),
    [
        ({"CUT": {"speed_mm_s": 20}}, "CUT lacks max_power_percent"),
        ({"CUT": {"max_power_percent": 20, "passes": 2}}, "CUT lacks speed_mm_s"),
        ({"CUT": {"speed_mm_s": 0, "max_power_percent": 20}}, "speed_mm_s of CUT is 0"),
        ({"CUT": {"speed_mm_s": "fast", "max_power_percent": 20}}, "speed_mm_s of CUT is 'fast'"),
        ({"CUT": {"speed_mm_s": 20, "max_power_percent": 101}}, "max_power_percent of CUT is 101"),
        ({"CUT": {"speed_mm_s": 20, "max_power_percent": True}}, "max_power_percent of CUT is True"),
        ({"CUT": {"speed_mm_s": 20, "max_power_percent": 20, "min_power_percent": 30}}, "exchange the two"),
        ({"CUT": {"speed_mm_s": 20, "max_power_percent": 20, "passes": 1.5}}, "passes of CUT is 1.5"),
        ({"SEAL": {"speed_mm_s": 20, "max_power_percent": 20}}, "SEAL has a speed and a power"),
        ({"CUT": {"pen": 1, "speed_mm_s": 20, "max_power_percent": 20}}, "layer 1 .* two speeds"),
        ({"CUT": {"pen": 32}}, "layers up to 31"),
    ],
)  # fmt: skip
def test_settings_of_no_laser_are_refused(
    tmp_path: Path, layers: dict[str, dict[str, object]], text: str
) -> None:
    with pytest.raises(InputError, match=text) as caught:
        project_machine(tmp_path, layers)
    assert str(caught.value).count(". ") == 0


def test_other_formats_have_no_power(tmp_path: Path) -> None:
    data = json.loads((FOLDER / "lightburn.json").read_text(encoding="utf-8"))
    data["layers"]["CUT"] |= {"speed_mm_s": 20, "max_power_percent": 20}
    (tmp_path / "lightburn.json").write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(InputError, match="only layers below 30 of a LightBurn project"):
        read_machine(tmp_path / "lightburn.json")


def test_the_reader_notices() -> None:
    """The reader fails on what LightBurn would not read."""
    good = machine_file(build_pattern(NAMED["heart"], 0.005), machine("lightburn-project"))
    for old, new in ((b"LineClosed", b"LineOpen"), (b'type="Tool"', b'type="Cut"'), (b"c0x1c1x1V", b"V")):
        with pytest.raises(AssertionError):
            read_project(good.replace(old, new, 1))
