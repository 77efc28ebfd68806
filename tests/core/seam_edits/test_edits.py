# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divisions after edits: areas, seams and panels by formulas; what cannot be done is told."""

from __future__ import annotations

import numpy as np
import pytest
from solids import ball, box, torus

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.seam_edits.apply_edits import apply_edits
from BalloonWorkbench.core.seam_edits.edit import (
    CUT,
    LINE,
    MERGE,
    MOVE,
    NEAR,
    PLANE,
    SYMMETRY,
    SeamEdit,
    no_direction,
)
from BalloonWorkbench.core.seam_edits.operations import seam_between
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.target import Division, Target

Place = tuple[float, float, float]
NO_CUTS = np.zeros((0, 2), dtype=np.int32)


def edit(kind: str, *points: Place, along: Place = (0.0, 0.0, 0.0), **more: object) -> SeamEdit:
    more.setdefault("mirrored", False)
    at = np.array(points, dtype=float).reshape(-1, 3)
    return SeamEdit(kind, at, np.array(along), **more)  # type: ignore[arg-type]


def plane(along: Place, at: Place = (0.0, 0.0, 0.0)) -> SeamEdit:
    return edit(PLANE, at, along=along)


def line(*points: Place, along: Place = (0.0, 0.0, 1.0), side: str = "both") -> SeamEdit:
    return edit(LINE, *points, along=along, side=side)


def cube(count: int = 6) -> Division:
    """Its faces: West, East, South, North, Bottom, Top."""
    target = box(count=count)
    middles = target.points[target.triangles].mean(axis=1)
    axis = np.argmax(np.abs(middles), axis=1)
    faces = 2 * axis + (middles[np.arange(len(axis)), axis] > 0.0)
    names = ("West", "East", "South", "North", "Bottom", "Top")
    return Division(target, faces.astype(np.int32), names, NO_CUTS)


def whole(target: Target) -> Division:
    return divide(target, 1)


def euler(made: Division) -> list[int]:
    """Vertices - edges + triangles of each panel as it is cut open: 1 for a disc."""
    opened = made.opened
    edges = np.where(made.seam_edges, 1.0, 0.5)
    count = np.bincount(opened.panels) + np.bincount(made.panels)
    return np.rint(count - np.bincount(np.repeat(made.panels, 3), edges)).astype(int).tolist()


def areas(made: Division) -> dict[str, float]:
    """Of each panel, as a part of the whole."""
    parts = np.bincount(made.panels, made.target.areas, len(made.names)) / made.target.areas.sum()
    return dict(zip(made.names, parts.tolist()))


def seam_length(made: Division) -> float:
    return sum(length(made.target.points[seam.vertices]) for seam in made.seams)


def check(before: Division, made: Division) -> None:
    """The same closed surface in panels that can be laid flat, with equal seams."""
    assert made.target.areas.sum() == pytest.approx(before.target.areas.sum(), rel=1e-9)
    assert made.target.volume == pytest.approx(before.target.volume, rel=1e-9)
    assert (made.target.twins >= 0).all()
    assert made.target.areas.min() > 0.0
    assert set(euler(made)) == {1}
    assert len(set(made.names)) == len(made.names) == made.panels.max() + 1
    flats = flatten(made)
    assert all(np.isfinite(flat).all() for flat in flats)
    bag_of(made, flats)


def test_planes_cut_a_ball_into_caps() -> None:
    """The part of a ball's surface above a height h is (1 - h) / 2 (Archimedes)."""
    body = whole(ball(count=25))
    planes = plane((0.0, 0.0, 1.0), (0.0, 0.0, 0.5)), plane((0.0, 0.0, 2.0)), plane((1.0, 0.0, 0.0))
    made = apply_edits(body, planes)
    check(body, made)
    assert sorted(areas(made).values()) == pytest.approx([0.125] * 4 + [0.25] * 2, abs=2e-3)
    assert seam_length(made) == pytest.approx(2.0 * np.pi * (2.0 + np.sqrt(0.75)), rel=2e-3)


