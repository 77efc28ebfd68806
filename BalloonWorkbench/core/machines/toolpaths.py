# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine gets of a pattern: lines in the order of the work, fitted, compensated, in millimetres."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.arcs.curves import Curve, polyline
from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.machines.contour.compensate import overrun, prolonged, trailing_knife, without_kerf
from BalloonWorkbench.core.machines.contour.start_point import begun_on_straight
from BalloonWorkbench.core.machines.contour.tabs import LEAST, gap_of, held, is_held, tab_places
from BalloonWorkbench.core.machines.lead_in import Waste
from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.order import CUTS, RANKS, in_order
from BalloonWorkbench.core.machines.tool import WELDS
from BalloonWorkbench.core.machines.travel import travel
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import MILLIMETRE, from_mm, to_mm

#: The bar by which a user sees that the size is right [mm], its ticks, and its distance from the pattern.
BAR = 100.0
_TICK = 4.0
_BESIDE = 8.0
BAR_ROOM = _BESIDE + 0.5 * _TICK
#: Room round the pattern for lead-ins and for the axis of a knife, where the file itself moves the tool [m].
_ROOM = from_mm(5.0)
#: The same to the edge of film, where pieces lie nearer to it [m].
_LEAST_ROOM = from_mm(1.0)
#: Lines of one role that are so close all along are one line [mm].
_SAME = 0.01


@dataclass(frozen=True)
class Path:
    """A curve on the sheet [mm], what is done along it, and in which turn through the layers, see Step."""

    role: Role
    curve: Curve
    turn: int = 0


@dataclass(frozen=True)
class Toolpaths:
    """Paths in the order of the work; lower left corner at the origin, and the size of it all [mm].

    Of a pattern that is printed on a page it is the page's corner, and its size.

    Of a machine that reads G-code it is the corner of the film that panels are laid out on, else of the
    pattern with some room, whatever tool it holds: what is welded and what is cut afterwards lie on each
    other.

    corner  where the origin is in the pattern [mm]
    """

    paths: tuple[Path, ...]
    width: float
    height: float
    corner: tuple[float, float] = (0.0, 0.0)

    @property
    def roles(self) -> tuple[Role, ...]:
        """The roles that occur, in the order of the work."""
        present = {path.role for path in self.paths}
        return tuple(role for role in Role if role in present)

    @property
    def by_layer(self) -> tuple[Path, ...]:
        """The paths with as few changes of the layer as the order of the work allows."""
        return tuple(sorted(self.paths, key=lambda path: (path.turn, RANKS[path.role])))

    @property
    def travel(self) -> float:
        """How far the tool goes between the paths, in their order [mm]."""
        begins, ends = np.array([_way(path.curve) for path in self.paths]).swapaxes(0, 1)
        return travel(begins, ends)

    def of(self, role: Role) -> tuple[Path, ...]:
        """The paths of one role."""
        return tuple(path for path in self.paths if path.role is role)


def draw(pattern: Pattern, machine: Machine) -> Toolpaths:
    """The drawing of a pattern for a machine; kerf and knife offset are made up for here.

    Raises ExportError when the pattern has none of the lines that the machine wants.
    """
    paths = _in_order(pattern, machine)
    if not paths:
        roles = ", ".join(role.value for role in machine.layers)
        raise ExportError(
            f"The pattern has no lines for {machine.title}, which takes {roles}: choose another machine."
        )
    if has_bar(pattern, machine):
        low = np.min([path.curve.bounds[0] for path in paths], axis=0)
        paths = [Path(Role.REGISTRATION, curve) for curve in _bar(low)] + paths
    if pattern.page is not None and machine.tool is None:
        low, high = to_mm(pattern.page[0]), to_mm(pattern.page[1])
    elif machine.tool is None:
        low = np.min([path.curve.bounds[0] for path in paths], axis=0)
        high = np.max([path.curve.bounds[1] for path in paths], axis=0)
    else:
        low, high = (to_mm(corner) for corner in reach(pattern, machine))
    width, height = (high - low).tolist()
    moved = tuple(replace(path, curve=path.curve.moved(-low)) for path in paths)
    return Toolpaths(moved, width, height, (float(low[0]), float(low[1])))


