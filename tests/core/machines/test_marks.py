# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registration marks have the shapes, sizes and places that makers ask for; what does not fit is said."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.machine import FOLDER, Machine, machine, machines, read_machine
from BalloonWorkbench.core.machines.marks.choose import marks_for, other_marks
from BalloonWorkbench.core.machines.marks.place import marked, marked_back
from BalloonWorkbench.core.machines.marks.style import CROSSES
from BalloonWorkbench.core.machines.toolpaths import draw
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role

MM = 1e-3
LOOKING = [name for name, known in machines().items() if not known.marks.are_seen]


def sheet(width: float, height: float, bleed: float = 3.0) -> Pattern:
    """An ellipse of film [mm] with its print round it."""
    turns = np.linspace(0.0, 2.0 * np.pi, 240, endpoint=False)
    round_ = np.column_stack([np.cos(turns), np.sin(turns)])
    cut = Contour(Role.CUT, 0.5 * MM * round_ * (width, height), True)
    print_ = Contour(Role.PRINT, 0.5 * MM * round_ * (width + 2.0 * bleed, height + 2.0 * bleed), True)
    return Pattern((print_, cut), None, 0.005, 0.4)


def shapes(pattern: Pattern) -> list[shapely.Polygon]:
    """The marks from the page's lower left corner [mm]."""
    assert pattern.page is not None
    low = pattern.page[0]
    return [shapely.Polygon((mark.points - low) / MM) for mark in pattern.of(Role.REGISTRATION)]


def boxes(pattern: Pattern) -> list[list[float]]:
    return sorted(np.round(shape.bounds, 3).tolist() for shape in shapes(pattern))


def changed(folder: Path, name: str = "summa", **values: object) -> Machine:
    """A copy of a machine with other marks."""
    data = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    path = folder / "mine.json"
    path.write_text(json.dumps({**data, "name": "mine", "marks": {**data["marks"], **values}}))
    return read_machine(path)


def test_silhouette() -> None:
    """inkscape-silhouette's render_silhouette_regmarks.py: a square of 5 mm with its corner, and lines of
    20 mm with their middles, 10 mm from the edges of A4; 190 and 277 mm apart, as its guide has it.
    Silhouette Studio's own: 0.394, 0.33 and 0.039 in, as proxies-at-home has them."""
    for name, inset, arm, line in (
        ("silhouette-inkscape", 10.0, 20.0, 0.3),
        ("silhouette", 0.394 * 25.4, 0.33 * 25.4, 0.039 * 25.4),
    ):
        laid = marked(sheet(150, 180), machine(name).marks)
        assert (laid.page[1] - laid.page[0]) / MM == pytest.approx([210.0, 297.0])
        half = 0.5 * line
        right, top = 210.0 - inset, 297.0 - inset
        assert boxes(laid) == [
            pytest.approx([inset - half, inset - half, inset + arm, inset + arm], abs=1e-3),
            pytest.approx([inset, top - 5, inset + 5, top], abs=1e-3),
            pytest.approx([right - arm, top - arm, right + half, top + half], abs=1e-3),
        ]
        assert sum(shape.area for shape in shapes(laid)) == pytest.approx(25 + 4 * arm * line, rel=1e-9)


def test_paper_lies_across_where_the_print_fits_only_so() -> None:
    """Also on the back; upright wherever it fits upright."""
    marks = machine("silhouette-inkscape").marks
    for own, across in ((sheet(200, 100), True), (sheet(100, 200), False), (sheet(150, 150), False)):
        front = marked(own, marks)
        for laid in (front, marked_back(front, marks)):
            size = np.ptp(np.array(laid.page), axis=0) / MM
            assert size == pytest.approx([297.0, 210.0] if across else [210.0, 297.0])
            film = shapely.Polygon((laid.of(Role.PRINT)[0].points - laid.page[0]) / MM)
            assert shapely.box(*shapely.union_all(shapes(laid)).bounds).contains(film)


