# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command compare takes."""

from __future__ import annotations

import argparse

from BalloonWorkbench.core.options.making import (
    ArtworkOptions,
    AssemblyOptions,
    MachineOptions,
    ResultOptions,
    RunOptions,
    SharingOptions,
    SheetOptions,
)
from BalloonWorkbench.core.units import parse_length

COMPARE = "compare"
#: Options of a design that a comparison does not have: it makes no other files.
WITHOUT = (
    *(RunOptions, MachineOptions, ResultOptions, AssemblyOptions),
    *(SharingOptions, ArtworkOptions, SheetOptions),
)


def add_compare(command: argparse.ArgumentParser) -> None:
    """Add its arguments to a parser; the input and the options of a design are added beside them."""
    command.add_argument(
        "photo",
        metavar="PHOTO",
        help="PNG, JPEG or BMP picture, straight from the front, on a plain background",
    )
    command.add_argument(
        "input",
        metavar="INPUT",
        help="what the balloon was designed from, with the same options; with --flat the pattern as cut",
    )
    command.add_argument("--out", metavar="DIR", required=True, help="folder for the files")
    command.add_argument(
        "--scale",
        metavar="SCALE",
        required=True,
        help="x1,y1,x2,y2,LENGTH: two points in pixels from the upper left corner, and how far they lie"
        " apart, such as 300mm; PIXELS,LENGTH: a length in pixels; fit: the size that fits best",
    )
    command.add_argument(
        "--flat", action="store_true", help="a scanned panel beside what was cut, an SVG or DXF in real size"
    )
    command.add_argument(
        "--rim",
        metavar="LENGTH",
        type=parse_length,
        help="how far weld and film reach beyond the seam of the balloon in the photograph (default as in the"
        " pattern; 0 where they are folded back)",
    )
    command.add_argument(
        "--uncorrected",
        action="store_true",
        help="the drawing was the pattern, as the command inflate takes it",
    )
    command.add_argument(
        "--fit",
        action="store_true",
        help="also find how much the film stretched and how far the weld draws the seam inward, and write a"
        " film file with them",
    )
