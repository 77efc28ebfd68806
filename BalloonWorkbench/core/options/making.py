# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is made beside the pattern: files for machines, prints, layouts on film, results, assembly sheet."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from BalloonWorkbench.core.options.option import Kind, Section, titles_in

MAKING, ARTWORK, SHEET = Section("Making"), Section("Artwork"), Section("Film", topic="Layout on film")
#: What becomes of a pattern that is larger than the bed: no file, the file all the same, a smaller balloon.
REFUSE, WRITE, SCALE = "refuse", "write", "scale"
MOST_BALLOONS = 100
#: As what a report may be written beside report.json.
HTML = "html"


# fmt: off
@dataclass(frozen=True)
class MachineOptions:
    """Files that go straight to machines."""

    machine: tuple[str, ...] = MAKING(Kind.CHOICE, (),
        "Also write what a machine reads: the name of one, or a .json file; may be repeated", prop="",
        choices=partial(titles_in, "machines"), metavar="NAME")
    bed: str | None = MAKING(Kind.TEXT, None,
        "What the machine can work on, such as 600mmx400mm, 600mm for a roll, or none; by default as its"
        " file has it", prop="", metavar="WIDTH[xHEIGHT]")
    oversize: str = MAKING(Kind.CHOICE, REFUSE,
        "Of a pattern larger than the bed there is no file (refuse), one all the same (write), or the"
        " balloon is made smaller until it fits (scale)", prop="", choices={REFUSE: "", WRITE: "", SCALE: ""})
    tiled: str | None = MAKING(Kind.CHOICE, None, "Also write a PDF to print on several pages", prop="",
        choices={"A4": "", "A3": "", "Letter": ""})


@dataclass(frozen=True)
class WeldingOptions:
    """How fast seams are welded; None is as usual."""

    weld_speed: float | None = MAKING(Kind.NUMBER, None,
        "How fast a seam is welded, in metres a minute, for the hours that a balloon takes", prop="",
        least=0.001, most=1000.0)
    weld_handling: float | None = MAKING(Kind.NUMBER, None,
        "Minutes for each seam beside welding it, to lay its edges on each other", prop="", most=10000.0)


@dataclass(frozen=True)
class ResultOptions:
    """Files about what the film does."""

    results: str | None = MAKING(Kind.CHOICE, None,
        "Also write what each triangle does, for ParaView (vtu) or NumPy (npz)", prop="",
        choices={"vtu": "", "npz": ""})
    frames: int | None = MAKING(Kind.COUNT, None, "Also write so many frames of the inflation, for ParaView",
        prop="")


@dataclass(frozen=True)
class ArtworkOptions:
    """What is printed on a balloon; bleed [m]."""

    picture: str | None = ARTWORK(Kind.FILE, None,
        "What is printed; empty takes the picture or painting of the outline", label="Front",
        flag="--artwork",
        typed="Print this on the balloon; the input itself as it was drawn")
    back_picture: str | None = ARTWORK(Kind.FILE, None,
        "Another picture for the back; empty takes that of the front", label="Back", flag="--artwork-back")
    bleed: float = ARTWORK(Kind.LENGTH, 0.003, "How far the print goes past the cut", label="Bleed")
    dpi: float = ARTWORK(Kind.NUMBER, 300.0, "Dots per inch of the files", label="Dots per inch",
        prop="Resolution", step=50.0, decimals=0, most=2400.0)


@dataclass(frozen=True)
class SheetOptions:
    """How panels are laid out on film; lengths [m]."""

    size: str | None = SHEET(Kind.TEXT, None, "Lay all panels out on a roll of this width, or on sheets",
        prop="", flag="--nest", metavar="WIDTH[xLENGTH]")
    balloons: int = SHEET(Kind.COUNT, 1, "How many balloons of each pattern", label="Balloons of each",
        least=1, most=MOST_BALLOONS)
    film_width: float = SHEET(Kind.LENGTH, 0.5, "Width of the roll or sheet", label="Film width", flag="",
        step=10.0)
    film_length: float | None = SHEET(Kind.LENGTH, None, "Length of a sheet; 0 is a roll",
        label="Sheet length", flag="", step=10.0)
    spacing: float = SHEET(Kind.LENGTH, 0.003, "Film left between pieces, and at the edges", label="Spacing")
    grain: str = SHEET(Kind.CHOICE, "along", "How the grain of pieces lies, where their film has one",
        label="Grain lies", flag="--grain-lies", choices={"along": "Along", "across": "Across", "any": "Any"})


@dataclass(frozen=True)
class AssemblyOptions:
    """The page on how to make a balloon."""

    assembly: str | None = MAKING(Kind.CHOICE, None, "Write an assembly sheet on this paper", prop="",
        choices={"A4": "", "Letter": ""})


@dataclass(frozen=True)
class SharingOptions:
    """What shows the balloon to others."""

    glb: bool = MAKING(Kind.FLAG, False,
        "Also write the balloon with its artwork as balloon.glb, for 3D programs and web pages", prop="")
    report: str | None = MAKING(Kind.CHOICE, None,
        "Also write one web page with the balloon in 3D, its numbers and its pattern, which needs no network",
        prop="", choices={HTML: ""})
