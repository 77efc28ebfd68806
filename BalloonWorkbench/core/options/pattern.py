# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a pattern is made: weld and cut, intake, marks."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from BalloonWorkbench.core.options.option import Kind, Section, titles_in

#: The usual kind of intake.
STRAW = "straw"
#: Where an intake sits by itself: at the point of the seam farthest from the centre, or low on the balloon.
FARTHEST, LOW = "farthest", "low"
MOST_COPIES, MOST_NOTCHES = 100, 1000
WELD, INTAKE, MARKS = Section("Pattern"), Section("Intake"), Section("Marks")


# fmt: off
@dataclass(frozen=True)
class PatternOptions:
    """How a pattern is made; lengths [m], angles [rad], None where the pattern finds the value.

    seal_width is the film's without one; width and length of an intake are its kind's; its place is
    intake_place where neither angle nor along is given.
    """

    seal_width: float | None = WELD(Kind.LENGTH, None, "Width of the weld; 0 takes the film's",
        label="Seal width", preference="Seal width (0: the film's)")
    allowance: float = WELD(Kind.LENGTH, 0.002, "Film left outside the weld", label="Allowance",
        preference="Allowance")
    corner_radius: float = WELD(Kind.LENGTH, 0.0,
        "Corner relief: corners of the cuts are rounded so; the weld is not", label="Corner relief",
        flag="--corner-relief")
    mirror: bool = WELD(Kind.FLAG, False, "The second panel beside the first, mirrored; else cut twice",
        label="Second panel, mirrored")
    copies: int = WELD(Kind.COUNT, 1, "How many balloons are cut from the sheet", label="Copies", least=1,
        most=MOST_COPIES)
    intake: bool = INTAKE(Kind.FLAG, True, "Add what the balloon is filled through", label="Air intake",
        flag="")
    intake_kind: str = INTAKE(Kind.CHOICE, STRAW, "How the balloon is filled and closed", label="Kind",
        flag="--intake", choices=partial(titles_in, "intakes", STRAW), switch="intake", needs="Intake")
    intake_width: float | None = INTAKE(Kind.LENGTH, None, "Inner width of the neck, or bore of the nozzle",
        label="Width", begins=0.01, needs="Intake")
    intake_length: float | None = INTAKE(Kind.LENGTH, None,
        "Length of the neck from the seam outward, or diameter of the flange; 0 takes the usual one",
        label="Length", needs="Intake")
    intake_place: str = INTAKE(Kind.CHOICE, FARTHEST,
        "Where it is found: farthest from the centre, or low, where a tied balloon hangs straight",
        label="Place", prop="IntakeAutoPlace", choices={FARTHEST: "Farthest point", LOW: "Low"},
        rivals="place")
    intake_angle: float | None = INTAKE(Kind.ANGLE, None,
        "Direction of the neck, counter-clockwise from the x axis", label="Direction", rivals="place")
    intake_along: float | None = INTAKE(Kind.LENGTH, None,
        "Place of the intake: counter-clockwise along the outer seam from its rightmost point",
        label="Along the seam", step=5.0, rivals="place")
    opening: str = INTAKE(Kind.TEXT, "",
        "Where a balloon of many panels is filled: the number of a seam, or a panel and the point at which an"
        " edge begins, such as top.2; a panel alone has a nozzle in its middle", label="Seam or edge",
        metavar="SEAM", needs="Intake")
    opening_share: float | None = INTAKE(Kind.NUMBER, None,
        "How far along that seam, from 0 to 1 of its length; 0 takes its middle, or that of the edge",
        label="How far along it", most=1.0, step=0.05, needs="Intake")
    notches: int = MARKS(Kind.COUNT, 0,
        "Notches to lay both films on each other by, evenly along the cut; of many panels, groups of them on"
        " each seam, 0 as many as its length needs",
        label="Notches", most=MOST_NOTCHES, weighs=False)
    notch_depth: float = MARKS(Kind.LENGTH, 0.0015, "Length of a notch; at most the allowance",
        label="Their depth", step=0.5, needs="Notches", weighs=False)
    tie_tab: bool = MARKS(Kind.FLAG, False, "A tab with a hole to tie the balloon to, outside the weld",
        label="Tab to tie it to", flag="")
    tie_tab_angle: float | None = MARKS(Kind.ANGLE, None,
        "Direction of the tab from the middle of the pattern", label="Direction", flag="--tie-tab",
        switch="tie_tab",
        typed="A tab with a hole to tie the balloon to, in this direction; by default opposite the intake")
    label: str = MARKS(Kind.TEXT, "", "A line of text where the film is widest, as outlines", label="Label",
        prop="LabelText", weighs=False)
    label_height: float = MARKS(Kind.LENGTH, 0.006, "Height of its capital letters", label="Letter height",
        needs="LabelText", weighs=False)
