# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ready bodies as bags, by a few lengths: boxes, a tetrahedron, a cylinder, a cone, a pouch, a beach ball."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.gores import FEWEST, MOST, gored_bag
from BalloonWorkbench.core.bodies.joined import NamedSide, joined_bag, moved, polygon, rectangle
from BalloonWorkbench.core.bodies.profile import DISC, Profile
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.vectors import direction
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text

#: Points on the rim of a whole disc, and along the meridian of a ball from pole to pole.
_RIM, _MERIDIAN = 240, 120
#: The shortest and the longest length of a body [m].
_SHORTEST, _LONGEST = 1e-3, 100.0


@dataclass(frozen=True)
class BodySize:
    """A number that a ready body needs: a length [m], or how many there are of something.

    name   as ready_bag takes it
    label  for people
    """

    name: str
    label: str
    default: float
    is_count: bool = False


@dataclass(frozen=True)
class ReadyBody:
    """A body by name: its numbers, and how it becomes a bag."""

    label: str
    sizes: tuple[BodySize, ...]
    make: Callable[..., Bag]


def ready_bag(name: str, **sizes: float) -> Bag:
    """The bag of a ready body; lengths in metres, those left out as usual. Raises InputError."""
    if name not in READY:
        raise InputError(f"There is no ready body '{name}'. Choose one of {', '.join(READY)}.")
    known = {size.name: size for size in READY[name].sizes}
    values = {size.name: size.default for size in known.values()}
    for key, value in sizes.items():
        if key not in known:
            raise InputError(f"The body '{name}' has no '{key}'. It has {', '.join(known)}.")
        low, high = (FEWEST, MOST) if known[key].is_count else (_SHORTEST, _LONGEST)
        if not low <= value <= high:
            limits = (
                f"{low} to {high}" if known[key].is_count else f"{length_text(low)} to {length_text(high)}"
            )
            raise InputError(f"The '{key}' of the body '{name}' is out of range. Choose {limits}.")
        values[key] = int(value) if known[key].is_count else float(value)
    return READY[name].make(**values)


def _box(length: float, width: float, height: float) -> Bag:
    """Length along x, width along y, height along z; opened at the front edge of its top."""
    return joined_bag(
        [
            (
                "bottom",
                rectangle(length, width, ("bottom back", "bottom right", "bottom front", "bottom left")),
            ),
            ("top", rectangle(length, width, ("top front", "top right", "top back", "top left"))),
            ("front", rectangle(length, height, ("bottom front", "front right", "top front", "front left"))),
            ("back", rectangle(length, height, ("bottom back", "back left", "top back", "back right"))),
            ("left", rectangle(width, height, ("bottom left", "front left", "top left", "back left"))),
            ("right", rectangle(width, height, ("bottom right", "back right", "top right", "front right"))),
        ],
        "top front",
    )


def _pillow_box(length: float, width: float, depth: float) -> Bag:
    """Front and back with hollow ends, and at both ends a flap between two arcs, so deep in all."""
    if depth > width:
        raise InputError("A pillow box cannot be deeper than wide. Choose a smaller depth.")
    arc = _arc(width, 0.5 * depth)

    across = moved(arc * (1.0, -1.0), width, length)  # from right to left, bent into the face
    below = moved(_reversed(arc, np.array([-width, 0.0])), width, 0.0)
    right, left = np.array([[width, 0.0]]), np.array([[0.0, length]])

    def face(upper: str, lower: str, sides: tuple[str, str]) -> list[NamedSide]:
        return [(lower, below), (sides[0], right), (upper, across), (sides[1], left)]

    def flap(one: str, other: str) -> list[NamedSide]:
        return [(one, -arc), (other, moved(arc, width, 0.0))]

    return joined_bag(
        [
            ("front", face("front top", "front bottom", ("right", "left"))),
            ("back", face("back top", "back bottom", ("left", "right"))),
            ("top", flap("front top", "back top")),
            ("bottom", flap("front bottom", "back bottom")),
        ],
        "right",
    )


def _arc(chord: float, height: float) -> Floats:
    """From (0, 0) to (-chord, 0), bulging to +y by a height [m], without the last point: (k, 2)."""
    half = 2.0 * np.arctan(2.0 * height / chord)  # half of the angle that the arc spans
    count = max(2, int(np.ceil(_RIM * half / np.pi)))
    angles = half - 2.0 * half * np.arange(count) / count
    radius = 0.5 * chord / np.sin(half)
    return radius * np.column_stack([np.sin(angles) - np.sin(half), np.cos(angles) - np.cos(half)])


def _reversed(line: Floats, end: Floats) -> Floats:
    """A side without its last point, run through from its end: again without its last point."""
    return np.concatenate([end[None], line[:0:-1]])


def _tetrahedron(edge: float) -> Bag:
    """Four equal triangles."""
    corners = edge * np.array([(0.0, 0.0), (1.0, 0.0), (0.5, np.sqrt(0.75))])
    faces = ("01 12 02", "03 13 01", "13 23 12", "23 03 02")
    panels = [(f"side {k}", polygon(corners, names.split())) for k, names in enumerate(faces, start=1)]
    return joined_bag(panels, "01")


