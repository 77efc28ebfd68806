# SPDX-License-Identifier: LGPL-2.1-or-later
"""All options of the product, by what they are about."""

from __future__ import annotations

from BalloonWorkbench.core.options.body import BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.drawing import FillingOptions, GoalOptions, ReadingOptions, SizeOptions
from BalloonWorkbench.core.options.film import FilmOptions, MaterialOptions
from BalloonWorkbench.core.options.making import (
    ArtworkOptions,
    AssemblyOptions,
    MachineOptions,
    ResultOptions,
    RunOptions,
    SharingOptions,
    SheetOptions,
    TabOptions,
    ToolOptions,
    WeldingOptions,
)
from BalloonWorkbench.core.options.option import Option, options_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions

#: In the order in which they are told.
DECLARED: tuple[type, ...] = (
    SizeOptions,
    ReadingOptions,
    GoalOptions,
    BodyOptions,
    BandOptions,
    TargetOptions,
    FillingOptions,
    MaterialOptions,
    FilmOptions,
    InflationOptions,
    ModelOptions,
    PatternOptions,
    RunOptions,
    MachineOptions,
    ToolOptions,
    TabOptions,
    WeldingOptions,
    ResultOptions,
    AssemblyOptions,
    SharingOptions,
    ArtworkOptions,
    SheetOptions,
)


def options() -> tuple[Option, ...]:
    """Every option once."""
    return tuple(option for declaring in DECLARED for option in options_of(declaring))
