# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels on a roll and on sheets: none over another, spacing and grain kept, the same again."""

from __future__ import annotations

import _thread
import io
import math
import threading
import time
from dataclasses import replace
from itertools import combinations

import ezdxf
import numpy as np
import pytest
import shapely
from drawn_shapes import NAMED, corners_of
from gcode_reader import HOT, LASER, held, run
from shapely import affinity

from BalloonWorkbench.core.errors import InputError, SolverError
from BalloonWorkbench.core.film.library import film, with_grain
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.machines.preflight import preflight
from BalloonWorkbench.core.nesting import nest as nesting
from BalloonWorkbench.core.nesting.holes import into_holes
from BalloonWorkbench.core.nesting.layout import GrainRule, Layout, Piece, Stock
from BalloonWorkbench.core.nesting.nest import ROWS_NOTE, nest
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.pattern.placement import turned
from BalloonWorkbench.core.products import pieces_of

HEART = build_pattern(NAMED["heart"].map(lambda loop: 0.5 * loop), 0.005)
WEDGE = build_pattern(corners_of((0.0, 0.0), (0.12, 0.0), (0.12, 0.05)), 0.005, PatternOptions(intake=False))
RIGHT = pytest.mark.skipif(
    not nesting.importlib.util.find_spec(nesting.PACKAGE), reason="the nesting library is not installed"
)


def areas(layout: Layout, pieces: list[Piece]) -> list[shapely.Polygon]:
    """The pieces where they lie, by shapely's own mirroring and turning of the first pattern."""
    found = []
    for place in layout.places:
        (cut,) = pieces[place.piece].pattern.of(Role.CUT)
        area = shapely.Polygon(cut.points)
        if place.mirrored:
            area = affinity.scale(area, -1.0, 1.0, origin=(0.0, 0.0))
        area = affinity.rotate(area, place.angle, origin=(0.0, 0.0), use_radians=True)
        found.append(affinity.translate(area, *place.shift))
    return found


def hold(layout: Layout, pieces: list[Piece]) -> None:
    """All rules of a layout, looked at from outside."""
    stock, laid = layout.stock, areas(layout, pieces)
    for one, other in combinations(laid, 2):
        assert one.distance(other) >= stock.spacing - 2e-5
    box = shapely.box(0.0, 0.0, layout.length, stock.width)
    for area in laid:
        assert box.contains(area)
        assert area.distance(box.exterior) >= stock.spacing - 2e-5
    share = sum(area.area for area in laid) / (layout.length * stock.width)
    assert layout.utilisation == pytest.approx(share, rel=1e-9)
    if stock.grain is not GrainRule.ANY:
        wanted = 0.5 * math.pi if stock.grain is GrainRule.ACROSS else 0.0
        for place in layout.places:
            own = pieces[place.piece].grain
            if own is None:
                continue
            grain = (math.pi - own if place.mirrored else own) + place.angle
            assert math.sin(grain - wanted) == pytest.approx(0.0, abs=1e-6)
    whole = layout.pattern(pieces)
    found = sorted(shapely.Polygon(cut.points).centroid.x for cut in whole.of(Role.CUT))
    assert np.allclose(found, sorted(area.centroid.x for area in laid), atol=1e-9)


@RIGHT
def test_hearts_on_a_roll() -> None:
    """Fronts and mirrored backs, the grain of the film at an angle; closer than in rows."""
    pieces = [Piece(HEART, 2, 2, math.radians(20.0))]
    stock = Stock(0.32)
    began = time.process_time()
    (layout,), remarks = nest(pieces, stock, lambda share, text: time.process_time() < began + 1.0)
    assert not remarks
    assert [place.mirrored for place in layout.places] == [False, False, True, True]
    hold(layout, pieces)
    (row,) = nesting.in_rows(pieces, stock, [(0, False), (0, False), (0, True), (0, True)])
    assert layout.length < nesting.layout_of(stock, pieces, row).length - 0.01


