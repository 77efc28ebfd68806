# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is made beside the pattern: files for machines, prints, layouts on film, results, assembly sheet."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from BalloonWorkbench.core.options.option import Kind, Section, option_of, titles_in

MAKING, ARTWORK, SHEET = Section("Making"), Section("Artwork"), Section("Film", topic="Layout on film")
#: What becomes of a pattern that is larger than the bed: no file, the file all the same, a smaller balloon,
#: several files between which the film is moved.
REFUSE, WRITE, SCALE, SPLIT = "refuse", "write", "scale", "split"
MOST_BALLOONS = 100
#: What cuts, and what welds by heat.
KNIFE, LASER, SPINDLE, HOT_TIP, HOT_WHEEL = TOOLS = "knife", "laser", "spindle", "hot-tip", "hot-wheel"
#: Behind a balloon that is shown to others: nothing.
TRANSPARENT = "transparent"
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
        "Of a pattern larger than the bed there is no file (refuse), one all the same (write), several"
        " between which the film is moved (split), or the balloon is made smaller until it fits (scale)",
        prop="", choices={REFUSE: "", WRITE: "", SCALE: "", SPLIT: ""})
    tiled: str | None = MAKING(Kind.CHOICE, None, "Also write a PDF to print on several pages", prop="",
        choices={"A4": "", "A3": "", "Letter": ""})


@dataclass(frozen=True)
class ToolOptions:
    """What a machine that reads G-code holds, and how it works; None is as the machine's file has it."""

    tool: str | None = MAKING(Kind.CHOICE, None, "What a machine that reads G-code holds", prop="",
        choices=dict.fromkeys(TOOLS, ""))
    feed: float | None = MAKING(Kind.NUMBER, None,
        "How fast that tool goes along a line, in millimetres a minute", prop="", metavar="MM/MIN")
    power: float | None = MAKING(Kind.NUMBER, None, "Power of a laser, in percent", prop="",
        metavar="PERCENT")
    spindle_speed: float | None = MAKING(Kind.NUMBER, None, "Turns of a spindle in a minute", prop="")
    tip_temperature: float | None = MAKING(Kind.TEMPERATURE, None,
        "Temperature of a hot tip or wheel, such as 180C", prop="")
    depth: float | None = MAKING(Kind.HEIGHT, None,
        "How far a tool goes below where it touches the film, to cut or to press; 0 touches it", prop="")


@dataclass(frozen=True)
class TabOptions:
    """Short stretches of a cut that a machine leaves, so that pieces do not fall or fly; lengths [m]."""

    tabs: float = MAKING(Kind.LENGTH, 0.0,
        "Leave tabs of this width in the cuts of a machine, on straights, two or more on each and one in"
        " 100 mm, so that pieces stay in the film", prop="")
    tabs_below: float | None = MAKING(Kind.LENGTH, None,
        "Only round pieces that are no larger than this either way; by default round all", prop="")


NO_TABS = TabOptions()


@dataclass(frozen=True)
class RunOptions:
    """How much of a job is done, and by how many."""

    only: tuple[str, ...] = MAKING(Kind.CHOICE, (),
        "Of the files that are written anyway only these; may be repeated", prop="",
        choices=dict.fromkeys(("report", "pattern", "balloon", "preview", "document"), ""))
    threads: int | None = MAKING(Kind.COUNT, None,
        "How many threads solve a large balloon, by default up to four; a small one takes one", prop="",
        least=1)


def is_wanted(name: str, only: tuple[str, ...]) -> bool:
    """Whether a file is wanted, of those of `RunOptions.only`; one that is asked for by itself always is."""
    stem = name.partition(".")[0].partition("-")[0]
    kind = "document" if name.endswith(".FCStd") else stem
    return not only or kind in only or kind not in option_of(RunOptions, "only").titles


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
    marks_for: str | None = ARTWORK(Kind.TEXT, None,
        "The machine that finds the print again by its registration marks; empty has crosses for the eye",
        label="Marks for", metavar="NAME",
        typed="Print the registration marks of this machine; by default of the first --machine that looks for"
        " marks itself, else crosses for the eye")
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
    remnant: str | None = SHEET(Kind.FILE, None,
        "Lay panels first onto what is left of another layout, as its file says; the rest on the film",
        label="Remnant", flag="--on-remnant", metavar="FILE")
    keep_remnant: bool = SHEET(Kind.FLAG, False,
        "Also write what is left of the film as remnant.json, to lay out on it another time", prop="")


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
    png: bool = MAKING(Kind.FLAG, False,
        "Also write a picture of the balloon with its artwork as balloon.png", prop="")
    ground: str | None = MAKING(Kind.TEXT, None,
        "What is behind the balloon in that picture and on that page: a colour such as #3060a0, transparent,"
        " or a picture file, which covers it; by default white, and the page's own", prop="",
        metavar="GROUND")
    report: str | None = MAKING(Kind.CHOICE, None,
        "Also write one web page with the balloon in 3D, its numbers and its pattern, which needs no network",
        prop="", choices={HTML: ""})
    animation: str | None = MAKING(Kind.CHOICE, None,
        "Also write the inflation as a moving picture", prop="", choices={"gif": "", "mp4": ""})
