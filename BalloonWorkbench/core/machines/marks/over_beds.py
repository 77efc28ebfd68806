# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing that is larger than the bed, in several files: the film is cut in part, moved, and cut on.

The bed is laid over the drawing in even steps. Where a bed overlaps those before it, two crosses are drawn or
cut in film that is waste; the file of the next bed has the same, and they tell how the moved film has to lie.
Amid the overlap the lines change from one file to the other, each a hair longer, so that nothing hangs. A
cross that is found is larger than it was made: once it was used, nobody takes it for another one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from BalloonWorkbench.core.arcs.curves import polyline
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.machines.bed import fits_upright
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.toolpaths import Path, Toolpaths, draw, reach
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm, length_text, to_mm

#: All in mm: half of a cross that is made, and of one that is found; room round it to film that is used, and
#: to the edge of the bed.
_MADE, _TARGET, _CLEAR = 5.0, 7.0, 2.0
#: Film beyond the drawing for crosses, and how far two beds overlap at least.
_ROOM, _OVERLAP = 19.0, 30.0
#: How far apart two crosses must be, so that the film is not turned when they lie on each other.
_LEAST_APART = 40.0
#: Lines go on so far into the neighbour's part. How far a polyline may be off an arc.
_HAIR, _CHORD, _DUST = 0.3, 0.005, 1e-6
#: More files than that are a mistake.
_MOST = 100


@dataclass(frozen=True, eq=False)
class _Bed:
    """One place of the bed in the drawing, and the part that is done there: boxes (2, 2) mm."""

    window: Floats
    part: Floats


#: Where it is (2,) mm, and half its size.
_Cross = tuple[Floats, float]


def over_beds(pattern: Pattern, machine: Machine) -> list[Toolpaths]:
    """The drawings of a pattern for the places of the bed, in the order in which they are cut.

    A single one where the pattern fits. Raises ExportError where there is no waste film for crosses, and for
    what cannot be moved on the bed.
    """
    if machine.bed is None or fits_upright(pattern, machine):
        return [draw(pattern, machine)]
    _hold_possible(pattern, machine)
    drawing = draw(pattern, replace(machine, control_bar=False))
    lines = [(path, path.curve.flattened(_CHORD)) for path in drawing.paths]
    done = {bed: _parts(lines, bed) for bed in _beds(drawing, to_mm(np.array(machine.bed)))}
    beds = [bed for bed, paths in done.items() if paths]
    low = to_mm(reach(pattern, machine)[0]) if machine.tool else _corner(pattern, machine)
    package = shapely()
    film = package.union_all([package.Polygon(to_mm(cut.points) - low) for cut in pattern.of(Role.CUT)])
    order, crosses = _laid_on(beds, film.buffer(_TARGET + _CLEAR), machine)
    return [_file(done[bed], bed, own) for bed, own in zip(order, crosses, strict=True)]


def _hold_possible(pattern: Pattern, machine: Machine) -> None:
    if pattern.of(Role.PRINT):
        raise ExportError(
            f"A print is not cut in parts: choose a machine with a larger bed than {machine.title}, or make"
            " the balloon smaller."
        )
    if Role.REGISTRATION not in machine.layers or (machine.tool and machine.tool.is_hot):
        raise ExportError(
            f"{machine.title} cannot make crosses in the film to lay it on anew (layer REGISTRATION): choose"
            " another machine, or make the balloon smaller."
        )


def _corner(pattern: Pattern, machine: Machine) -> Floats:
    """Where the drawing's lower left corner is in the pattern [mm]: that of its lines for this machine."""
    taken = [to_mm(contour.points) for contour in pattern.contours if contour.role in machine.layers]
    return np.concatenate(taken).min(axis=0)


def _beds(drawing: Toolpaths, bed: Floats) -> Iterator[_Bed]:
    """The places of a bed (2,) mm, row by row from below."""
    size = np.array([drawing.width, drawing.height]) + 2.0 * _ROOM
    ways = []
    for length, side in zip(size.tolist(), bed.tolist()):
        if length - 2.0 * _ROOM <= side:  # what room there is, and no bed more
            lows = np.array([max(-_ROOM, 0.5 * (length - side) - _ROOM)])
        else:
            lows = -_ROOM + np.linspace(0.0, length - side, _count(length, side))
        highs = lows + min(side, length)
        between = 0.5 * (lows[1:] + highs[:-1])
        ways.append((lows, highs, np.append(-np.inf, between), np.append(between, np.inf)))
    across, up = (np.stack(way, axis=-1).reshape(-1, 2, 2) for way in ways)  # of each bed: window, part
    for (window_y, part_y), (window_x, part_x) in product(up, across):
        yield _Bed(np.column_stack([window_x, window_y]), np.column_stack([part_x, part_y]))