@pytest.mark.slow
@RIGHT
def test_wedges_find_into_each_other() -> None:
    """Two triangles make about a rectangle: the library really nests, boxes would take twice the film; and
    the same comes out again, to the last digit."""
    pieces = [Piece(WEDGE, 2)]
    (layout,), _ = nest(pieces, Stock(0.085, spacing=0.002))
    hold(layout, pieces)
    (again,), _ = nest(pieces, Stock(0.085, spacing=0.002))
    assert [(*place.shift, place.angle) for place in again.places] == [
        (*place.shift, place.angle) for place in layout.places
    ]
    width, _ = WEDGE.size
    assert layout.length < 1.5 * width


@pytest.mark.slow
@RIGHT
def test_sheets_hold_as_many_as_fit() -> None:
    width, height = WEDGE.size
    stock = Stock(height + 0.03, 1.5 * width, 0.002)
    pieces = [Piece(WEDGE, 5)]
    layouts, _ = nest(pieces, stock)
    assert [len(layout.places) for layout in layouts] == [2, 2, 1]
    for layout in layouts:
        hold(layout, pieces)
        assert layout.length == stock.length


@RIGHT
@pytest.mark.parametrize("width", [0.15, 1.5, 19.0])
def test_one_piece_on_any_width(width: float) -> None:
    pieces = [
        Piece(
            build_pattern(
                corners_of((0, 0), (0.1, 0), (0.1, 0.01), (0, 0.01)), 0.003, PatternOptions(intake=False)
            )
        )
    ]
    (layout,), _ = nest(pieces, Stock(width), lambda share, text: share < 0.02)
    hold(layout, pieces)
    assert layout.length < 0.15


@RIGHT
def test_stopping_takes_what_there_is() -> None:
    pieces = [Piece(HEART, 2)]
    asked: list[str] = []
    (layout,), _ = nest(pieces, Stock(0.32), lambda share, text: not (asked.append(text) or "mm" in text))
    hold(layout, pieces)
    assert "so far" in asked[-1]


