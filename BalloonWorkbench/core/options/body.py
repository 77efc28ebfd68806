# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels: bodies of gores, letters with a side band, solids and meshes."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.options.option import Kind, Section

BODY, BAND = Section("Body", topic="Body of gores"), Section("Band", topic="Side band")
SOLID = Section("Solid", topic="Mesh of a body")
#: How an end of a profile is closed.
AUTOMATIC, POINT, DISC, OPEN = "auto", "point", "disc", "open"
#: How far a body of gores may be from its profile where nothing is said, in parts of the profile's diagonal.
ACCURACY = 0.01
#: Into how many panels a mesh is divided where nothing is said.
PANELS = 16
#: So many at most.
MOST_PANELS = 200
#: What a balloon shall do with the body that it is made for.
FOLLOW, ENCLOSE, INSIDE = "follow", "enclose", "inside"
_LIES = {FOLLOW: "Follows the body", ENCLOSE: "Encloses it", INSIDE: "Lines it inside"}
_ENDS = {AUTOMATIC: "Automatic", POINT: "Point", DISC: "Disc", OPEN: "Open"}


# fmt: off
@dataclass(frozen=True)
class BodyOptions:
    """A body of gores; without a number of gores as many as the accuracy needs, ACCURACY without one.

    The accuracy decides the number of panels of a solid or a mesh, too.
    """

    gores: int | None = BODY(Kind.COUNT, None, "How many gores; 0 takes as many as the accuracy needs",
        label="Gores", most=100, begins=6)
    accuracy: float | None = BODY(Kind.NUMBER, None,
        "How far the balloon may be from its profile or body on average, in parts of the diagonal",
        label="Within", least=1e-4, most=0.2, step=0.005, decimals=4, begins=ACCURACY)
    lower_cap: str = BODY(Kind.CHOICE, AUTOMATIC, "How the lower end is closed", label="Lower end",
        choices=_ENDS)
    upper_cap: str = BODY(Kind.CHOICE, AUTOMATIC, "How the upper end is closed", label="Upper end",
        choices=_ENDS)
    hydrostatic: bool = BODY(Kind.FLAG, False,
        "The pressure is that at the lower end and rises with the height, as the gas is lighter than air",
        label="Pressure rises with height")


@dataclass(frozen=True)
class BandOptions:
    """A band between front and back [m]; 0 of both: two panels, sealed at the border."""

    band: float = BAND(Kind.LENGTH, 0.0, "Width of a side band between front and back; 0 is two panels",
        label="Side band", step=5.0)
    body_thickness: float = BAND(Kind.LENGTH, 0.0,
        "Thickness of the balloon, from which the side band follows; 0 takes the band's own width",
        label="Thickness", step=5.0)
    band_piece: float = BAND(Kind.LENGTH, 0.0, "Longest piece of the side band; 0 is the width of the film",
        label="Longest piece of the band", step=50.0)


@dataclass(frozen=True)
class TargetOptions:
    """Into what a closed body is divided, and how the balloon lies on it."""

    panels: int | None = SOLID(Kind.COUNT, None,
        "Into how many panels the body is divided; 0 takes the faces of a solid, 16 panels of a mesh; 1 takes"
        " only the seams that are drawn", label="Panels", most=MOST_PANELS)
    seams: str | None = SOLID(Kind.FILE, None,
        "JSON file of seams that are merged, cut, moved or drawn on the body", metavar="FILE", prop="")
    lies: str = SOLID(Kind.CHOICE, FOLLOW, "Whether the balloon follows the body, encloses or lines it",
        label="The balloon", choices=_LIES)
    margin: float = SOLID(Kind.LENGTH, 0.0, "So far outside of the body, or inside, the film lies at least",
        label="By at least", step=1.0)