def _in_order(pattern: Pattern, machine: Machine) -> list[Path]:
    """What a machine does of a pattern, in the order of the work, still where it is."""
    contours, waste = pattern.contours, _waste(pattern, machine)
    ends = ends_on(pattern)
    curves: list[list[Curve]] = [[] for _ in contours]
    used = [number for number, contour in enumerate(contours) if contour.role in machine.layers]
    each = [(number, curve) for number in used for curve in _in_mm(contours[number], machine)]
    for number, curve in _once(each, contours):
        curves[number] += _worked(curve, contours[number], machine, ends, waste)
    # what lies on another line is nothing of its own; what is not for this machine has something in it
    kept = [number for number in range(len(contours)) if curves[number] or number not in used]
    ways = np.array(
        [
            _way(*curves[number]) if curves[number] else to_mm(contours[number].points[[0, 0]])
            for number in kept
        ]
    )
    steps = in_order([contours[number] for number in kept], ways.reshape(-1, 2, 2))
    return [
        Path(contours[kept[step.number]].role, curve, step.turn)
        for step in steps
        for curve in curves[kept[step.number]]
    ]


def has_bar(pattern: Pattern, machine: Machine) -> bool:
    """Whether a control bar is drawn beside the pattern; on a page its marks tell the size."""
    return machine.control_bar and Role.REGISTRATION in machine.layers and pattern.page is None


def reach(pattern: Pattern, machine: Machine) -> tuple[Floats, Floats]:
    """Lower left and upper right corner (2,) of what a machine's tool may come to [m]: some room past the
    pattern where the file itself moves it, but no farther than the film that panels are laid out on."""
    low, high = pattern.bounds
    if machine.tool is None:
        return low, high
    least = max(_LEAST_ROOM, 2.0 * machine.knife_offset + machine.kerf)  # a corner takes more than half of it
    room = max(_ROOM, machine.knife_offset + machine.kerf)
    if pattern.film is None:
        return low - room, high + room
    return np.minimum(low - least, 0.0), np.maximum(high + least, np.minimum(high + room, pattern.film))


def _waste(pattern: Pattern, machine: Machine) -> Waste | None:
    """Where a tool may land beside welds; None for one that lands on its lines, and without an outline."""
    if (
        machine.tool is None
        or not machine.tool.is_hot
        or machine.tool.lead_in == 0.0
        or not pattern.of(Role.CUT)
    ):
        return None
    low, high = (to_mm(corner) for corner in reach(pattern, machine))
    inward = to_mm(machine.knife_offset)
    return Waste(pattern, to_mm(machine.tool.lead_in), (low + inward, high - inward))


def fitted(contour: Contour, machine: Machine) -> Iterator[Curve]:
    """The curves [m] that a tool follows: several where the kerf parts a cut, none where it swallows it."""
    for points in without_kerf(contour, machine.kerf) if contour.role in CUTS else (contour.points,):
        straight = polyline(points, contour.closed)
        yield fit_curve(points, contour.closed, machine.tolerance) if machine.arcs else straight


def _in_mm(contour: Contour, machine: Machine) -> Iterator[Curve]:
    for curve in fitted(contour, machine):
        yield curve.moved(np.zeros(2), 1.0 / MILLIMETRE)


def ends_on(pattern: Pattern) -> Floats:
    """Where (n, 2) the open lines of a pattern end [mm]: notches, welds at a neck."""
    ends = [contour.points[[0, -1]] for contour in pattern.contours if not contour.closed]
    return to_mm(np.concatenate(ends)) if ends else np.empty((0, 2))