def test_four_corners_of_silhouette() -> None:
    """Template of inkscape-silhouette for the Cameo 5 Alpha: four lines of 20 mm, 0.3 mm wide, inward, 10 mm
    from the edges of A4."""
    laid = marked(sheet(150, 180), machine("silhouette-alpha").marks)
    assert boxes(laid) == [
        pytest.approx([x - 0.15 if x < 100 else x - 20, y - 0.15 if y < 100 else y - 20,
                       x + 20 if x < 100 else x + 0.15, y + 20 if y < 100 else y + 0.15])
        for x in (10, 200) for y in (10, 287)
    ]  # fmt: skip


def test_corners_point_outward() -> None:
    """Graphtec CE7000: type 1, lines 0.3 to 1.0 mm of 5 to 20 mm, 6 mm round them white. Mimaki CG: shape 1,
    10 mm by default of 4 to 40 mm, line from 0.5 mm, as much white as they are long."""
    for name, clear in (("graphtec", 6.0), ("mimaki", 10.0)):
        laid = marked(sheet(100, 60), machine(name).marks)
        found = shapes(laid)
        assert len(found) == 4
        middle = shapely.box(*shapely.union_all(found).bounds).centroid
        film = shapely.Polygon((laid.of(Role.PRINT)[0].points - laid.page[0]) / MM)
        for shape in found:
            low, high = np.array(shape.bounds[:2]), np.array(shape.bounds[2:])
            assert high - low == pytest.approx([10.25, 10.25])
            assert shape.area == pytest.approx(2 * 10 * 0.5, rel=1e-9)
            # the bend is the corner of the box that is nearest to the print, and it is black
            corners = [shapely.Point(at) for at in shapely.box(*shape.bounds).exterior.coords]
            assert shape.distance(min(corners, key=middle.distance)) < 1e-9
            assert shape.distance(shapely.box(*film.bounds)) > clear - 1e-6


def test_discs() -> None:
    """Roland GS2-24: four filled discs of 10 to 12.5 mm, at most 1 600 mm apart. Zünd: dots of a quarter of
    an inch, and a fifth that tells how the sheet lies."""
    for name, size, count in (("roland", 10.0, 4), ("zuend", 6.35, 5)):
        found = shapes(marked(sheet(100, 60), machine(name).marks))
        assert len(found) == count
        for shape in found:
            assert np.ptp(np.reshape(shape.bounds, (2, 2)), axis=0) == pytest.approx([size, size], rel=1e-3)
            assert shape.area == pytest.approx(np.pi * size**2 / 4, rel=2e-3)
    places = np.array([shape.centroid.coords[0] for shape in found])
    places -= places[:4].mean(axis=0)
    for turned in (places * (-1, 1), places * (1, -1), -places):  # mirrored or turned it is another one
        away = np.linalg.norm(places[:, None] - turned[None], axis=2).min(axis=1)
        assert away.max() > 20.0
    assert machine("zuend").layers[Role.REGISTRATION].name == "Register"
    with pytest.raises(InputError, match="takes at most 1600 x 1600 mm"):
        marked(sheet(400, 1700), machine("roland").marks)


