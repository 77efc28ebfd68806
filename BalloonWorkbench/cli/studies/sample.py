# SPDX-License-Identifier: LGPL-2.1-or-later
"""A row of a study of tolerances: one balloon as it comes out of the workshop."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from BalloonWorkbench.cli.options import parser
from BalloonWorkbench.cli.settings import balloon_of, settings_of
from BalloonWorkbench.core.bag_job import FinishedBags
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.job import report_bytes
from BalloonWorkbench.core.making.weight import film_and_valve
from BalloonWorkbench.core.studies.kinds.tolerance_study import sample_of
from BalloonWorkbench.core.targets.form import has_many_panels
from BalloonWorkbench.core.tolerances.made_balloon import Nominal, made_balloon, nominal_of
from BalloonWorkbench.core.tolerances.sample_report import sample_report

_ONE_SHAPE = "Tolerances are worked out for two equal panels of one shape: "


def make(request: Mapping[str, Any]) -> dict[str, bytes]:
    """The report of a sample. Raises BalloonError.

    request  arguments: of the nominal balloon, as on the command line, but for --out; task: see sample_of
    """
    sample, tolerances = sample_of(request["task"])
    made = made_balloon(_nominal(tuple(request["arguments"])), sample, tolerances)
    return {"report.json": report_bytes(sample_report(made))}


@lru_cache(maxsize=1)  # all rows of a study have the same one
def _nominal(arguments: tuple[str, ...]) -> Nominal:
    options = parser().parse_args([*arguments, "--out=."])
    settings = settings_of(options)
    if has_many_panels(options.input, settings.body, settings.side_band):
        raise InputError(f"{_ONE_SHAPE}take a drawing, without a side band or gores.")
    balloon = balloon_of(options, settings, (options.width, options.height))
    assert not isinstance(balloon, FinishedBags)
    if len(balloon.parts) > 1:
        raise InputError(f"{_ONE_SHAPE}this drawing has {len(balloon.parts)} shapes, study one at a time.")
    film_area, valve = film_and_valve(balloon.design.pattern, settings.film, settings.pattern)
    return nominal_of(balloon.design, settings.film, settings.filling, film_area, valve)