def not_held(pattern: Pattern, machine: Machine) -> list[Contour]:
    """The cuts that should have tabs, and have no room for two."""
    ends, gap = ends_on(pattern), gap_of(machine)
    return [
        contour
        for contour in pattern.contours
        if contour.role in machine.layers and is_held(contour, machine)
        if any(len(tab_places(curve, gap, ends)) < LEAST for curve in _in_mm(contour, machine))
    ]


def _worked(
    curve: Curve, contour: Contour, machine: Machine, ends: Floats, waste: Waste | None
) -> Iterator[Curve]:
    """A curve [mm] as a machine goes along it, in pieces between tabs; ends (n, 2) mm of the open lines."""
    if curve.closed:
        curve = begun_on_straight(curve, ends)
    if contour.role in WELDS:
        yield _weld(curve, machine, waste)
    elif contour.role.is_cut:
        for piece in held(curve, gap_of(machine), ends) if is_held(contour, machine) else [curve]:
            whole = overrun(piece, to_mm(machine.overcut)) if piece.closed else piece
            yield trailing_knife(whole, to_mm(machine.knife_offset))
    else:
        yield curve


def _weld(curve: Curve, machine: Machine, waste: Waste | None) -> Curve:
    """A weld [mm] with what it runs past its start and with the ways of a hot tool between it and waste film;
    a wheel that swivels goes ahead of it."""
    if machine.tool is None:
        return overrun(curve, to_mm(machine.overrun)) if curve.closed else curve
    before = after = None
    if curve.closed:
        if waste is not None:
            curve, before = waste.begun(curve)
        curve = overrun(curve, to_mm(machine.overrun))
    elif waste is not None:
        before, after = waste.ways(curve)
    return trailing_knife(prolonged(curve, before, after), to_mm(machine.knife_offset))


def _way(*curves: Curve) -> Floats:
    """Where (2, 2) mm the tool comes to curves and leaves them."""
    return np.stack([curves[0].joints[0], curves[-1].joints[0 if curves[-1].closed else -1]])


def _once(curves: list[tuple[int, Curve]], contours: Sequence[Contour]) -> list[tuple[int, Curve]]:
    """Curves by the numbers of their contours, without those that lie on an earlier one of the same role."""
    boxes = np.array([np.concatenate(curve.bounds) for _, curve in curves])
    distinct: list[int] = []
    for number, (owner, curve) in enumerate(curves):
        near = np.abs(boxes[distinct] - boxes[number]).max(axis=1) < _SAME if distinct else np.zeros(0)
        alike = [curves[distinct[k]] for k in np.flatnonzero(near)]
        role = contours[owner].role
        lines = [ring(other.flattened(_SAME)) for earlier, other in alike if contours[earlier].role is role]
        points = curve.flattened(_SAME) if lines else curve.joints
        if not any(nearest_on_line(line, points).distance.max() < 2.0 * _SAME for line in lines):
            distinct.append(number)
    return [curves[number] for number in distinct]


def _bar(low: Floats) -> Iterator[Curve]:
    """The control bar below the lower left corner of everything [mm]."""
    left, y = low + np.array([0.0, -_BESIDE])
    for a, b in (
        ((left, y), (left + BAR, y)),
        ((left, y - 0.5 * _TICK), (left, y + 0.5 * _TICK)),
        ((left + BAR, y - 0.5 * _TICK), (left + BAR, y + 0.5 * _TICK)),
    ):
        yield polyline(np.array([a, b]), False)


def in_unit(drawing: Toolpaths, unit: float) -> Toolpaths:
    """The drawing with its numbers in another unit [m]: coordinates and sizes are really scaled."""
    scale = from_mm(1.0) / unit
    paths = tuple(replace(path, curve=path.curve.moved(np.zeros(2), scale)) for path in drawing.paths)
    return Toolpaths(paths, drawing.width * scale, drawing.height * scale)
