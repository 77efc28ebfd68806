# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG and DXF drawings at their own size, and every way in which they can be bad."""

import math

import ezdxf
import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError, MissingPackageError, OutlineError
from BalloonWorkbench.core.readers import vector
from BalloonWorkbench.core.readers.chains import join

FLAT = 0.02  # mm: how far a curve may be from its polyline
PAGE = 'width="100mm" height="80mm" viewBox="0 0 100 80"'


def read_vector(path):
    """The largest shape of a drawing."""
    return vector.read_vector(path).largest


def svg(folder, body, page=PAGE, before=""):
    path = folder / "drawing.svg"
    names = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    path.write_text(f"{before}<svg {names} {page}>{body}</svg>", encoding="utf-8")
    return path


def dxf(folder, draw, unit=4, version="R2010"):
    document = ezdxf.new(version)
    document.header["$INSUNITS"] = unit
    draw(document.modelspace())
    path = folder / "drawing.dxf"
    document.saveas(path)
    return path


def mm2(outline):
    return outline.area * 1e6


def lost(*radii):
    """Area [mm2] that chords at most FLAT away from circles of these radii [mm] can lose, at most."""
    return sum(2 * math.pi * radius * FLAT for radius in radii)


@pytest.mark.parametrize(
    ("body", "area", "curves"),
    [
        ('<rect x="10" y="10" width="50" height="30"/>', 1500, ()),
        ('<rect x="10" y="10" width="50" height="30" rx="5"/>', 1500 - (4 - math.pi) * 25, (5,)),
        ('<circle cx="50" cy="40" r="30"/>', math.pi * 900, (30,)),
        ('<circle cx="50" cy="40" r="30"/><circle cx="50" cy="40" r="10"/>', math.pi * 800, (30, 10)),
        ('<ellipse cx="50" cy="40" rx="30" ry="10" transform="rotate(30 50 40)"/>', math.pi * 300, (30,)),
        ('<circle r="10" transform="translate(50 40) skewX(30) scale(2 1)"/>', math.pi * 200, (20,)),
        (
            '<g transform="scale(.5)"><circle r="20" transform="matrix(2 0 0 2 90 90)"/></g>',
            math.pi * 400,
            (20,),
        ),
        ('<path d="M10 40A20 20 0 0 1 50 40 20 20 0 0 1 10 40Z"/>', math.pi * 400, (20,)),
        (
            '<path d="m10,40a20,20 0 1140,0" fill="red"/>',
            math.pi * 200,
            (20,),
        ),  # open but filled, packed flags
        ('<path d="M10 10H60V40H10zm10 10h10v10h-10z"/>', 1400, ()),
        ('<path d="M0 0Q50 50 100 0z"/>', 100 * 25 * 2 / 3, (100,)),  # a parabola's segment
        ('<path d="M0 0 T100 0 L50 20z"/>', 1000, ()),
        (
            '<path d="M0 0C0 40 60 40 60 0z"/>',
            0.75 * 40 * 60 * 0.8,
            (40,),
        ),  # 3/4 of the height, 6/5 of a parabola
        ('<path d="M0 0C0 40 60 40 60 0S120 -40 120 0z" transform="scale(.5)"/>', None, ()),
        ('<polygon points="0,0 10,0 10,10"/>', 50, ()),
        ('<polyline fill="none" points="0,0 10,0 10,10 0,0"/>', 50, ()),
        (
            '<g fill="none"><line x1="0" y1="0" x2="10" y2="0"/><line x1="10" y1="10" x2="10" y2="0"/>'
            '<path d="M10 10L0 0"/></g>',
            50,
            (),
        ),
        (
            '<defs><rect id="a" width="10" height="10"/></defs><use xlink:href="#a" transform="scale(3)"/>',
            900,
            (),
        ),
        (
            '<svg x="10" width="40" height="40" viewBox="0 0 10 10"><rect width="10" height="5"/></svg>',
            800,
            (),
        ),
        ('<rect width="50" height="50" style="display:none"/><rect width="10" height="20"/>', 200, ()),
        ('<rect width="50" height="50" visibility="hidden"/><rect width="10" height="20"/>', 200, ()),
        ('<clipPath id="c"><rect width="90" height="70"/></clipPath><rect width="10" height="20"/>', 200, ()),
        (
            '<circle cx="20" cy="20" r="10"/><circle cx="20" cy="20" r="10" fill="none"/>',
            math.pi * 100,
            (10,),
        ),
    ],
)
def test_svg_shapes(body, area, curves, tmp_path):
    if area is None:  # an S of two halves that cross their closing line: it is refused, not misread
        with pytest.raises(OutlineError, match="touches itself"):
            read_vector(svg(tmp_path, body))
        return
    assert mm2(read_vector(svg(tmp_path, body))) == pytest.approx(area, abs=lost(*curves) + 2e-6 * area)


