# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the command line about the pattern: weld, intake, marks, how often it is cut."""

from __future__ import annotations

import argparse
import math

from BalloonWorkbench.core.outline.chambers import PASSAGE
from BalloonWorkbench.core.pattern.intake.kinds import STRAW, intake_kinds
from BalloonWorkbench.core.pattern.intake.places import FARTHEST, PLACES
from BalloonWorkbench.core.pattern.make import Wanted
from BalloonWorkbench.core.units import length_text, parse_length

_USUAL = Wanted()


def add_pattern(command: argparse.ArgumentParser) -> None:
    """Options that make up a `Wanted`, and the passages."""
    group = command.add_argument_group("pattern")

    def length(name: str, told: str, usual: float | None = None) -> None:
        default = "" if usual is None else f" (default {length_text(usual).replace(' ', '')})"
        group.add_argument(name, metavar="LENGTH", help=told + default)

    length("--seal-width", "width of the weld; by default the film's")
    length("--allowance", "film left outside the weld", _USUAL.allowance)
    length("--corner-relief", "radius with which corners of the cuts are rounded")
    group.add_argument(
        "--intake",
        choices=[*intake_kinds(), "none"],
        default=STRAW,
        help=f"through which it is filled (default {STRAW})",
    )
    length("--intake-width", "inner width of the neck, or bore of the nozzle")
    length("--intake-length", "of the neck from the seam outward, or diameter of the nozzle's flange")
    place = group.add_mutually_exclusive_group()
    place.add_argument(
        "--intake-angle",
        metavar="DEGREES",
        type=float,
        help="direction from the centre in which it sits",
    )
    place.add_argument(
        "--intake-along",
        metavar="LENGTH",
        help="its place instead: counter-clockwise along the seam from its rightmost point",
    )
    place.add_argument(
        "--intake-place",
        choices=PLACES,
        default=FARTHEST,
        help="where it is found: at the point farthest from the centre (the default), or low, where a tied"
        " balloon hangs straight",
    )
    length("--passage", "left open in welds that would cut off a part; 0 gives each its own intake", PASSAGE)
    group.add_argument(
        "--notches", metavar="N", type=int, default=0, help="marks outside the weld, evenly along the cut"
    )
    length("--notch-depth", "of these marks", _USUAL.notch_depth)
    group.add_argument(
        "--tie-tab",
        metavar="DEGREES",
        type=float,
        nargs="?",
        const=math.nan,
        help="a tab with a hole to tie it to; by default opposite the intake",
    )
    group.add_argument("--label", metavar="TEXT", default="", help="a text on the pattern, as outlines")
    length("--label-height", "of its capitals", _USUAL.label_height)
    group.add_argument("--mirror", action="store_true", help="the second panel beside the first, mirrored")
    group.add_argument("--copies", metavar="N", type=int, default=1, help="how many balloons are cut")


def wanted(options: argparse.Namespace) -> Wanted:
    """What the options say about the pattern. InputError for text that is no length."""

    def given(text: str | None, otherwise: float | None = None) -> float | None:
        return otherwise if text is None else parse_length(text)

    tab, angle = options.tie_tab, options.intake_angle
    return Wanted(
        seal_width=given(options.seal_width),
        allowance=given(options.allowance, _USUAL.allowance) or 0.0,
        intake=options.intake != "none",
        intake_kind=STRAW if options.intake == "none" else options.intake,
        intake_width=given(options.intake_width),
        intake_length=given(options.intake_length),
        intake_angle=None if angle is None else math.radians(angle),
        intake_along=given(options.intake_along),
        intake_place=options.intake_place,
        corner_radius=given(options.corner_relief) or 0.0,
        notches=options.notches,
        notch_depth=given(options.notch_depth, _USUAL.notch_depth) or 0.0,
        tie_tab=tab is not None,
        tie_tab_angle=None if tab is None or math.isnan(tab) else math.radians(tab),
        label=options.label,
        label_height=given(options.label_height, _USUAL.label_height) or 0.0,
        mirror=options.mirror,
        copies=options.copies,
    )


def passage(options: argparse.Namespace) -> float:
    """The width of the passages [m]."""
    return PASSAGE if options.passage is None else parse_length(options.passage)