def test_rows_of_squares() -> None:
    """Summa OPOS: black squares of 3 mm, white 3 to 4 times as wide round them, steps of at most 400 mm; XY
    has a bar of 3 mm, 10 mm from them. Also an airship of 3 m."""
    for width, height, rows in ((100, 60, 2), (500, 3000, 9)):
        laid = marked(sheet(width, height), machine("summa").marks)
        found = shapes(laid)
        assert len(found) == 2 * rows
        middles = np.array([shape.centroid.coords[0] for shape in found])
        assert np.unique(np.round(middles[:, 0], 6)).size == 2
        steps = np.diff(np.unique(np.round(middles[:, 1], 6)))
        assert (steps < 400.0).all()
        assert np.ptp(steps) < 1e-5
        assert all(np.ptp(np.reshape(s.bounds, (2, 2)), axis=0) == pytest.approx([3, 3]) for s in found)
        film = shapely.Polygon((laid.of(Role.PRINT)[0].points - laid.page[0]) / MM)
        assert min(shape.distance(film) for shape in found) >= 12.0 - 1e-6
        (bar,) = [s for s in shapes(marked(sheet(width, height), machine("summa-xy").marks)) if s.area > 9.1]
        left, low, right, high = bar.bounds
        assert high - low == pytest.approx(3.0)
        assert 0.5 * (low + high) == pytest.approx(middles[:, 1].min())
        assert left - middles[:, 0].min() == pytest.approx(11.5)
        assert middles[:, 0].max() - right == pytest.approx(11.5)
    assert machine("summa").layers[Role.REGISTRATION].name == "Regmark"


def test_programs_with_marks_of_their_own() -> None:
    """Cricut's Print Then Cut takes 6.75 x 9.25 in, as open programs for it have it; a print shop's program
    as much as it likes."""
    for name in ("cricut", "print-and-cut-pdf"):
        assert not marked(sheet(160, 225), machine(name).marks).of(Role.REGISTRATION)
    with pytest.raises(InputError, match="176 x 216 mm, and Cricut Design Space takes at most 171 x 235 mm"):
        marked(sheet(170, 210), machine("cricut").marks)
    assert marked(sheet(900, 900), machine("print-and-cut-pdf").marks).page is not None


@pytest.mark.parametrize("name", LOOKING)
def test_white_stays_and_nothing_is_cut_outside(name: str) -> None:
    """Round a balloon of 30 mm and as large as the page bears; on the front as on the back."""
    marks = machine(name).marks
    for own in (sheet(30, 30), sheet(120, 175), sheet(164, 90)):
        front = marked(own, marks)
        back = marked_back(front, marks)
        for laid in (front, back):
            film = shapely.Polygon((laid.of(Role.PRINT)[0].points - laid.page[0]) / MM)
            found = shapes(laid)
            if not found:
                continue
            assert shapely.union_all(found).distance(film) >= marks.clear / MM - 1e-6
            assert shapely.box(*shapely.union_all(found).bounds).contains(film)
            paper = shapely.box(0, 0, *((laid.page[1] - laid.page[0]) / MM))
            inset = min(paper.exterior.distance(shape) for shape in found)
            assert inset >= (marks.inset - 0.5 * marks.line) / MM - 1e-6
        assert boxes(back) == [pytest.approx(box) for box in boxes(front)]  # never mirrored
        assert draw(front, machine(name)).width == pytest.approx(float(np.ptp(front.page, axis=0)[0]) / MM)


def test_marks_take_the_place_of_others() -> None:
    """Also of the crosses for the eye; those are mirrored with the back, and need no page."""
    own = sheet(100, 60)
    crosses = marked(own)
    assert len(crosses.of(Role.REGISTRATION)) == 9
    assert crosses.page is None
    there = marked(crosses, machine("roland").marks)
    assert len(there.of(Role.REGISTRATION)) == 4
    again = marked(there)
    assert again.page is None
    assert np.allclose(again.bounds, crosses.bounds)
    low, high = marked_back(crosses).bounds
    assert np.allclose([-high[0], low[1]], crosses.bounds[0])
    moved = there.moved(np.array([0.2, 0.1]))
    assert np.allclose(np.array(moved.page) - np.array(there.page), [0.2, 0.1])