@pytest.mark.parametrize(
    ("page", "side"),
    [
        ("", 96 * 25.4 / 96),
        ('viewBox="0 0 200 100"', 25.4),
        ('viewBox="0 0 200 100" width="100%" height="100%"', 25.4),
        ('viewBox="0 0 200 100" width="200mm" height="100mm"', 96.0),
        ('viewBox="0 0 200 100" width="4in"', 48.768),
        ('viewBox="0 0 200 100" height="10cm"', 96.0),
        ('width="400" height="400"', 25.4),
        ('width="300pt" height="300pt"', 25.4),
    ],
)
def test_svg_units(page, side, tmp_path):
    found = read_vector(svg(tmp_path, '<rect x="3" y="1" width="96" height="48"/>', page))
    assert np.array(found.size) * 1e3 == pytest.approx((side, side / 2), rel=1e-5)


def test_svg_is_upright(tmp_path):
    found = read_vector(svg(tmp_path, '<path d="M10 70L60 70L10 20z"/>'))
    corner = found.outer[np.argmin(found.outer.sum(axis=1))]
    assert corner * 1e3 == pytest.approx((10, 10), abs=1e-4)


def test_shapes_beside_and_within_each_other(tmp_path):
    circles = ((20, 10), (60, 12), (60, 8), (60, 4), (80, 0.5))
    body = "".join(f'<circle cx="{x}" cy="20" r="{r}"/>' for x, r in circles)
    found = vector.read_vector(svg(tmp_path, body))
    areas = [144 - 64, 100, 16]  # the ring, the disc, the island in the ring
    assert [mm2(part) for part in found.parts] == pytest.approx([math.pi * area for area in areas], rel=0.01)
    assert [part.outer[:, 0].mean() for part in found.parts] == pytest.approx([0.06, 0.02, 0.06], abs=1e-4)
    assert found.notes == ("1 small speck was dropped.",)


def test_shapes_that_cross_are_refused(tmp_path):
    body = (
        '<rect width="40" height="10" fill="none"/><rect x="10" y="-20" width="5" height="60" fill="none"/>'
    )
    with pytest.raises(OutlineError, match="meet"):
        vector.read_vector(svg(tmp_path, body))


BOMB = '<!DOCTYPE svg [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;">]>'
OUTSIDE = '<!DOCTYPE svg [<!ENTITY c SYSTEM "file:///etc/hostname">]>'
DOUBLING = "<defs><g id='g0'><rect width='9' height='9'/></g>" + "".join(
    f"<g id='g{k + 1}'>" + f"<use xlink:href='#g{k}'/>" * 10 + "</g>" for k in range(12)
)


@pytest.mark.parametrize(
    ("before", "body", "message"),
    [
        (BOMB, "<text>&c;</text>", "entities"),
        (OUTSIDE, "<text>&c;</text>", "entities"),
        ("", DOUBLING + "</defs><use xlink:href='#g12'/>", "more than 100000 elements"),
        ("", "<g id='a'><use xlink:href='#a'/><rect width='9' height='9'/></g>", "show themselves"),
        ("", "<rect", "damaged"),
        ("", "<path d='M0 0L1e999 0L5 5z'/>", "not a number"),
        ("", "<path d='M0 0L9 0L9 9' fill='none'/>", r"open.* 12\.73 mm away"),
        ("", "<style>.a{fill:none}</style><path class='a' d='M0 0L9 0L9 9'/>", "open"),
        ("", "<path d='M0 0L10 10L10 0L0 10z'/>", "crosses or touches itself at"),
        ("", "<path d='M0 0L10 10L0 0z'/>", "no closed line"),
        ("", "<text x='1' y='9'>Hello</text>", "no closed line"),
        ("", "<circle cx='20' cy='20' r='10'/><circle cx='30' cy='20' r='8'/>", "A hole meets the outline"),
        ("", "<circle cx='20' cy='20' r='0.2'/>", "between 1 mm and 100 m"),
    ],
)
def test_bad_svg_is_refused(before, body, message, tmp_path):
    with pytest.raises(InputError, match=message):
        read_vector(svg(tmp_path, body, before=before))