def test_planes_of_symmetry_cut_a_box_into_eighths() -> None:
    body = whole(box((1.0, 2.0, 3.0)))
    made = apply_edits(body, (edit(SYMMETRY),))
    check(body, made)
    assert list(areas(made).values()) == pytest.approx([0.125] * 8)
    assert seam_length(made) == pytest.approx(2.0 * (1 + 2 + 2 + 3 + 1 + 3))
    again = apply_edits(made, (edit(SYMMETRY),))
    assert again.names == made.names
    assert "already" in again.target.notes[-1]


def test_a_projected_line_cuts_both_sides_or_the_near_one() -> None:
    body = cube()
    across = ((0.2, -2.0, 3.0), (0.2, 2.0, 3.0))
    made = apply_edits(body, (line(*across),))
    check(body, made)
    assert made.names[6:] == ("Southb", "Northb", "Bottomb", "Topb")
    assert areas(made)["Topb"] == pytest.approx(0.3 / 6.0, rel=1e-3)
    near = apply_edits(body, (line(*across, side=NEAR),))
    assert near.names[6:] == ("Topb",)
    below = apply_edits(body, (line((0.2, -2.0, -3.0), (0.2, 2.0, -3.0), side=NEAR),))
    assert below.names[6:] == ("Bottomb",)


def test_a_circle_that_is_projected_onto_a_ball() -> None:
    """Two caps, and a ring between them that is not cut open by itself: the user draws all seams."""
    angles = np.linspace(0.0, 2.0 * np.pi, 40)
    circle = [(0.5 * np.cos(angle), 0.5 * np.sin(angle), 3.0) for angle in angles]
    body = whole(ball(count=20))
    with pytest.raises(InputError, match=r"goes round the body.*Draw a seam across it"):
        apply_edits(body, (line(*circle),))
    made = apply_edits(body, (line(*circle), line((0.0, -3.0, 3.0), (0.0, 0.0, 3.0))))
    caps = sorted(areas(made).values())
    # the caps are cut by the line, too
    assert sum(caps[:2]) == pytest.approx(1.0 - np.sqrt(0.75), rel=0.02)


def test_a_line_through_the_hole_of_a_ring() -> None:
    """Seen along the axis it meets the tube twice, seen from the side as two rings, inner and outer."""
    body = whole(torus())
    tubes = apply_edits(body, (line((-3.0, 0.013, 3.0), (3.0, 0.013, 3.0)), plane((0.0, 0.0, 1.0))))
    check(body, tubes)
    assert len(tubes.names) == 4
    rings = seam_length(
        apply_edits(
            body, (plane((0.0, 1.0, 0.0)), line((-3.0, 3.0, 0.0), (3.0, 3.0, 0.0), along=(0.0, 1.0, 0.0)))
        )
    )
    assert rings == pytest.approx(2.0 * np.pi * (1.4 + 0.6 + 0.8), rel=5e-3)


def test_a_great_circle_between_two_places_goes_straight_on_to_the_next_seams() -> None:
    body = apply_edits(whole(ball(count=25)), (plane((0.0, 0.0, 1.0)),))
    made = apply_edits(body, (edit(CUT, (0.3, 0.1, 0.9), (-0.2, -0.1, 0.97)),))
    check(body, made)
    assert len(made.names) == 3
    # the way on is half a great circle from equator to equator
    assert seam_length(made) == pytest.approx(3.0 * np.pi, rel=5e-3)


def test_a_cut_keeps_names_and_halves_the_face() -> None:
    body = cube()
    made = apply_edits(body, (edit(CUT, (-0.5, 0.0, 0.5), (0.5, 0.0, 0.5), panels=("Top",)),))
    check(body, made)
    assert made.names == (*body.names, "Topb")
    assert areas(made)["Top"] == pytest.approx(1.0 / 12.0)
    assert seam_length(made) == pytest.approx(13.0)


def test_a_cut_across_three_panels() -> None:
    body = cube()
    made = apply_edits(body, (edit(CUT, (-0.5, 0.1, 0.0), (0.0, 0.1, 0.5), (0.5, 0.1, 0.0)),))
    check(body, made)
    # it goes straight on below, to the bottom
    assert made.names[6:] == ("Westb", "Eastb", "Topb")