def test_what_does_not_fit_on_its_page() -> None:
    silhouette = machine("silhouette-inkscape").marks
    with pytest.raises(InputError, match="measures 206 x 206 mm, and between the marks of Silh") as told:
        marked(sheet(200, 200), silhouette)
    assert "there are 186 x 273 mm on paper of 210 x 297 mm" in str(told.value)
    square = sheet(150, 250)
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * 0.5 * MM
    filled = replace(
        square,
        contours=(
            Contour(Role.PRINT, corners * (180, 260), True),
            Contour(Role.CUT, corners * (174, 254), True),
        ),
    )
    with pytest.raises(InputError, match="reaches into the marks of Silhouette from Inkscape"):
        marked(filled, silhouette)
    free = replace(silhouette, page=None)  # on a roll there is room round it
    assert (np.ptp(marked(filled, free).page, axis=0) / MM > [220, 300]).all()
    narrow = replace(machine("summa-xy").marks, clear=0.0)
    with pytest.raises(InputError, match="bar of Summa with OPOS XY"):
        marked(sheet(16, 30), narrow)


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"style": "stars"}, 'style of marks "stars" is none of crosses'),
        ({"size_mm": -3}, "size_mm of marks is -3"),
        ({"size_mm": True}, "size_mm of marks is True"),
        ({"size_mm": None}, "lack size_mm"),
        ({"clear_mm": "wide"}, "clear_mm of marks is 'wide'"),
        ({"step_mm": 0}, "step_mm of marks is 0"),
        ({"colour": "red"}, 'have no "colour"'),
        ({"style": "discs"}, 'style discs have no "step_mm"'),
        ({"page_mm": 210}, "page_mm of marks is 210"),
        ({"page_mm": [210, -1]}, "page_mm of marks is -1"),
        ({"page_mm": [60, 60]}, "do not fit on a page_mm of 60 x 60 mm"),
        ({"size_mm": 40, "page_mm": [150, 150]}, "size_mm 40 and inset_mm 40 do not fit"),
        ({"size_mm": 0.2}, "size_mm of marks is 0.2"),
        ({"most_mm": [1]}, "most_mm of marks is"),
    ],
)
def test_mistakes_in_a_users_file_are_named(tmp_path: Path, values: dict[str, object], text: str) -> None:
    with pytest.raises(InputError, match=text) as caught:
        changed(tmp_path, **values)
    assert "mine.json" in str(caught.value)


def test_marks_that_are_no_marks(tmp_path: Path) -> None:
    data = json.loads((FOLDER / "summa.json").read_text(encoding="utf-8"))
    for value in ("squares", [], 3, None):
        (tmp_path / "mine.json").write_text(json.dumps({**data, "name": "mine", "marks": value}))
        with pytest.raises(InputError, match="marks is "):
            read_machine(tmp_path / "mine.json")
    data["layers"]["CUT"]["spot"] = "CutContour"
    (tmp_path / "mine.json").write_text(json.dumps({**data, "name": "mine"}))
    with pytest.raises(InputError, match="only a PDF has spot colours"):
        read_machine(tmp_path / "mine.json")


def test_whose_marks_a_print_has() -> None:
    """Those of the machine that is named; else of the first that looks for any; crosses for all others."""
    laser, knife, table = (machine(name) for name in ("lightburn", "summa", "zuend"))
    assert marks_for(None) == marks_for("", [laser]) == CROSSES
    assert marks_for(None, [laser, knife, table]) == knife.marks
    assert marks_for("zuend", [knife]) == table.marks
    cricut, shop = (machine(name) for name in ("cricut", "print-and-cut-pdf"))
    assert marks_for(None, [shop, cricut]) == shop.marks
    assert marks_for(None, [shop, laser]) == CROSSES
    assert other_marks(knife.marks, [shop]) == ()
    assert other_marks(knife.marks, [laser, knife]) == ()
    (told,) = other_marks(CROSSES, [laser, table])
    assert told.startswith(
        "The print has crosses for the eye, and Zünd Cut Center (flat bed) looks for others"
    )
    with pytest.raises(InputError, match="no machine"):
        marks_for("oracle")


def test_lines_as_wide_as_their_mark(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="at most half as wide as its mark"):
        changed(tmp_path, "mimaki", size_mm=4, line_mm=2.5)
    with pytest.raises(InputError, match="square_mm of marks is larger"):
        changed(tmp_path, "silhouette", square_mm=9)
