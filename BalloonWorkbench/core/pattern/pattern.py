# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern: contours with a meaning, ready for a cutter."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from BalloonWorkbench.core.geometry.polyline import bounds, ring, signed_area
from BalloonWorkbench.core.types import Floats


class Role(str, Enum):
    """What a machine does along a contour, in the order of the work; the value is the layer's name."""

    REGISTRATION = "REGISTRATION"  # control bar, marks to find the sheet again
    PRINT = "PRINT"
    ENGRAVE = "ENGRAVE"  # labels
    PEN = "PEN"  # drawn: where a part is laid, how far a straw goes in
    FOLD = "FOLD"  # drawn: where the film is turned over
    SEAL = "SEAL"
    WELD = "WELD"  # inside the balloon
    NOTCH = "NOTCH"  # short cuts from the edge, outside the weld
    CUT_INNER = "CUT_INNER"
    CUT = "CUT"

    @property
    def is_cut(self) -> bool:
        """Whether a tool goes through the film there; all other lines are drawn or welded."""
        return self in (Role.NOTCH, Role.CUT_INNER, Role.CUT)


@dataclass(frozen=True)
class Contour:
    """A polyline with a role: points (n, 2) m, the first point not repeated when closed.

    front  only the front panel has it, as the hole of a nozzle
    stock  the film that it is on: "" the balloon's, else a name such as "valve"
    filled printed all over, as a mark that a machine looks for
    """

    role: Role
    points: Floats
    closed: bool
    front: bool = False
    stock: str = ""
    filled: bool = False

    @property
    def line(self) -> Floats:
        """Points (k, 2) m from its beginning to its end: of a closed one the first point is repeated."""
        return ring(self.points, self.closed)


@dataclass(frozen=True)
class Intake:
    """Where the balloon is filled.

    at     (2,) m, the middle of a neck's root on the seam, or of a nozzle
    angle  direction in which it points, counter-clockwise from +x [rad]
    width  inner width of a neck, bore of a nozzle [m]
    length of a neck from the seam outward, diameter of a nozzle's flange [m]
    along  place of the neck's root, counter-clockwise along the outer seam from its rightmost point [m]
    kind   name of the intake's kind
    """

    at: Floats
    angle: float
    width: float
    length: float
    along: float = 0.0
    kind: str = "straw"


@dataclass(frozen=True)
class Pattern:
    """One panel of the balloon as contours; cut two.

    contours      inner ones (welds, holes) first, the outer CUT last
    seam_length   m, length of the weld of all loops, intake mouth excluded
    warnings      one sentence each, for the user
    more_intakes  those of chambers that the first one does not reach
    film          length and width of the film that it is laid out on, whose corner is the origin [m]; None of
                  a pattern that lies anywhere
    page          lower left and upper right corner (2,) m of the paper that it is printed on, where it is
    """

    contours: tuple[Contour, ...]
    intake: Intake | None
    seal_width: float
    seam_length: float
    warnings: tuple[str, ...] = ()
    more_intakes: tuple[Intake, ...] = ()
    film: tuple[float, float] | None = None
    page: tuple[Floats, Floats] | None = None

    @property
    def intakes(self) -> tuple[Intake, ...]:
        """All intakes, the largest chamber's first."""
        return () if self.intake is None else (self.intake, *self.more_intakes)

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower left and upper right corner (2,) of everything to be cut [m]."""
        points = np.concatenate([contour.points for contour in self.contours])
        return bounds(points)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, intake included [m]."""
        low, high = self.bounds
        width, height = high - low
        return float(width), float(height)

    @property
    def film_area(self) -> float:
        """Area of the piece of film [m2]."""
        whole, cut_out = (
            sum(abs(signed_area(contour.points)) for contour in self.of(role))
            for role in (Role.CUT, Role.CUT_INNER)
        )
        return whole - cut_out

    @property
    def roles(self) -> tuple[Role, ...]:
        """The roles that occur, in the order in which a machine takes them."""
        present = {contour.role for contour in self.contours}
        return tuple(role for role in Role if role in present)

    @property
    def stocks(self) -> tuple[str, ...]:
        """The films that its pieces are cut from, the balloon's first."""
        return tuple(sorted({contour.stock for contour in self.contours}))

    def of_stock(self, stock: str) -> Pattern:
        """What is cut from one film; the seam is that of the panels."""
        if self.stocks == (stock,):
            return self
        contours = tuple(contour for contour in self.contours if contour.stock == stock)
        if stock:
            return replace(self, contours=contours, intake=None, more_intakes=(), seam_length=0.0)
        return replace(self, contours=contours)

    def of(self, role: Role) -> tuple[Contour, ...]:
        """The contours of one role."""
        return tuple(contour for contour in self.contours if contour.role is role)

    def moved(self, shift: Floats) -> Pattern:
        """The pattern moved by a shift (2,) [m]."""
        return replace(
            self,
            contours=tuple(replace(contour, points=contour.points + shift) for contour in self.contours),
            intake=None if self.intake is None else replace(self.intake, at=self.intake.at + shift),
            more_intakes=tuple(replace(intake, at=intake.at + shift) for intake in self.more_intakes),
            film=None,
            page=None if self.page is None else (self.page[0] + shift, self.page[1] + shift),
        )