@pytest.mark.parametrize(
    ("points", "says"),
    [
        (((0.5, -0.5, 0.5), (0.5, 0.5, 0.5)), "divides no panel"),  # along a seam that is there
        (((0.0, 0.0, 0.5), (0.0, 0.0, 0.5)), "one place only"),
        (((0.0, 0.0, 5.0), (0.0, 0.4, 0.5)), "nothing near"),
        (((0.0, 0.0, 0.5),), "more places"),
        (((0.499, -0.5, 0.5), (0.499, 0.5, 0.5)), "divides no panel"),  # a sliver
    ],
)
def test_cuts_that_divide_nothing_are_told(points: tuple[Place, ...], says: str) -> None:
    body = cube()
    made = apply_edits(body, (edit(CUT, *points),))
    assert made.names == body.names
    (note,) = made.target.notes
    assert note.startswith("Seam edit 1 is left out.")
    assert says in note


def test_two_faces_merged_are_one_that_folds() -> None:
    body = cube()
    made = apply_edits(body, (edit(MERGE, (0.5, 0.0, 0.5), panels=("Top", "East")),))
    check(body, made)
    assert made.names == ("West", "East", "South", "North", "Bottom")
    assert areas(made)["East"] == pytest.approx(1.0 / 3.0)
    assert seam_length(made) == pytest.approx(11.0)


def test_a_ring_of_faces_stays_open_at_the_last_seam() -> None:
    """The four sides of a cube: the last merge would close the ring, so that it stays cut there."""
    body = cube()
    ring = [((0.5, 0.5, 0.0), "NE"), ((-0.5, 0.5, 0.0), "NW"), ((-0.5, -0.5, 0.0), "SW")]
    made = apply_edits(body, tuple(edit(MERGE, at) for at, _ in ring))
    check(body, made)
    assert not made.target.notes
    assert made.names == ("West", "Bottom", "Top")
    assert seam_length(made) == pytest.approx(9.0)
    closed = apply_edits(made, (edit(MERGE, (0.5, -0.5, 0.0)),))
    assert closed.names == made.names
    assert "goes round the body" in closed.target.notes[-1]


def test_the_last_two_panels_stay() -> None:
    body = apply_edits(whole(ball()), (plane((0.0, 0.0, 1.0)),))
    made = apply_edits(body, (edit(MERGE, (1.0, 0.0, 0.0)),))
    assert len(made.names) == 2
    assert "2 panels or more" in made.target.notes[-1]


def test_gores_merged_round_a_pole() -> None:
    """Three gores of eight, merged in turn, end at the same two poles."""
    body = divide(ball(), 8)
    chain = [
        "1",
        *sorted({body.names[p] for seam in body.seams if 0 in seam.panels for p in seam.panels} - {"1"}),
    ]
    made = body
    for name in chain[1:]:
        made = apply_edits(made, (edit(MERGE, panels=("1", name)),))
    check(body, made)
    assert areas(made)["1"] == pytest.approx(3.0 / 8.0, rel=0.03)
    assert len(made.nodes) == 2


def test_a_moved_seam_goes_through_the_place() -> None:
    body = cube()
    to = np.array([0.3, 0.0, 0.5])
    made = apply_edits(body, (edit(MOVE, (0.5, 0.0, 0.5), tuple(to), panels=("East", "Top")),))
    check(body, made)
    assert made.names == body.names
    points = made.target.points[seam_between(made, ("East", "Top")).vertices]
    assert np.linalg.norm(points - to, axis=1).min() < 0.01
    ends = {tuple(np.round(point, 6)) for point in points[[0, -1]]}
    assert ends == {(0.5, -0.5, 0.5), (0.5, 0.5, 0.5)}
    # the sine square over its length takes half of the greatest width
    assert areas(made)["Top"] == pytest.approx((1.0 - 0.2 * 0.5) / 6.0, rel=0.02)


@pytest.mark.parametrize(
    ("start", "to", "says"),
    [
        ((0.5, 0.0, 0.5), (-0.5, 0.0, -0.2), "is not on panels"),  # over its neighbour
        ((0.5, 0.0, 0.5), (0.0, 0.0, 3.0), "is not on panels"),
        ((0.5, 0.0, 0.5), (-0.4999, 0.0, 0.5), "so far"),  # onto the seam opposite
        ((0.0, 0.0, 0.5), (0.1, 0.0, 0.5), "no seam near"),
        ((0.5, 0.5, 0.5), (0.4, 0.4, 0.5), "between its ends"),
    ],
)
def test_moves_that_cannot_be_made_are_told(start: Place, to: Place, says: str) -> None:
    body = cube()
    made = apply_edits(body, (edit(MOVE, start, to),))
    assert areas(made) == pytest.approx(areas(body))
    assert says in made.target.notes[-1]