@RIGHT
@pytest.mark.parametrize("ticks", [1, 3])
def test_a_stop_that_comes_after_the_end_is_too_late(ticks: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The search is over and its timer ticks on: on a busy machine that happens."""

    def late(done: threading.Event) -> None:
        done.wait()
        for _ in range(ticks):
            _thread.interrupt_main(nesting._SIGNAL)

    monkeypatch.setattr(nesting, "_tick", late)
    monkeypatch.setattr(nesting, "_LIMIT", 1)
    pieces = [Piece(HEART, 2)]
    (layout,), _ = nest(pieces, Stock(0.32), lambda share, text: False)
    hold(layout, pieces)


@pytest.mark.parametrize("grain", list(GrainRule))
@pytest.mark.parametrize("length", [None, 0.45])
def test_without_the_library_rows_do(
    grain: GrainRule, length: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    pieces = [Piece(HEART, 3, 3, math.radians(30.0)), Piece(WEDGE, 4)]
    layouts, remarks = nest(pieces, Stock(0.5, length, 0.004, grain))
    assert remarks == (ROWS_NOTE,)
    assert sum(len(layout.places) for layout in layouts) == 10
    assert len(layouts) == 1 or length is not None
    for layout in layouts:
        hold(layout, pieces)


def test_every_machine_takes_the_sheet(monkeypatch: pytest.MonkeyPatch) -> None:
    """All pieces and their lines are in the file; holes stay with their pieces."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    holed = build_pattern(NAMED["ring"].map(lambda loop: 0.4 * loop), 0.004, PatternOptions(intake=False))
    pieces = [Piece(holed, 1, 1), Piece(HEART)]
    (layout,), _ = nest(pieces, Stock(0.3))
    sheet = layout.pattern(pieces)
    assert sheet.seam_length == pytest.approx(2.0 * holed.seam_length + HEART.seam_length)
    assert len(sheet.of(Role.CUT_INNER)) == 2
    for cut in sheet.of(Role.CUT):
        assert shapely.LinearRing(cut.points).is_ccw
    for known in machines().values():
        if known.tool is None:
            assert len(machine_file(sheet, known)) > 200
    made_for = machines()["cutting-shop"]
    content = machine_file(sheet, made_for).decode("cp1252")
    lines = ezdxf.read(io.StringIO(content)).modelspace()
    assert len([line for line in lines if line.dxf.layer == "CUT"]) == 3


@pytest.mark.parametrize("package", [nesting.PACKAGE, "no_such_package"])
def test_small_pieces_lie_in_holes(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Front and back of a small heart in the rings, 3 mm from them, with the grain of both along the film."""
    monkeypatch.setattr(nesting, "PACKAGE", package)
    ring = build_pattern(NAMED["ring"].map(lambda loop: 0.8 * loop), 0.004, PatternOptions(intake=False))
    heart = build_pattern(NAMED["heart"].map(lambda loop: 0.15 * loop), 0.004, PatternOptions(intake=False))
    pieces = [Piece(ring, 1, 1, math.radians(50.0)), Piece(heart, 1, 1, math.radians(20.0))]
    (layout,), _ = nest(pieces, Stock(0.4), lambda share, text: share < 0.02)
    (alone,), _ = nest(pieces[:1], Stock(0.4), lambda share, text: share < 0.02)
    assert layout.length == pytest.approx(alone.length, abs=1e-6)
    assert layout.utilisation > alone.utilisation
    assert [(place.piece, place.mirrored) for place in layout.places] == [
        (0, False), (0, True), (1, False), (1, True)
    ]  # fmt: skip
    sheet = layout.pattern(pieces)
    cuts = sorted((shapely.Polygon(cut.points) for cut in sheet.of(Role.CUT)), key=lambda cut: cut.area)
    holes = [shapely.Polygon(cut.points) for cut in sheet.of(Role.CUT_INNER)]
    for small in cuts[:2]:
        (hole,) = (each for each in holes if each.contains(small))
        assert hole.exterior.distance(small) >= 0.003 - 1e-9
    for place in layout.places:
        own = pieces[place.piece].grain
        assert math.sin((math.pi - own if place.mirrored else own) + place.angle) == pytest.approx(
            0.0, abs=1e-6
        )


@pytest.mark.parametrize("spacing", [0.003, 0.0])
def test_zero_of_a_tool_is_the_corner_of_the_film(spacing: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """G-code has the pieces where they lie on the film, from its corner, and a bed as large as the film is
    enough; where pieces lie at its very edge, zero is 1 mm beside them."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    (layout,), _ = nest([Piece(WEDGE, 3)], Stock(0.2, spacing=spacing))
    sheet, film_size = layout.pattern([Piece(WEDGE, 3)]), (layout.length, 0.2)
    for tool, kerf in ((LASER, 2e-4), (HOT, 0.0)):
        made_for = held("grbl", tool, kerf=kerf, bed=film_size if spacing else None)
        if spacing:
            assert not any(finding.oversize for finding in preflight(sheet, made_for))
        read = run(sheet, made_for)
        lines = shapely.MultiLineString([stroke.line for stroke in read.strokes])
        low = np.full(2, min(0.0, 1e3 * spacing - 1.0))
        edge = shapely.box(0.0, 0.0, *(1e3 * np.array(film_size))).buffer(1e-3 - low[0], join_style="mitre")
        assert edge.covers(affinity.translate(lines, *low))
        roles = [Role.CUT] if tool is LASER else [Role.SEAL]
        for contour in (each for role in roles for each in sheet.of(role)):
            ring = affinity.translate(shapely.LinearRing(1e3 * contour.points), *-low)
            assert lines.buffer(0.15).covers(ring)
    assert turned(sheet, 0.3, np.zeros(2)).film is sheet.moved(np.ones(2)).film is None


def test_film_without_a_grain_may_be_turned(monkeypatch: pytest.MonkeyPatch) -> None:
    """A long strip lies across the roll where its film lets it; on one with a grain it lies along."""
    monkeypatch.setattr(nesting, "PACKAGE", "no_such_package")
    strip = build_pattern(
        corners_of((0, 0), (0.3, 0), (0.3, 0.02), (0, 0.02)), 0.005, PatternOptions(intake=False)
    )
    lengths = {}
    for name in ("mylar", "bopp-foil", "kraft-paper"):
        pieces = pieces_of(strip, strip, 2, film(name).lies)
        (layout,), _ = nest(pieces, Stock(0.5))
        hold(layout, pieces)
        lengths[name] = layout.length
    assert lengths["mylar"] < 0.2 < strip.size[0] < lengths["bopp-foil"] == lengths["kraft-paper"]
    turned = with_grain(film("mylar"), 2e9, 0.5)
    assert [piece.grain for piece in pieces_of(strip, strip, 1, turned.lies)] == [0.5]


def test_guests_bear_what_their_hosts_do() -> None:
    """In a ring that may be turned anyhow lies nothing that may not."""
    ring = build_pattern(NAMED["ring"].map(lambda loop: 0.8 * loop), 0.004, PatternOptions(intake=False))
    heart = build_pattern(NAMED["heart"].map(lambda loop: 0.15 * loop), 0.004, PatternOptions(intake=False))
    units = [(0, False), (1, False)]
    for host, guest, left in ((None, 0.3, 2), (None, None, 1), (0.2, 0.3, 1), (0.2, None, 1)):
        alone, _ = into_holes([Piece(ring, grain=host), Piece(heart, grain=guest)], Stock(0.4), units)
        assert len(alone) == left, (host, guest)


def test_back_leaves_out_what_only_the_front_has() -> None:
    (cut,) = HEART.of(Role.CUT)
    hole = replace(cut, role=Role.CUT_INNER, points=0.1 * cut.points, front=True)
    pattern: Pattern = replace(HEART, contours=(hole, *HEART.contours))
    piece = Piece(pattern, 1, 1)
    assert len(piece.panel(False).of(Role.CUT_INNER)) == 1
    assert not piece.panel(True).of(Role.CUT_INNER)
    assert piece.panel(True).size == pytest.approx(HEART.size)


@pytest.mark.parametrize(
    ("pieces", "stock", "text"),
    [
        ([Piece(HEART, 0)], Stock(0.5), "pieces"),
        ([Piece(HEART, 500)], Stock(0.5), "pieces"),
        ([Piece(HEART)], Stock(0.1), "does not fit"),
        ([Piece(HEART)], Stock(0.5, 0.05), "does not fit"),
        ([Piece(HEART)], Stock(0.5, spacing=-0.001), "spacing"),
        ([Piece(HEART)], Stock(math.nan), "width"),
        ([Piece(HEART)], Stock(500.0), "write 500mm"),
    ],
)
def test_senseless_wishes_are_refused(pieces: list[Piece], stock: Stock, text: str) -> None:
    with pytest.raises(InputError, match=text):
        nest(pieces, stock)


class _Panic(BaseException):
    """What the search raises in Rust: no Exception."""


@pytest.mark.parametrize(
    ("raised", "told"), [(_Panic(), SolverError), (MemoryError(), MemoryError), (KeyError("x"), KeyError)]
)
def test_what_ends_the_search_in_its_thread_is_told(
    raised: BaseException, told: type[BaseException], capfd: pytest.CaptureFixture[str]
) -> None:
    class Search:
        def solve(self, config: object, queue: object) -> None:
            raise raised

    with pytest.raises(told):
        nesting._beside(Search(), None, None, lambda: None)
    assert not capfd.readouterr().err