def test_a_public_doctype_is_no_entity(tmp_path):
    kind = (
        '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
    )
    assert mm2(read_vector(svg(tmp_path, '<rect width="5" height="5"/>', before=kind))) == pytest.approx(
        25, rel=1e-5
    )


def test_other_xml_is_no_drawing(tmp_path):
    path = tmp_path / "page.svg"
    path.write_text("<html><body/></html>")
    with pytest.raises(InputError, match="no SVG drawing"):
        read_vector(path)


@pytest.mark.parametrize(
    ("draw", "area", "curves"),
    [
        (
            lambda space: space.add_lwpolyline(
                [(0, 0, 1), (100, 0, 0), (100, 50, 0), (0, 50, 0)], format="xyb", close=True
            ),
            5000 + math.pi * 1250,
            (25,),
        ),
        (
            lambda space: (space.add_circle((0, 0), 150), space.add_circle((0, 0), 50)),
            math.pi * 20000,
            (150, 50),
        ),
        (
            lambda space: (
                space.add_line((50, 20), (0, 20)),
                space.add_arc((50, 10), 10, -90, 90),
                space.add_line((0, 0), (50, 0)),
                space.add_arc((0, 10), 10, 90, 270),
            ),
            1000 + math.pi * 100,
            (10,),
        ),
        (lambda space: space.add_ellipse((0, 0), (50, 0), 0.4), math.pi * 1000, (50,)),
        (
            lambda space: (
                space.add_open_spline([(0, 0), (0, 40), (60, 40), (60, 0)]),
                space.add_line((60, 0), (0, 0)),
            ),
            0.75 * 40 * 60 * 0.8,
            (40,),
        ),
        (
            lambda space: (
                space.doc.blocks.new("B").add_circle((0, 0), 10),
                space.add_blockref("B", (5, 5), dxfattribs={"xscale": 2, "yscale": 1, "rotation": 30}),
            ),
            math.pi * 200,
            (20,),
        ),
        (lambda space: space.add_polyline2d([(0, 0), (10, 0), (10, 10)], close=True), 50, ()),
        (lambda space: space.add_polyline3d([(0, 0, 3), (10, 0, 3), (10, 10, 3)], close=True), 50, ()),
        (
            lambda space: (
                space.doc.layers.add("HIDDEN").off(),
                space.add_circle((0, 0), 50, dxfattribs={"layer": "HIDDEN"}),
                space.add_circle((0, 0), 5),
            ),
            math.pi * 25,
            (5,),
        ),
        (lambda space: space.add_circle((0, 0), 5, dxfattribs={"extrusion": (0, 0, -1)}), math.pi * 25, (5,)),
    ],
)
def test_dxf_shapes(draw, area, curves, tmp_path):
    assert mm2(read_vector(dxf(tmp_path, draw))) == pytest.approx(area, abs=lost(*curves) + 1e-6)


@pytest.mark.parametrize(
    ("unit", "millimetres", "noted"),
    [(1, 25.4, False), (4, 1, False), (5, 10, False), (6, 1000, False), (0, 1, True)],
)
def test_dxf_units(unit, millimetres, noted, tmp_path):
    found = read_vector(
        dxf(tmp_path, lambda space: space.add_lwpolyline([(0, 0), (9, 0), (0, 9)], close=True), unit)
    )
    assert found.size[0] * 1e3 == pytest.approx(9 * millimetres, rel=1e-9)
    assert bool(found.notes) == noted


def test_an_old_dxf_without_units_is_in_millimetres(tmp_path):
    path = dxf(tmp_path, lambda space: space.add_polyline2d([(0, 0), (9, 0), (0, 9)], close=True), 0, "R12")
    found = read_vector(path)
    assert found.size[0] == pytest.approx(0.009)
    assert "millimetres are assumed" in found.notes[0]