def test_an_edit_on_one_side_is_repeated_on_the_other() -> None:
    body = cube()
    cut = edit(CUT, (0.5, 0.3, 0.5), (0.2, 0.3, 0.5), (0.2, 0.5, 0.5), mirrored=True)
    made = apply_edits(body, (cut,))
    check(body, made)
    assert made.names[6:] == ("Topb", "Topc")
    assert areas(made)["Topb"] == pytest.approx(areas(made)["Topc"], rel=1e-6)
    alone = apply_edits(body, (edit(CUT, *map(tuple, cut.points)),))
    assert alone.names[6:] == ("Topb",)


def test_nothing_is_repeated_where_the_panels_are_no_mirror_images() -> None:
    # two faces made one: no plane has them as images but that through the middle of their seam
    body = apply_edits(cube(), (edit(MERGE, (0.5, 0.0, 0.5)), edit(MERGE, (0.5, 0.5, 0.0))))
    made = apply_edits(body, (edit(CUT, (-0.5, 0.2, 0.3), (-0.5, -0.2, 0.4), mirrored=True),))
    assert len(made.names) == len(body.names) + 1


def test_an_edit_for_other_panels_is_told_and_left_out() -> None:
    body = cube()
    made = apply_edits(
        body,
        (
            edit(MERGE, (0.5, 0.0, 0.5), panels=("Top", "West")),
            edit(CUT, (-0.5, 0.0, 0.5), (0.5, 0.0, 0.5), panels=("Bottom",)),
            edit(MERGE, panels=("Top", "Bottom")),
            edit(CUT, (-0.5, 0.0, 0.5), (0.5, 0.0, 0.5)),
        ),
    )
    assert made.names == (*body.names, "Topb")
    assert [note[:11] for note in made.target.notes] == [f"Seam edit {k}" for k in (1, 2, 3)]


def test_an_edit_grows_with_the_body() -> None:
    large = cube()
    large = Division(
        Target(3.0 * large.target.points, large.target.triangles), large.panels, large.names, NO_CUTS
    )
    cut = edit(CUT, (-0.5, 0.25, 0.5), (0.5, 0.25, 0.5), size=(1.0, 1.0, 1.0))
    assert areas(apply_edits(large, (cut,)))["Topb"] == pytest.approx(1.0 / 24.0)


def test_only_the_seams_that_are_drawn() -> None:
    """The net of a cube: seven of its edges are cut, and one panel of six squares is left."""
    body = whole(box())
    with pytest.raises(InputError, match="no seam"):
        apply_edits(body, ())
    with pytest.raises(InputError, match="misses the body"):
        apply_edits(body, (line((5.0, 0.0, 0.0), (5.0, 1.0, 0.0)),))
    a, b, c, d = ((x, y, 0.5) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)))
    e, f, g, h = ((x, y, -0.5) for x, y, _ in (a, b, c, d))
    made = apply_edits(body, (edit(CUT, e, a, b, f), edit(CUT, h, d, c, g), edit(CUT, b, c)))
    check(body, made)
    assert made.names == ("1",)
    assert seam_length(made) == pytest.approx(7.0)


def test_the_same_edits_give_the_same_bytes() -> None:
    body = cube()
    edits = (edit(CUT, (-0.4, 0.1, 0.5), (0.3, 0.3, 0.5)), plane((1.0, 1.0, 0.1)))
    one, other = apply_edits(body, edits), apply_edits(cube(), edits)
    assert one.target.points.tobytes() == other.target.points.tobytes()
    assert one.panels.tobytes() == other.panels.tobytes()


def test_no_direction_is_told() -> None:
    bad = SeamEdit(PLANE, np.zeros((1, 3)), no_direction())
    assert "normal" in apply_edits(cube(), (bad,)).target.notes[-1]
    bad = SeamEdit(LINE, np.eye(3), no_direction())
    assert "direction" in apply_edits(cube(), (bad,)).target.notes[-1]
