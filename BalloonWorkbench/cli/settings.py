# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the options that were typed to the settings of a job, and to its balloon."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from BalloonWorkbench.cli.options import typed
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import Filling, gas
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import custom_film, film, with_grain, with_weld
from BalloonWorkbench.core.job import Balloon, Settings, make_balloon
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.drawing import FillingOptions, ReadingOptions
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.options.making import WeldingOptions
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.targets.form import PANELS, form_of, has_many_panels
from BalloonWorkbench.core.tracing.raster import opencv

if TYPE_CHECKING:  # loaded where it is needed
    from BalloonWorkbench.core.bag_job import FinishedBags


def settings_of(options: argparse.Namespace) -> Settings:
    """How the balloon is made. Raises InputError for options that exclude each other."""
    filling = typed(options, FillingOptions)
    inflation = replace(typed(options, InflationOptions), correct=_corrected(options))
    return Settings(
        **vars(typed(options, ReadingOptions)),
        **vars(inflation),
        film=_film(options),
        model=Model(**vars(typed(options, ModelOptions))),
        goal=_goal(options),
        filling=Filling(**{**vars(filling), "gas": gas(filling.gas)}),
        pattern=typed(options, PatternOptions),
        body=typed(options, BodyOptions),
        side_band=typed(options, BandOptions),
        target=typed(options, TargetOptions),
        welding=typed(options, WeldingOptions),
    )


def _corrected(options: argparse.Namespace) -> bool:
    """Whether the pattern is corrected: by design, and where a comparison does not say otherwise."""
    return options.command == "design" or not getattr(options, "uncorrected", True)


def _goal(options: argparse.Namespace) -> SizeGoal | None:
    goal = typed(options, SizeGoal)
    if goal == SizeGoal():
        return None
    if options.width is not None or options.height is not None:
        raise InputError("--target-volume and --target-lift decide the size: leave out --width and --height.")
    return goal


def _film(options: argparse.Namespace) -> Film:
    own = (options.young, options.poisson, options.thickness)
    if all(value is None for value in own):
        plain = film(options.material or DEFAULT_FILM)
    elif options.material is not None or any(value is None for value in own):
        raise InputError("Give either --material, or all of --young, --poisson and --thickness.")
    else:
        plain = custom_film(*own)
    if options.weld_rigidity is not None:
        plain = with_weld(plain, options.weld_rigidity)
    if options.young_across is not None:
        return with_grain(plain, options.young_across, options.grain)
    if options.grain:
        raise InputError("Only a film with another stiffness across has a grain: give --young-across too.")
    return plain


def balloon_of(
    options: argparse.Namespace,
    settings: Settings,
    size: tuple[float | None, float | None],
    scale: float = 1.0,
    **known: Any,
) -> Balloon | FinishedBags:
    """The balloon of an input.

    size   width and height of its drawing [m]
    scale  of panels that have their own size
    known  progress and attempt, as make_balloon has them
    """
    asked: dict[str, Any] = {"width": size[0], "height": size[1], **known}
    if not has_many_panels(options.input, settings.body, settings.side_band):
        return make_balloon(options.input, settings, decode=picture_reader(), **asked)
    from BalloonWorkbench.cli.solid import solid_reader
    from BalloonWorkbench.core.bag_design.source import Readers
    from BalloonWorkbench.core.bag_job import make_bags

    asked["readers"] = Readers(picture_reader(), solid_reader())
    if form_of(options.input) == PANELS:  # another size is refused
        asked |= {"scale": scale, "width": options.width, "height": options.height}
    return make_bags(options.input, settings, **asked)


def picture_reader() -> Any:
    """Qt's picture reader where OpenCV is missing; None means OpenCV."""
    if opencv() is not None:
        return None
    try:
        from BalloonWorkbench.app.drawings import qt_picture
    except ImportError:
        return None  # the reader of pictures says what to install
    return qt_picture.decode
