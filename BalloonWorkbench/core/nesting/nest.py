# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laying out panels: by the nesting library spyrrow, else one piece after another, which is better for few.

spyrrow (sparrow: Gardeyn, Vanden Berghe, Wauters 2025, strip packing by guided local search) looks for the
shortest strip. With one thread and a fixed seed the way it goes is always the same, so the result is too
whenever it is left to end by itself; stopped earlier, it gives the best that it has.
"""

from __future__ import annotations

import _thread
import importlib.util
import signal
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import Cancelled, InputError, SolverError
from BalloonWorkbench.core.nesting.fill import in_shape
from BalloonWorkbench.core.nesting.holes import into_holes, with_guests
from BalloonWorkbench.core.nesting.layout import (
    Layout,
    Piece,
    Place,
    Stock,
    Unit,
    check,
    check_count,
    layout_of,
    of_remnant,
    outline_of,
)
from BalloonWorkbench.core.nesting.remnant import Remnant
from BalloonWorkbench.core.nesting.rows import in_rows
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.units import from_mm, length_text, to_mm

PACKAGE = "spyrrow"
ROWS_NOTE = (
    "Laid one piece after another: the package spyrrow (pip install spyrrow) often finds a closer layout."
)
#: Outlines are grown by that, then simplified within it: they enclose their pieces [m].
_SLACK = from_mm(0.15)
_SEED = 1
_LIMIT = 120  # s, an end to the search should it never come to one
_USUAL = 20.0  # s
#: A strip that the pieces would fill to less than that is laid in rows [m].
_LEAST_DEPTH = from_mm(5.0)
#: So much longer may film be that is filled in another way, at first.
_LONGER = 1.1
_LOOK = 0.05  # s
#: A signal that nobody else uses; none is ever sent from outside.
_SIGNAL = getattr(signal, "SIGUSR1", None) or signal.SIGTERM


def nest(
    pieces: Sequence[Piece],
    stock: Stock,
    progress: Progress = no_progress,
    remnants: Sequence[Remnant] = (),
    only_remnants: bool = False,
) -> tuple[tuple[Layout, ...], tuple[str, ...]]:
    """Layouts of all pieces: one for each remnant that is used, one for each sheet or one for a roll; and
    remarks for the user.

    What fits into the hole of another piece lies there. The stock is for what finds no room on remnants.

    When progress says stop, the best layout so far is taken. Raises InputError for what cannot be laid out,
    and where only remnants are to be used and have no room; Cancelled when it is stopped before there is any
    layout.
    """
    check_count(pieces)
    units, on_remnants = _units(pieces), list[Layout]()
    for remnant in remnants:
        film = of_remnant(remnant, stock)
        places, units = in_shape(pieces, film, units, progress)
        on_remnants += [layout_of(film, pieces, places)] if places else []
    if units and only_remnants:
        raise InputError(
            f"For {len(units)} of {len(_units(pieces))} pieces there is no room on the remnant: give film for"
            " the rest too."
        )
    if on_remnants and not units:
        return tuple(on_remnants), ()
    check([pieces[number] for number in sorted({number for number, _ in units})], stock)
    layouts, remarks = _on_film(pieces, stock, units, progress)
    return (*on_remnants, *layouts), remarks


def _on_film(
    pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit], progress: Progress
) -> tuple[tuple[Layout, ...], tuple[str, ...]]:
    """The same of some pieces on a roll or on sheets."""
    units, guests = into_holes(pieces, stock, units)
    if importlib.util.find_spec(PACKAGE) is None:
        rows = [layout_of(stock, pieces, places) for places in in_rows(pieces, stock, units)]
        laid = rows if stock.length is not None else [_closer(pieces, rows[0], units, progress)]
        return tuple(layout_of(stock, pieces, with_guests(layout.places, guests)) for layout in laid), (
            ROWS_NOTE,
        )
    if stock.length is None:
        places, length = _strip(pieces, stock, units, None, progress)
        (row,) = in_rows(pieces, stock, units)
        if layout_of(stock, pieces, row).length < length:  # few pieces, or a search that was stopped early
            places = row
        return (layout_of(stock, pieces, with_guests(places, guests)),), ()
    layouts = _sheets(pieces, stock, units, progress)
    return tuple(layout_of(stock, pieces, with_guests(layout.places, guests)) for layout in layouts), ()


def _closer(pieces: Sequence[Piece], row: Layout, units: Sequence[Unit], progress: Progress) -> Layout:
    """Pieces on a roll as they fill a shape of about that length, where that takes less film than rows."""
    stock = row.stock
    strip = Remnant(shapely().box(0.0, 0.0, _LONGER * row.length, stock.width))
    places, left = in_shape(pieces, of_remnant(strip, stock), units, progress)
    filled = row if left else layout_of(stock, pieces, places)
    return filled if filled.length < row.length else row


def _units(pieces: Sequence[Piece]) -> list[Unit]:
    """All pieces, front and back of a balloon after one another."""
    units: list[Unit] = []
    for number, piece in enumerate(pieces):
        for k in range(max(piece.count, piece.backs)):
            units += [(number, False)] * (k < piece.count) + [(number, True)] * (k < piece.backs)
    return units


def _sheets(pieces: Sequence[Piece], stock: Stock, units: list[Unit], progress: Progress) -> list[Layout]:
    """Sheets filled one after the other; the same set of pieces is laid out once."""
    assert stock.length is not None
    room = (stock.length - 2.0 * stock.spacing) * stock.room
    layouts: list[Layout] = []
    known: dict[tuple[Unit, ...], Layout] = {}
    while units:
        areas = np.cumsum([pieces[number].pattern.film_area for number, _ in units])
        take = max(1, int(np.searchsorted(areas, room, side="right")))
        while True:
            chosen = units[:take]
            layout = known.get(tuple(sorted(chosen)))
            if layout is None:
                places, width = _strip(pieces, stock, chosen, stock.length, progress)
                if width <= stock.length + 1e-9:
                    layout = layout_of(stock, pieces, places)
                    known[tuple(sorted(chosen))] = layout
            if layout is not None:
                break
            if take == 1:
                raise InputError("A piece does not fit on the sheet: take a larger one.")
            take = max(1, min(take - 1, int(take * stock.length / width)))
        layouts.append(layout)
        units = units[take:]
    return layouts


def _strip(
    pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit], enough: float | None, progress: Progress
) -> tuple[list[Place], float]:
    """Places of pieces on a strip and its length [m]; a strip of the length `enough` ends the search."""
    import spyrrow

    kinds = sorted(set(units))
    items = []
    for number, mirrored in kinds:
        area = outline_of(pieces[number].panel(mirrored))
        shape = area.buffer(_SLACK, join_style="mitre").simplify(_SLACK)
        points = [tuple(point) for point in to_mm(np.asarray(shape.exterior.coords)[:-1]).tolist()]
        count = list(units).count((number, mirrored))
        angles = pieces[number].angles(mirrored, stock.grain)
        items.append(spyrrow.Item(f"{number} {int(mirrored)}", points, count, angles))
    # outlines lie up to two slacks outside the pieces, so a piece may fill the room to the last
    edge = max(stock.spacing - 2.0 * _SLACK, 0.0)
    # no higher than all pieces on top of each other: a strip that is all width is none to the library
    stacked = sum(max(pieces[number].pattern.size) + 2.0 * stock.spacing for number, _ in units)
    height = min(stock.width - 2.0 * edge, stacked)
    if _area_of(pieces, units) / height < _LEAST_DEPTH + 4.0 * stock.spacing:
        return _one_row(pieces, stock, units)
    instance = spyrrow.StripPackingInstance("", to_mm(height), items)
    config = spyrrow.StripPackingConfig(
        early_termination=True,
        total_computation_time=None,
        exploration_time=_LIMIT,
        compression_time=0,
        num_workers=1,
        seed=_SEED,
        min_items_separation=to_mm(stock.spacing) or None,
    )
    goal = None if enough is None else to_mm(enough - 2.0 * edge)
    solution = _search(spyrrow, instance, config, goal, progress)
    origin = np.array([edge, edge])
    places = []
    for placed in solution.placed_items:
        number, side = placed.id.split()
        angle = float(np.radians(placed.rotation))
        places.append(Place(int(number), side == "1", angle, from_mm(np.array(placed.translation)) + origin))
    return places, from_mm(solution.width) + 2.0 * edge


def _area_of(pieces: Sequence[Piece], units: Sequence[Unit]) -> float:
    """Film in pieces [m2]."""
    return sum(pieces[number].pattern.film_area for number, _ in units)


def _one_row(pieces: Sequence[Piece], stock: Stock, units: Sequence[Unit]) -> tuple[list[Place], float]:
    """Few small pieces on wide film: rows are as good."""
    (places,) = in_rows(pieces, replace(stock, length=None), units)
    return places, layout_of(replace(stock, length=None), pieces, places).length


class _Enough(Exception):
    """Ends a search from within."""


def _search(package: Any, instance: Any, config: Any, goal: float | None, progress: Progress) -> Any:
    """The best solution when the search ends, reaches the goal [mm] or is stopped.

    The search looks for signals now and then, but only in the main thread. Elsewhere it runs in a thread of
    its own, which ends by itself some time after it was stopped.
    """
    queue, began = package.ProgressQueue(), time.monotonic()
    usable = (package.ReportType.ExplFeas, package.ReportType.CmprFeas, package.ReportType.Final)
    best: list[Any] = []

    def look() -> None:
        for kind, solution in queue.drain():
            if kind in usable and (not best or solution.width < best[-1].width):
                best.append(solution)
        reached = goal is not None and best and best[-1].width <= goal
        share = 1.0 - _USUAL / (_USUAL + time.monotonic() - began)
        status = f"laying out, {length_text(from_mm(best[-1].width))} so far" if best else "laying out"
        if reached or not progress(share, status):
            raise _Enough

    here = threading.current_thread() is threading.main_thread()
    try:
        return (_in_main_thread if here else _beside)(instance, config, queue, look)
    except _Enough:
        if not best:
            raise Cancelled("The layout was stopped; nothing was changed.") from None
        return best[-1]


def _in_main_thread(instance: Any, config: Any, queue: Any, look: Callable[[], None]) -> Any:
    """The search in the main thread."""
    done = threading.Event()

    def on_tick(*_: object) -> None:
        if done.is_set():  # the last tick, after the end
            return
        try:
            look()
        except _Enough:
            done.set()
            raise

    former = signal.signal(_SIGNAL, on_tick)
    timer = threading.Thread(target=_tick, args=(done,), name="nesting", daemon=True)
    timer.start()
    try:
        return _solved(instance, config, queue)
    finally:
        done.set()
        timer.join()
        signal.signal(_SIGNAL, former or signal.SIG_DFL)


def _beside(instance: Any, config: Any, queue: Any, look: Callable[[], None]) -> Any:
    """The search in a thread beside this one."""
    ended: list[Any] = []
    failed: list[BaseException] = []

    def search() -> None:
        try:
            ended.append(_solved(instance, config, queue))
        except BaseException as error:  # noqa: BLE001 - a thread's end is told by the one that began it
            failed.append(error)

    worker = threading.Thread(target=search, name="nesting")
    worker.start()
    while worker.is_alive():
        worker.join(_LOOK)
        look()
    if failed:
        raise failed[0]
    return ended[0]


def _solved(instance: Any, config: Any, queue: Any) -> Any:
    """What the search finds. Raises SolverError where it panics, as it does for want of room."""
    try:
        return instance.solve(config, queue)
    except (Exception, KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:
        raise SolverError("The layout failed: give the pieces more room.") from error


def _tick(done: threading.Event) -> None:
    while not done.wait(_LOOK):
        _thread.interrupt_main(_SIGNAL)
