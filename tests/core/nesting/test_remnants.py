# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left of film is kept as a shape, and pieces are laid inside it by all rules of a layout."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, corners_of
from shapely import affinity

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.layout import GrainRule, Layout, Piece, Stock, left_of
from BalloonWorkbench.core.nesting.nest import nest
from BalloonWorkbench.core.nesting.remnant import Remnant, read_remnants, remnant_bytes, usable
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Role

BARE = PatternOptions(intake=False)
HEART = build_pattern(NAMED["heart"].map(lambda loop: 0.3 * loop), 0.005, BARE)
SQUARE = build_pattern(corners_of((0.0, 0.0), (0.06, 0.0), (0.06, 0.06), (0.0, 0.06)), 0.005, BARE)
#: An L of film with a hole.
BENT = shapely.Polygon(
    [(0, 0), (0.5, 0), (0.5, 0.2), (0.2, 0.2), (0.2, 0.45), (0, 0.45)],
    [[(0.05, 0.05), (0.1, 0.05), (0.1, 0.1), (0.05, 0.1)]],
)


@pytest.fixture(autouse=True)
def rows(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")


def areas(layout: Layout, pieces: list[Piece]) -> list[shapely.Polygon]:
    found = []
    for place in layout.places:
        (cut,) = pieces[place.piece].pattern.of(Role.CUT)
        area = shapely.Polygon(cut.points)
        if place.mirrored:
            area = affinity.scale(area, -1.0, 1.0, origin=(0.0, 0.0))
        area = affinity.rotate(area, place.angle, origin=(0.0, 0.0), use_radians=True)
        found.append(affinity.translate(area, *place.shift))
    return found


def hold(layout: Layout, pieces: list[Piece], film: shapely.Polygon) -> None:
    laid, spacing = areas(layout, pieces), layout.stock.spacing
    for number, area in enumerate(laid):
        assert film.contains(area)
        assert area.distance(film.boundary) >= spacing - 1e-9
        assert all(area.distance(other) >= spacing - 1e-9 for other in laid[:number])
    assert layout.utilisation == pytest.approx(sum(area.area for area in laid) / film.area, rel=1e-6)


@pytest.mark.parametrize(("grain", "squares"), [(GrainRule.ALONG, 6), (GrainRule.ANY, 1)])
def test_pieces_lie_inside_a_remnant(grain: GrainRule, squares: int) -> None:
    pieces = [Piece(SQUARE, squares), Piece(HEART, 1, 1)]
    layouts, remarks = nest(
        pieces, Stock(0.5, None, 0.003, grain), remnants=[Remnant(BENT)], only_remnants=True
    )
    (layout,) = layouts
    assert not remarks
    assert len(layout.places) == squares + 2
    hold(layout, pieces, BENT)
    assert layout.pattern(pieces).film == (0.5, 0.45)
    again, _ = nest(pieces, Stock(0.5, None, 0.003, grain), remnants=[Remnant(BENT)], only_remnants=True)
    assert [place.shift.tolist() for place in again[0].places] == [
        place.shift.tolist() for place in layout.places
    ]


def test_a_full_strip_is_filled_to_the_end() -> None:
    """Four squares of 71 mm in a strip that holds them with 3 mm to spare; a fifth has no room."""
    side = SQUARE.size[0]
    film = shapely.box(0.0, 0.0, 4.0 * side + 5.0 * 0.003 + 0.003, side + 2.0 * 0.003 + 0.003)
    for count, left in ((4, 0), (5, 1)):
        (layout, *more), _ = nest([Piece(SQUARE, count)], Stock(0.2), remnants=[Remnant(film)])
        assert len(layout.places) == 4
        assert len(more) == left
        hold(layout, [Piece(SQUARE)], film)


def test_what_finds_no_room_goes_on_film_or_is_told() -> None:
    pieces = [Piece(SQUARE, 21)]
    small, large = Remnant(shapely.box(0.0, 0.0, 0.07, 0.1)), Remnant(BENT)
    layouts, _ = nest(pieces, Stock(0.3), remnants=[small, large])
    assert [layout.stock.remnant for layout in layouts] == [large, None]
    assert sum(len(layout.places) for layout in layouts) == 21
    with pytest.raises(InputError, match="For 21 of 21 pieces there is no room on the remnant"):
        nest(pieces, Stock(0.3), remnants=[small], only_remnants=True)


def test_stopping_leaves_the_rest_for_the_film() -> None:
    layouts, _ = nest([Piece(SQUARE, 3)], Stock(0.3), lambda share, _text: share < 0.5, [Remnant(BENT)])
    assert [len(layout.places) for layout in layouts] == [2, 1]


def test_what_is_left_is_film_of_the_next_layout(tmp_path: Path) -> None:
    """Of a sheet with three squares; no piece of the second layout lies where the first one took film."""
    pieces = [Piece(SQUARE, 3)]
    (first,), _ = nest(pieces, Stock(0.25, 0.3))
    kept = left_of(first, pieces)
    taken = shapely.union_all(areas(first, pieces))
    whole = shapely.box(0.0, 0.0, 0.3, 0.25)
    assert kept[0].area.area == pytest.approx(whole.area - taken.area, rel=0.2)
    (tmp_path / "remnant.json").write_bytes(remnant_bytes(kept))
    read = read_remnants(tmp_path / "remnant.json")
    assert [each.area.equals_exact(other.area, 1e-6) for each, other in zip(read, kept, strict=True)]
    (second,), _ = nest([Piece(HEART, 2)], Stock(0.25), remnants=read, only_remnants=True)
    hold(second, [Piece(HEART)], read[0].area)
    # back where it was cut from: the remnant's box begins where its film does
    low = np.array(usable_bounds(whole.difference(taken)))
    for area in areas(second, [Piece(HEART)]):
        assert affinity.translate(area, *low).distance(taken) > 0.002
    again = left_of(second, [Piece(HEART, 2)])
    assert all(each.area.area < read[0].area.area for each in again)


def usable_bounds(area: shapely.Geometry) -> tuple[float, float]:
    """Lower left corner of what is kept of an area: its narrow strips are not."""
    opened = area.buffer(-0.015, join_style="mitre").buffer(0.015, join_style="mitre")
    largest = max(shapely.get_parts(opened), key=lambda part: part.area)
    return largest.bounds[0], largest.bounds[1]


def test_slivers_are_waste() -> None:
    strip = shapely.box(0.0, 0.0, 1.0, 0.02)
    crumb = shapely.box(0.0, 1.0, 0.04, 1.04)
    assert not usable(shapely.union_all([strip, crumb]))
    (only,) = usable(shapely.union_all([strip, shapely.box(0.5, 2.0, 0.6, 2.1)]), "valve")
    assert only.stock == "valve"
    assert only.area.bounds[:2] == (0.0, 0.0)


def test_an_outline_that_somebody_drew_is_a_remnant(tmp_path: Path) -> None:
    path = tmp_path / "left.json"
    path.write_text(json.dumps({"unit": "cm", "outer": [[1, 1], [11, 1], [1, 21]]}))
    (read,) = read_remnants(path)
    assert read.size == pytest.approx((0.1, 0.2))
    assert read.area.area == pytest.approx(0.01)


LOOP = [[0, 0], [100, 0], [0, 100]]


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ("", "of no use"),
        ("[]", "of no use"),
        ("{}", "lacks 'unit'"),
        ('{"unit": "mm"}', "0 shapes"),
        ('{"unit": "mm", "remnants": []}', "0 shapes"),
        ('{"unit": "mm", "remnants": [{}]}', "lacks 'outer'"),
        ({"unit": "elbow", "outer": LOOP}, "no unit"),
        ({"unit": "m", "outer": LOOP}, "right unit"),
        ({"unit": "mm", "outer": [[0, 0], [1, 1]]}, "three points"),
        ({"unit": "mm", "outer": [1, 2, 3]}, "three points"),
        ({"unit": "mm", "outer": [[0, 0], [9, 9], [9, 0], [0, 9]]}, "cross or touch"),
        ({"unit": "mm", "outer": LOOP, "holes": [[[50, 60], [90, 99], [60, 90]]]}, "cross or touch"),
        ('{"unit": "mm", "outer": [[0, 0], [1e999, 0], [0, 1]]}', "of no use"),
        ({"unit": "mm", "remnants": [{"outer": LOOP}] * 51}, "51 shapes"),
        ({"unit": "mm", "outer": "abc"}, "of no use"),
    ],
)
def test_spoiled_files_are_a_sentence(tmp_path: Path, content: object, told: str) -> None:
    path = tmp_path / "remnant.json"
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    with pytest.raises(InputError, match=f"The remnant remnant.json.*{told}"):
        read_remnants(path)
    with pytest.raises(InputError, match="of no use"):
        read_remnants(tmp_path / "none.json")


def test_a_layout_on_a_remnant_has_its_own_film() -> None:
    layout = nest([Piece(SQUARE)], Stock(0.3), remnants=[Remnant(BENT)])[0][0]
    assert (layout.length, layout.stock.width) == (0.5, 0.45)
    assert replace(layout.stock, remnant=None).film.area == pytest.approx(0.5 * 0.45)
