# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds in drawing files: lines and spots on a layer, in a group, or written out."""

import json
from itertools import pairwise

import ezdxf
import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.readers.read import read_drawing

LINE = [[20, 40], [60, 40], [60, 60]]


def mm(lines):
    return [line * 1e3 for line in lines]


def outline_with(drawing):
    (part,) = drawing.parts
    assert part.holes == ()
    assert part.size == pytest.approx((0.1, 0.08))
    return part


def expect(part, centre=(30, 20), diameter=6.0):
    """One bent line, one spot."""
    (line,) = mm(part.welds)
    assert any(ends == pytest.approx(np.array(LINE), abs=1e-3) for ends in (line, line[::-1]))
    (spot,) = mm(part.spots)
    assert spot.mean(axis=0) == pytest.approx(centre, abs=0.02)
    assert np.linalg.norm(spot - centre, axis=1) == pytest.approx(0.5 * diameter, abs=0.03)


@pytest.mark.parametrize("layer", ["weld", "WELD", "Weld"])
def test_dxf_layer(layer, tmp_path):
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 4
    space = document.modelspace()
    space.add_lwpolyline([(0, 0), (100, 0), (100, 80), (0, 80)], close=True, dxfattribs={"layer": "0"})
    for a, b in pairwise(LINE):
        space.add_line(a, b, dxfattribs={"layer": layer})
    space.add_circle((30, 20), 3, dxfattribs={"layer": layer})
    document.saveas(tmp_path / "a.dxf")
    drawing, kind = read_drawing(tmp_path / "a.dxf")
    assert kind == "dxf"
    expect(outline_with(drawing))
    wide, _ = read_drawing(tmp_path / "a.dxf", 0.2)
    assert wide.largest.welds[0].max() == pytest.approx(0.12)


def test_dxf_point_is_a_spot(tmp_path):
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 4
    space = document.modelspace()
    space.add_lwpolyline([(0, 0), (100, 0), (100, 80), (0, 80)], close=True)
    space.add_point((30, 20), dxfattribs={"layer": "WELD"})
    space.add_point((70, 20))  # elsewhere a point means nothing
    document.saveas(tmp_path / "a.dxf")
    (spot,) = mm(outline_with(read_drawing(tmp_path / "a.dxf")[0]).spots)
    assert np.linalg.norm(spot - (30, 20), axis=1) == pytest.approx(2.5)


CIRCLE = '<circle cx="30" cy="60" r="3"/>'
PATH = '<path d="M20 40H60V20" fill="none"/>'


@pytest.mark.parametrize(
    "body",
    [
        f'<g id="weld">{PATH}{CIRCLE}</g>',
        f'<g id="layer3" inkscape:groupmode="layer" inkscape:label="Weld"><g>{PATH}{CIRCLE}</g></g>',
        f'<g id="WELD" transform="scale(1)"><g id="g7">{PATH}</g>{CIRCLE}</g>',
        f'<path id="weld" d="M20 40H60V20"/><g inkscape:label="weld">{CIRCLE}</g>',
    ],
)
def test_svg_group(body, tmp_path):
    names = 'xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    page = 'width="100mm" height="80mm" viewBox="0 0 100 80"'
    path = tmp_path / "a.svg"
    path.write_text(f'<svg {names} {page}><rect width="100" height="80"/>{body}</svg>')
    expect(outline_with(read_drawing(path)[0]))


def written(folder, **more):
    path = folder / "a.json"
    outer = [[0, 0], [100, 0], [100, 80], [0, 80]]
    path.write_text(json.dumps({"unit": "mm", "outer": outer, **more}))
    return path


def test_json_welds(tmp_path):
    path = written(tmp_path, welds=[LINE, [[30, 20]]])
    expect(outline_with(read_drawing(path)[0]), diameter=5.0)
    square = [[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]
    part = outline_with(read_drawing(written(tmp_path, welds=[square]))[0])
    assert part.welds == ()
    assert part.area == pytest.approx(0.008 - 0.0001)


@pytest.mark.parametrize(
    ("welds", "message"),
    [
        ({}, "'welds'"),
        ([[]], "one point"),
        ([[[1, "a"]]], "pair of numbers"),
        ([[[50, 40], [150, 40]]], "leaves the film"),
        ([[[0, 40], [100, 40]]], None),  # cuts it in two: told when it is meshed
    ],
)
def test_bad_json_welds(welds, message, tmp_path):
    path = written(tmp_path, welds=welds)
    if message is None:
        assert len(read_drawing(path)[0].largest.welds) == 1
        return
    with pytest.raises(InputError, match=message):
        read_drawing(path)


def test_welds_go_to_the_shape_they_lie_in(tmp_path):
    """One in a ring, one in the island in its hole, one outside."""
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 4
    space = document.modelspace()
    for radius in (100, 60, 40):
        space.add_circle((0, 0), radius)
    for a, b in (((70, 0), (90, 0)), ((-10, 0), (10, 0)), ((200, 0), (250, 0))):
        space.add_line(a, b, dxfattribs={"layer": "weld"})
    document.saveas(tmp_path / "a.dxf")
    drawing, _ = read_drawing(tmp_path / "a.dxf")
    ring, island = drawing.parts
    assert ring.welds[0][:, 0].mean() == pytest.approx(0.08)
    assert island.welds[0][:, 0].mean() == pytest.approx(0.0, abs=1e-9)
    assert drawing.notes == ("1 weld outside the shapes left out.",)