def _count(length: float, side: float) -> int:
    """How many beds so long a way needs [mm]. ExportError for far too many."""
    if side < 2.0 * _OVERLAP or (length - _OVERLAP) / (side - _OVERLAP) > _MOST:
        raise ExportError(
            f"A bed of {length_text(from_mm(side))} is too small to lay so much film on anew: give a larger"
            " one, or make the balloon smaller."
        )
    return int(np.ceil((length - _OVERLAP) / (side - _OVERLAP)))


def _parts(lines: list[tuple[Path, Floats]], bed: _Bed) -> list[Path]:
    """What of a drawing's paths, with their points (n, 2) mm, is done at a place of the bed, where it is."""
    package = shapely()
    box = np.array([bed.part[0] - _HAIR, bed.part[1] + _HAIR])
    area = package.box(*np.clip(box, bed.window[0], bed.window[1]).ravel())
    done: list[Path] = []
    for path, points in lines:
        inside = package.intersects_xy(area, *points.T)
        if inside.all():
            done.append(path)
            continue
        first = int(np.argmin(inside)) if path.curve.closed else 0  # from outside: whole pieces
        line = package.LineString(ring(np.roll(points, -first, axis=0), path.curve.closed))
        pieces = package.get_parts(line.intersection(area))
        done += [
            replace(path, curve=polyline(package.get_coordinates(piece), False))
            for piece in pieces
            if piece.geom_type == "LineString" and piece.length > _DUST
        ]
    return done


def _laid_on(beds: list[_Bed], used: Any, machine: Machine) -> tuple[list[_Bed], list[list[_Cross]]]:
    """The order of the places, and the crosses of each: those by which it is laid on, and those for others.

    Next is always the place whose two crosses are farthest apart.
    """
    package = shapely()
    order, left = [beds[0]], list(range(1, len(beds)))
    crosses: list[list[_Cross]] = [[]]
    while left:
        taken = [package.Point(at).buffer(2.5 * _TARGET) for own in crosses for at, _ in own]
        waste = package.union_all([_free(bed) for bed in order]).difference(package.union_all([used, *taken]))
        chosen = max(((_farthest(beds[k], waste), k) for k in left), key=lambda each: each[0][0])
        (apart, pair), number = chosen
        if apart < _LEAST_APART:
            raise ExportError(
                f"Split over beds of {machine.title}, the pattern leaves no waste film for two crosses"
                f" {length_text(from_mm(_LEAST_APART))} apart by which it is laid on anew: choose a larger"
                " bed, or lay the pieces out on sheets."
            )
        for at in pair:
            before = next(k for k, bed in enumerate(order) if _free(bed).distance(package.Point(at)) < _HAIR)
            crosses[before].append((at, _MADE))
        order.append(beds[number])
        crosses.append([(at, _TARGET) for at in pair])
        left.remove(number)
    return order, crosses


def _free(bed: _Bed) -> Any:
    """Where crosses may be on a bed, as an area of shapely."""
    edge = _TARGET + _CLEAR
    return shapely().box(*(bed.window[0] + edge), *(bed.window[1] - edge))


def _farthest(bed: _Bed, waste: Any) -> tuple[float, tuple[Floats, ...]]:
    """The two corners of the waste film on a bed that are farthest apart, and how far that is."""
    corners = shapely().get_coordinates(waste.intersection(_free(bed)).convex_hull)
    corners = np.unique(np.round(corners, 3), axis=0)
    if len(corners) < 2:
        return 0.0, ()
    apart = np.linalg.norm(corners[:, None] - corners[None], axis=2)
    first, second = np.unravel_index(int(apart.argmax()), apart.shape)
    return float(apart[first, second]), (corners[first], corners[second])


def _file(own: list[Path], bed: _Bed, crosses: list[_Cross]) -> Toolpaths:
    """The drawing at one place of the bed: crosses, then its own part of the lines."""
    marks = [
        Path(Role.REGISTRATION, polyline(np.array([at - arm, at + arm]), False))
        for at, size in crosses
        for arm in ((size, 0.0), (0.0, size))
    ]
    done, low = (*marks, *own), -bed.window[0]
    paths = [replace(path, curve=path.curve.moved(low)) for path in done]
    width, height = (bed.window[1] - bed.window[0]).tolist()
    return Toolpaths(tuple(paths), width, height)
