# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a drawing is read, and what decides the size of the balloon."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import partial

from BalloonWorkbench.core.options.option import Kind, Section, titles_in

DRAWING, SIZE, FILLING = Section("Drawing"), Section("Size"), Section("Filling")


# fmt: off
@dataclass(frozen=True)
class SizeOptions:
    """The size of a drawing [m]; without both, that of the file."""

    width: float | None = DRAWING(Kind.LENGTH, None, "Width of the drawing; 0 follows from the height",
        label="Width", least=1e-9, step=10.0, begins=0.3, preference="Width")
    height: float | None = DRAWING(Kind.LENGTH, None, "Height of the drawing; 0 follows from the width",
        label="Height", step=10.0)


@dataclass(frozen=True)
class TracingOptions:
    """What of a picture is drawn on, a hole or a line, and how smooth its outline is."""

    threshold: float = DRAWING(Kind.NUMBER, 0.0,
        "How far from the background what is drawn must be, of the greatest difference; 0 finds it",
        step=0.02, most=0.95)
    line_width: float = DRAWING(Kind.NUMBER, 0.05,
        "What is thinner, of the size of the drawing, is a line whose inside is filled; 0 keeps all holes",
        step=0.01, most=0.4)
    smallest_hole: float = DRAWING(Kind.NUMBER, 0.005,
        "Smaller holes, of the area of their shape, are filled", step=0.005, most=0.5)
    smoothness: float = DRAWING(Kind.NUMBER, 1.0,
        "How long the ripples are that are smoothed away, in pixels; 0 keeps all", step=1.0, most=20.0)


USUAL_TRACING = TracingOptions()


@dataclass(frozen=True)
class ReadingOptions(TracingOptions):
    """How a drawing is read; passage [m] is left open in welds that would cut off a part."""

    drawn_as: str = DRAWING(Kind.CHOICE, "auto",
        "How a picture is read: holes of a filled shape stay, lines of a pen drawing are filled inside",
        label="Drawn as", choices={"auto": "Automatic", "shape": "Filled shape", "pen": "Pen drawing"})
    symmetry: str = DRAWING(Kind.CHOICE, "auto",
        "Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored",
        label="Symmetry", choices={"auto": "Automatic", "off": "Off", "force": "Forced"})
    passage: float = DRAWING(Kind.LENGTH, 0.01,
        "Left open in welds that would cut off a part, so wide; 0 gives each part an intake of its own")


def tracing_of(options: TracingOptions) -> TracingOptions:
    """Those of options that say how a picture is traced, alone."""
    return TracingOptions(*(getattr(options, item.name) for item in fields(TracingOptions)))


@dataclass(frozen=True)
class GoalOptions:
    """What decides the size instead of a width: a volume [m3] or a lift [kg]."""

    volume: float | None = SIZE(Kind.VOLUME, None, "Volume that decides the size", label="Volume",
        prop="GoalVolume", flag="--target-volume", metavar="LITRES", plain="l", rivals="goal")
    lift: float | None = SIZE(Kind.MASS, None,
        "What it shall carry besides itself, in grams; 0 makes it float just so", label="Lift in g",
        prop="GoalLift", flag="--target-lift", metavar="GRAMS", plain="g", rivals="goal", step=1.0,
        decimals=1, most=1e7)


@dataclass(frozen=True)
class FillingOptions:
    """What it is filled with, and the air around it; temperatures [K], altitude [m]."""

    gas: str = FILLING(Kind.CHOICE, "helium", "What fills it when it shall float", label="Gas",
        choices=partial(titles_in, "gases.json"), metavar="NAME")
    gas_temperature: float | None = FILLING(Kind.TEMPERATURE, None, "Of warm air, in degrees Celsius",
        typed="Of the gas, such as 80C; by default that of the air, 80C for warm-air", begins=353.15)
    air_temperature: float = FILLING(Kind.TEMPERATURE, 293.15, "Around the balloon, in degrees Celsius",
        typed="Of the air around it, such as 20C")
    altitude: float = FILLING(Kind.HEIGHT, 0.0, "Height above the sea")