def test_small_gaps_of_a_dxf_are_closed_and_noted(tmp_path):
    square = [(0, 0), (100, 0), (100, 50), (0, 50), (0, 0.3)]
    found = read_vector(dxf(tmp_path, lambda space: space.add_lwpolyline(square)))
    assert found.outer * 1e3 == pytest.approx(np.array(square[:4]), abs=0.3)
    assert "closed" in found.notes[0]


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (
            lambda space: space.add_lwpolyline([(0, 0), (100, 0), (100, 50), (0, 50)]),
            r"open.* 50 mm away at \(0, 50\)",
        ),
        (
            lambda space: space.add_lwpolyline([(0, 0), (10, 10), (10, 0), (0, 10)], close=True),
            r"itself at \(5, 5\) mm",
        ),
        (lambda space: None, "no closed line"),
        (lambda space: space.add_text("Hello"), "no closed line"),
        (lambda space: space.add_lwpolyline([(0, 0), (10, 0), (20, 0)], close=True), "no closed line"),
        (lambda space: space.add_circle((0, 0), 2e5), "between 1 mm and 100 m"),
        (lambda space: space.add_arc((0, 0), 1e30, 0, 360), "more than 200000 points"),
    ],
)
def test_bad_dxf_is_refused(draw, message, tmp_path):
    with pytest.raises(InputError, match=message):
        read_vector(dxf(tmp_path, draw))


def test_a_damaged_dxf_is_refused(tmp_path):
    whole = dxf(tmp_path, lambda space: space.add_circle((0, 0), 5)).read_bytes()
    for data in (whole[:3000], b"  0\nSECTION\n" + b"\x00\xff" * 200, b"AutoCAD Binary DXF\r\n\x1a\x00junk"):
        path = tmp_path / "damaged.dxf"
        path.write_bytes(data)
        with pytest.raises(InputError):
            read_vector(path)


def test_a_missing_package_is_named(tmp_path, monkeypatch):
    paths = {"svgelements": svg(tmp_path, ""), "ezdxf": dxf(tmp_path, lambda space: None)}
    for package, path in paths.items():
        with (
            monkeypatch.context() as patch,
            pytest.raises(MissingPackageError, match=f"pip install {package}"),
        ):
            patch.setitem(__import__("sys").modules, package, None)
            read_vector(path)


def test_loose_pieces_in_any_order_and_direction_become_their_loops():
    random = np.random.default_rng(11)
    for _ in range(20):
        pieces = []
        for k in range(3):
            loop = 0.1 * np.exp(2j * np.pi * np.arange(60) / 60) + k
            cuts = np.sort(random.choice(60, 7, replace=False))
            for first, last in zip(cuts, np.append(cuts[1:], cuts[0] + 60)):
                piece = loop[np.arange(first, last + 1) % 60]
                piece = np.column_stack([piece.real, piece.imag]) + random.normal(
                    0, 1e-7, (last - first + 1, 2)
                )
                pieces.append(piece[:: random.choice([-1, 1])])
        order = random.permutation(len(pieces))
        loops, rest = join([pieces[k] for k in order], 2e-5)
        assert len(loops) == 3
        assert rest == []
        assert all(np.linalg.norm(np.diff(loop, axis=0), axis=1).max() < 0.011 for loop in loops)


@pytest.mark.parametrize("lopsided", [0.0, 0.004, 0.3])
@pytest.mark.parametrize(
    "beside", ["", '<circle cx="55" cy="60" r="12"/>', '<circle cx="20" cy="10" r="3"/>']
)
def test_an_eight_is_no_speck(beside, lopsided, tmp_path):
    """Its lobes run round in opposite senses, so that their areas take from each other: it is refused for its
    crossing, never dropped for its size, whatever lies beside it."""
    far = 190 + 90 * lopsided
    eight = f"M10,60 C10,10 60,10 100,60 S{far},110 {far},60 S140,10 100,60 S10,110 10,60 Z"
    file = tmp_path / "eight.svg"
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="120mm" viewBox="0 0 300 120">'
        f'<path d="{eight}"/>{beside}</svg>'
    )
    with pytest.raises(OutlineError, match=r"cross|meet"):
        vector.read_vector(file)
