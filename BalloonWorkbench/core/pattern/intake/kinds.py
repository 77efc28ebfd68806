# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of intakes we know: one file each in resources/intakes.

Lines are drawn beside an axis: along it from the neck's root on the seam outward, or from the middle of a
nozzle, then across it. Each number is a sum such as "L - 10" or "0.5 W + S": L length, W inner width, S seal
width, A allowance, plain numbers millimetres. Pieces beside the panel know no A.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, read_data, reason_of
from BalloonWorkbench.core.geometry.vectors import direction, rotation
from BalloonWorkbench.core.options.pattern import STRAW
from BalloonWorkbench.core.pattern.pattern import Contour, Role
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import from_mm

FOLDER = RESOURCES / "intakes"
#: Where an intake sits: a neck through the weld, or a fitting on the front film.
RIM, FILM = "rim", "film"
#: A length that the pattern chooses so that the neck is free.
AUTO = "auto"
_TERM = re.compile(r"([+-]?)\s*(\d*\.?\d+)?\s*([LWSA]?)\s*")
_STEPS = 72  # points of a circle


@dataclass(frozen=True)
class Stroke:
    """A line of an intake: role, points or the middle of a circle as sums, radius of a circle as a sum."""

    role: Role
    points: tuple[tuple[str, str], ...]
    closed: bool
    radius: str | None = None

    def drawn(self, sizes: Mapping[str, float]) -> Contour:
        """The line beside its axis for sizes L, W, S, A [m]; counter-clockwise only if it is an outer cut."""
        points = np.array([[measure(text, sizes) for text in point] for point in self.points])
        if self.radius is not None:
            points = points + measure(self.radius, sizes) * direction(
                np.arange(_STEPS) * 2.0 * np.pi / _STEPS
            )
            if self.role is not Role.CUT:
                points = points[::-1]
        return Contour(self.role, points, self.closed)


@dataclass(frozen=True)
class IntakePiece:
    """A piece of film of its own, once for each balloon: label and the sums of its middle, its lines with the
    cut last. In a neck its axis runs inward from the mouth.
    """

    label: str
    label_at: tuple[str, str]
    strokes: tuple[Stroke, ...]


@dataclass(frozen=True)
class PieceStock:
    """The film of an intake's pieces where it is not the balloon's: name in files, what people read, and the
    polymer that it is welded with, as `Film.sealing_side`.
    """

    name: str
    title: str
    sealing_side: str


@dataclass(frozen=True)
class IntakeKind:
    """A kind of intake.

    note    a sentence on how to use it
    place   RIM or FILM
    width   usual inner width, or bore [m]; length: the usual one as a sum, or AUTO
    taper   width at the mouth of a neck as a share of that at its root
    stock   the film of its pieces; None for the balloon's
    """

    name: str
    title: str
    note: str
    place: str
    width: float
    length: str
    taper: float
    strokes: tuple[Stroke, ...]
    pieces: tuple[IntakePiece, ...]
    stock: PieceStock | None = None

    def default_length(self, sizes: Mapping[str, float]) -> float | None:
        """The length [m] for sizes W, S, A [m]; None where the pattern has to find it."""
        return None if self.length == AUTO else measure(self.length, sizes)


def measure(text: str, sizes: Mapping[str, float]) -> float:
    """The value [m] of a sum such as "0.5 W - 3" with sizes by letter [m]. InputError for anything else."""
    at, total = 0, 0.0
    rest = text.strip()
    while at < len(rest):
        term = _TERM.match(rest, at)
        if term is None or not (term[2] or term[3]) or (at and not term[1]):
            raise InputError(f'"{text}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".')
        if term[3] and term[3] not in sizes:
            raise InputError(f'"{text}" may not use {term[3]}.')
        value = float(term[2] or 1.0) * (sizes[term[3]] if term[3] else from_mm(1.0))
        total += -value if term[1] == "-" else value
        at = term.end()
    if not rest:
        raise InputError("A number of an intake is empty.")
    return total


@cache
def intake_kinds() -> dict[str, IntakeKind]:
    """All kinds by name, the straw neck first. InputError when a data file is of no use."""
    kinds = [read_kind(path) for path in sorted(FOLDER.glob("*.json"))]
    return {kind.name: kind for kind in sorted(kinds, key=lambda kind: (kind.name != STRAW, kind.name))}


def intake_kind(name: str) -> IntakeKind:
    """The kind of this name. InputError with the known names when there is none."""
    kinds = intake_kinds()
    if name not in kinds:
        raise InputError(f'There is no intake "{name}": choose one of {", ".join(kinds)}.')
    return kinds[name]


def read_kind(path: Path) -> IntakeKind:
    """The kind that a data file describes, checked. InputError that names the file."""
    try:
        data = read_data(path)
        kind = _kind_of(data)
    except KeyError as error:
        raise InputError(f"The intake file {path.name} lacks {error}: add it.") from error
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"The intake file {path.name} is of no use: {reason_of(error)}") from error
    if kind.name != path.stem:
        raise InputError(f'The intake file {path.name} calls itself "{kind.name}": give both the same name.')
    return kind


def _kind_of(data: dict[str, Any]) -> IntakeKind:
    sizes = dict.fromkeys("WSA", 1.0)
    kind = IntakeKind(
        str(data["name"]),
        str(data["title"]),
        str(data["note"]),
        str(data["place"]),
        from_mm(float(data["width_mm"])),
        str(data["length"]),
        float(data["taper"]),
        _strokes(data["lines"]),
        tuple(
            IntakePiece(
                str(piece["label"]),
                _point(piece["label_at"]),
                _strokes(piece["lines"]),
            )
            for piece in data["pieces"]
        ),
        _stock(data["stock"]) if "stock" in data else None,
    )
    if kind.place not in (RIM, FILM):
        raise InputError(f'place "{kind.place}" is neither {RIM} nor {FILM}.')
    if not (kind.width > 0.0 and 0.2 <= kind.taper <= 1.0):
        raise InputError("width_mm must be above 0, and taper from 0.2 to 1.")
    kind.default_length(sizes)
    if any(piece.strokes[-1].role is not Role.CUT for piece in kind.pieces):
        raise InputError("the last line of each piece is its CUT.")
    return kind


def _stock(data: dict[str, Any]) -> PieceStock:
    stock = PieceStock(str(data["name"]), str(data["title"]), str(data["sealing_side"]))
    if not re.fullmatch("[a-z-]{1,20}", stock.name):
        raise InputError(f'the name "{stock.name}" of the stock goes into file names: take letters a to z.')
    return stock


def _strokes(data: Sequence[dict[str, Any]]) -> tuple[Stroke, ...]:
    strokes = []
    for line in data:
        circle = "circle" in line
        points = [line["circle"]] if circle else line["points"]
        stroke = Stroke(
            Role(line["role"]),
            tuple(map(_point, points)),
            circle or bool(line.get("closed", False)),
            str(line["radius"]) if circle else None,
        )
        stroke.drawn(dict.fromkeys("LWSA", 1.0))
        strokes.append(stroke)
    return tuple(strokes)


def _point(data: Sequence[str]) -> tuple[str, str]:
    along, across = map(str, data)
    for text in (along, across):
        measure(text, dict.fromkeys("LWSA", 1.0))
    return along, across


def placed(contour: Contour, at: Floats, angle: float) -> Contour:
    """A line beside its axis, brought to where the axis begins (2,) and points [rad]."""
    return replace(contour, points=contour.points @ rotation(angle) + at)
