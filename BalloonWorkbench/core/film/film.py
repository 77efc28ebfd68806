# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film: what the sheet is made of."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.film.start_values import NOT_STATED, StartValues
from BalloonWorkbench.core.options.film import FilmOptions
from BalloonWorkbench.core.types import Say, in_english

#: Metallic; see-through and shiny; fibres; without any shine.
LOOKS = ("foil", "clear", "paper", "matt")

#: How panels are joined, "" where nobody knows, and what people call the line along which they are.
JOININGS = {
    "": "seam",
    "heat": "weld",
    "high-frequency": "weld",
    "glue": "glued seam",
    "tape": "taped seam",
}


#: The sealing side of a film that does not weld.
NO_WELD = "none"
#: The source of a number that nobody has measured, and of one that a user has typed.
ASSUMED, BY_USER = "assumed", "given by the user"


@dataclass(frozen=True)
class Look:
    """What a film looks like: one of LOOKS, colour as "#rrggbb", opacity from 0 to 1."""

    kind: str = "foil"
    colour: str = "#cc294d"
    opacity: float = 1.0


@dataclass(frozen=True)
class Film:
    """An elastic film; SI units.

    name   the word by which it is chosen, such as "mylar"
    sealing_side  polymer of the side that is welded, such as "PE": films weld where it is the same; NO_WELD
           where nothing welds to it, None where it is not known
    title  what people read; note and sources tell where it fits and where its numbers come from
    joining      how panels are joined, a key of JOININGS; one_side: with one of its sides only
    some_grades  those with a sealing layer can be joined so, plain film cannot
    laser        whether a laser may cut it, None where nobody knows
    weld_rigidity        how stiff a weld is in its plane, in parts of what both films have when they stay
           flat over the width of weld and allowance; weld_rigidity_source tells where that is from
    start_values  with which settings the first welds are tried

    Isotropic unless young_modulus_across is given: then young_modulus is that along the grain, which runs at
    grain_angle from the x axis of the drawing, and poisson_ratio the contraction across under tension along.
    grain tells that it is made with one, known to the model or not: its pieces may not be turned anyhow.
    """

    name: str
    young_modulus: float  # E [Pa]
    poisson_ratio: float  # nu
    thickness: float  # t [m]
    areal_density: float  # [kg/m2]
    seal_width: float = FilmOptions.seal_width  # [m]
    max_stress: float | None = None  # tensile strength [Pa], if known
    title: str = ""
    note: str = ""
    sources: tuple[str, ...] = ()
    young_modulus_across: float | None = None  # [Pa]
    shear_modulus: float | None = None  # [Pa]; None: as for an isotropic film of the mean modulus
    grain_angle: float = 0.0  # [rad]
    look: Look = Look()
    sealing_side: str | None = None
    grain: bool = False
    joining: str = ""
    one_side: bool = False
    some_grades: bool = False
    laser: bool | None = None
    weld_rigidity: float = 1.0
    weld_rigidity_source: str = ASSUMED
    start_values: StartValues = NOT_STATED

    @property
    def lies(self) -> float | None:
        """Direction of the grain in the drawing [rad], None for a film without one."""
        return self.grain_angle if self.grain or self.young_modulus_across is not None else None

    @property
    def roll(self) -> tuple[object, ...]:
        """What two films from one roll have in common, however they lie in a drawing and are welded."""
        stiffness = self.young_modulus, self.young_modulus_across, self.poisson_ratio
        return (self.title, self.thickness, self.areal_density, *stiffness, self.sealing_side)

    @property
    def seam(self) -> str:
        """What people call the line along which two panels are joined."""
        return JOININGS[self.joining]

    def first_weld(self, say: Say = in_english) -> str:
        """With what the first weld is tried, a sentence; empty for films that are not welded by heat."""
        if self.joining != "heat":
            return ""
        known = self.start_values
        stated, sources = known.sentence(say), "; ".join(known.sources)
        if known.is_known:
            return say(f"Start values for welding: {stated} ({sources}).")
        card = say("Make a test card: nobody states a temperature for this film.")
        return " ".join(filter(None, [card, say(f"Stated is: {stated} ({sources}).") if stated else ""]))

    @property
    def membrane_stiffness(self) -> float:
        """E t [N/m]."""
        return self.young_modulus * self.thickness

    @property
    def flexural_rigidity(self) -> float:
        """D = E t^3 / (12 (1 - nu^2)) [N m]."""
        return self.young_modulus * self.thickness**3 / (12.0 * (1.0 - self.poisson_ratio**2))
