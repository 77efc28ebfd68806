# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the balloon is made of: a film of the library, or numbers of a film of one's own."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from BalloonWorkbench.core.options.option import Kind, Section, titles_in

FILM = Section("Film")
UNKNOWN = "Unknown"
DEFAULT_FILM = "mylar"


# fmt: off
@dataclass(frozen=True)
class MaterialOptions:
    """A film of the library, by name."""

    material: str | None = FILM(Kind.CHOICE, None,
        "What the balloon is made of; Custom lets you give your own values", label="Film", prop="Film",
        typed=f"Film of the library, by default {DEFAULT_FILM}, or a .json file like those; one of",
        choices=partial(titles_in, "films"), metavar="NAME", begins=DEFAULT_FILM, preference="Film")


@dataclass(frozen=True)
class FilmOptions:
    """The numbers of a film in SI units, named as those of `Film`; None where they are not known."""

    young_modulus: float | None = FILM(Kind.PRESSURE, None, "Young's modulus of the film",
        label="Young's modulus", flag="--young", metavar="E", step=1e5)
    poisson_ratio: float | None = FILM(Kind.NUMBER, None, "Poisson's ratio of the film",
        label="Poisson's ratio", flag="--poisson", metavar="NU", begins=0.3, most=0.49, step=0.01)
    young_modulus_across: float | None = FILM(Kind.PRESSURE, None,
        "Young's modulus across the grain; 0 means no grain", label="E across the grain",
        flag="--young-across", metavar="E", step=1e5)
    grain_angle: float = FILM(Kind.ANGLE, 0.0, "Direction of the grain, from the x axis of the drawing",
        label="Grain", flag="--grain")
    thickness: float | None = FILM(Kind.LENGTH, None, "Thickness of the film", label="Thickness", metavar="T",
        step=0.005)
    areal_density: float | None = FILM(Kind.NUMBER, None, "Weight of the film in kg per square metre",
        flag="")
    seal_width: float = FILM(Kind.LENGTH, 0.005, "Width of the weld that this film needs", flag="")
    weld_rigidity: float | None = FILM(Kind.NUMBER, None,
        "Stiffness of a weld in its plane, in parts of what both films have there when they stay flat",
        label="Weld rigidity", metavar="R", begins=1.0, most=10.0, step=0.1)
    joining: str = FILM(Kind.CHOICE, "", "How two panels of this film are joined", flag="",
        choices={"": UNKNOWN, "heat": "Heat", "high-frequency": "High frequency", "glue": "Glue",
            "tape": "Tape"})
    one_side: bool = FILM(Kind.FLAG, False, "Only one side of this film can be joined so", prop="OneSided",
        flag="")
    laser: bool | None = FILM(Kind.CHOICE, None, "Whether a laser may cut this film", flag="",
        choices={None: UNKNOWN, True: "May be cut", False: "Never"})
    sealing_side: str | None = FILM(Kind.TEXT, None,
        "Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known",
        flag="")
    max_stress: float | None = FILM(Kind.PRESSURE, None,
        "Tension over the section at which the film tears; 0: not known", prop="Strength", flag="")