def _cylinder(radius: float, height: float) -> Bag:
    """Two discs and the band round them, sealed to itself; the discs have points where the band has them."""
    half = _RIM // 2
    disc = _disc(radius)
    around = _RIM * 2.0 * radius * np.sin(np.pi / _RIM)
    along = np.column_stack([np.linspace(0.0, around, _RIM + 1), np.zeros(_RIM + 1)])
    upper = moved(along[::-1], 0.0, height)
    band = [("lower 1", along[:half]), ("lower 2", along[half:-1]), ("end", along[-1:])]
    band += [("upper 2", upper[:half]), ("upper 1", upper[half:-1]), ("end", upper[-1:])]
    # seen from below the lower rim runs the other way round
    lower = [("lower 2", disc[:half]), ("lower 1", disc[half:])]
    top = [("upper 1", disc[:half]), ("upper 2", disc[half:])]
    return joined_bag([("band", band), ("lower disc", lower), ("upper disc", top)], "end")


def _cone(radius: float, slant: float) -> Bag:
    """A sector sealed to itself along its straight edges, and the disc on which it stands."""
    if slant <= radius:
        raise InputError("The slant of a cone is longer than its radius. Choose a longer slant.")
    half = _RIM // 2
    edge = 2.0 * radius * np.sin(np.pi / _RIM)
    angles = 2.0 * np.arcsin(0.5 * edge / slant) * np.arange(_RIM + 1)
    rim = slant * direction(angles)
    sector = [("end", np.zeros((1, 2))), ("rim 1", rim[:half]), ("rim 2", rim[half:-1]), ("end", rim[-1:])]
    disc = _disc(radius)
    return joined_bag(
        [("cone", sector), ("disc", [("rim 2", disc[:half]), ("rim 1", disc[half:])])],
        "end",
    )


def _disc(radius: float) -> Floats:
    angles = 2.0 * np.pi * np.arange(_RIM) / _RIM
    return radius * direction(angles)


def _pouch(width: float, height: float, depth: float) -> Bag:
    """Front and back, sealed along the top; gussets at the sides and the bottom, so deep when unfolded.

    The side gussets are folded along their middles, where their upper edges are sealed to themselves.
    """
    if depth >= 2.0 * height:
        raise InputError("The gussets are deeper than the pouch is high. Choose a smaller depth.")
    half = 0.5 * depth

    def gusset(side: str, names: tuple[str, str, str]) -> list[NamedSide]:
        corners = np.array([(0.0, 0.0), (depth, 0.0), (depth, height), (half, height), (0.0, height)])
        return polygon(corners, (names[0], names[1], f"fold {side}", f"fold {side}", names[2]))

    bottom = ("bottom back", "bottom right", "bottom front", "bottom left")
    return joined_bag(
        [
            ("front", rectangle(width, height, ("bottom front", "front right", "top", "front left"))),
            ("back", rectangle(width, height, ("bottom back", "back left", "top", "back right"))),
            ("left gusset", gusset("left", ("bottom left", "front left", "back left"))),
            ("right gusset", gusset("right", ("bottom right", "back right", "front right"))),
            ("bottom gusset", rectangle(width, depth, bottom)),
        ],
        "top",
    )


def _beach_ball(diameter: float, gores: int, cap: float) -> Bag:
    """Equal gores from cap to cap, and the two caps, discs of a diameter."""
    if cap > 0.7 * diameter:
        raise InputError("The caps are too large for the ball. Choose a smaller diameter for them.")
    pole = float(np.arcsin(cap / diameter))
    angles = np.linspace(pole, np.pi - pole, _MERIDIAN + 1)
    points = 0.5 * diameter * np.column_stack([np.sin(angles), -np.cos(angles)])
    return gored_bag(Profile(points, DISC, DISC), gores)


#: The ready bodies by name.
READY: dict[str, ReadyBody] = {
    "box": ReadyBody(
        "Box",
        (
            BodySize("length", "Length", 0.3),
            BodySize("width", "Width", 0.2),
            BodySize("height", "Height", 0.15),
        ),
        _box,
    ),
    "pillow-box": ReadyBody(
        "Pillow box",
        (
            BodySize("length", "Length", 0.3),
            BodySize("width", "Width", 0.2),
            BodySize("depth", "Depth", 0.08),
        ),
        _pillow_box,
    ),
    "tetrahedron": ReadyBody("Tetrahedron", (BodySize("edge", "Edge", 0.3),), _tetrahedron),
    "cylinder": ReadyBody(
        "Cylinder", (BodySize("radius", "Radius", 0.15), BodySize("height", "Height", 0.4)), _cylinder
    ),
    "cone": ReadyBody("Cone", (BodySize("radius", "Radius", 0.15), BodySize("slant", "Slant", 0.4)), _cone),
    "pouch": ReadyBody(
        "Gusseted pouch",
        (
            BodySize("width", "Width", 0.2),
            BodySize("height", "Height", 0.3),
            BodySize("depth", "Gussets", 0.1),
        ),
        _pouch,
    ),
    "beach-ball": ReadyBody(
        "Beach ball",
        (
            BodySize("diameter", "Diameter", 0.4),
            BodySize("gores", "Gores", 6, is_count=True),
            BodySize("cap", "Caps", 0.06),
        ),
        _beach_ball,
    ),
}
