# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon object of many panels asks of the engine, and what there is to tell about the answer.

Free of the document, so that it may be solved in another thread.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np

from BalloonWorkbench.core.advice.as_data import finding_data
from BalloonWorkbench.core.advice.many_panels.bag_advice import design_findings
from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.source import Source
from BalloonWorkbench.core.bag_job import design_at_goal
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.polyline import signed_area
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.making.weight import weighing
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.options.body import ACCURACY
from BalloonWorkbench.core.options.drawing import ReadingOptions
from BalloonWorkbench.core.options.option import options_of
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.results.film_state import film_state
from BalloonWorkbench.core.rounded import rounded
from BalloonWorkbench.core.targets.target import Division
from BalloonWorkbench.core.types import Progress, no_progress
from BalloonWorkbench.core.units import to_mm

_NONE = Residual(0.0, 0.0, 0.0)
#: What of the settings a balloon of many panels depends on, besides the film.
_OF_SETTINGS = (
    *("correct", "pressure", "volume", "mesh_size", "backend", "model", "body", "side_band", "target"),
)


@dataclass(frozen=True)
class BagRequest:
    """One balloon of many panels to be designed: what it is to be, and how it is made.

    name  of the drawing, the profile or the bag; kind: what that was read from
    """

    source: Source
    name: str
    kind: str
    settings: Settings

    def key(self) -> str:
        """The same for the same balloon: what a result is labelled with."""
        own = {name: getattr(self.settings, name) for name in _OF_SETTINGS}
        film = _of_film(self.settings.film)
        gas = self.settings.filling if self.settings.body.hydrostatic else None
        goal = None if self.settings.goal is None else _of_goal(self.settings)
        source = _without_notes(self.source)
        digest = hashlib.sha256()
        for part in _texts((own, film, gas, source, goal)):
            digest.update(part.encode())
        return digest.hexdigest()

    def design(self, progress: Progress = no_progress) -> BagDesign:
        """Panels and balloon; BalloonError when there is none, Cancelled when progress says stop."""
        return _design(self.source, _of_balloon(self.settings), progress)

    def solve(self, progress: Progress = no_progress) -> tuple[BagDesign, dict[str, Any]]:
        """The design, and what `describe_bag` says about it; raises as `design` does."""
        design = self.design(progress)
        return design, self.describe(design)

    def describe(self, design: BagDesign) -> dict[str, Any]:
        """What there is to tell about a design, as plain data; touches no document."""
        return describe_bag(self, design)


def _without_notes(source: Source) -> Source:
    """Remarks and names change no balloon."""
    if isinstance(source, Bag):
        return source
    if isinstance(source, Division):
        return replace(source, target=replace(source.target, source="", notes=()))
    return replace(source, notes=())


def _of_balloon(settings: Settings) -> Settings:
    """Settings without how the drawing was read, and what of the pattern weighs nothing."""
    return replace(
        settings,
        **{option.name: option.default for option in options_of(ReadingOptions)},
        pattern=PatternOptions() if settings.goal is None else weighing(settings.pattern),
    )


def _of_film(film: Film) -> tuple[Any, ...]:
    """What of a film its balloon depends on."""
    weld = film.seal_width, film.weld_rigidity
    return (
        film.young_modulus,
        film.poisson_ratio,
        film.thickness,
        *weld,
        film.young_modulus_across,
        film.grain_angle,
    )


def _of_goal(settings: Settings) -> tuple[Any, ...]:
    """What decides the size that meets a goal."""
    return settings.goal, settings.filling, settings.film.areal_density, weighing(settings.pattern)


@memoized(most=8)
def _design(source: Source, settings: Settings, progress: Progress) -> BagDesign:
    return design_at_goal(source, settings, progress)[0]


def _texts(value: Any) -> Iterator[str]:
    """A value in words without its last digits, which a file or another unit may change."""
    if isinstance(value, np.ndarray):
        yield f"{value.shape}{(np.round(value, 9) + 0.0).tolist()}"
    elif is_dataclass(value):
        for item in fields(value):
            yield f"{item.name}:"
            yield from _texts(getattr(value, item.name))
    elif isinstance(value, dict):
        for name, each in value.items():
            yield f"{name}:"
            yield from _texts(each)
    elif isinstance(value, (tuple, list)):
        yield f"{len(value)} of "
        for each in value:
            yield from _texts(each)
    else:
        yield f"{rounded(value)!r};"


def describe_bag(request: BagRequest, design: BagDesign) -> dict[str, Any]:
    """What there is to tell about a design, as plain data with the keys of a report of two panels."""
    inflation, settings = design.inflation, request.settings
    error, state = design.residual or _NONE, film_state(inflation, settings.film)
    sizes = [to_mm(float(size)) for size in np.ptp(inflation.positions[design.film], axis=0)]
    area = film_area(design.bag)
    target = inflation.positions[:, :2] if design.target is None else design.target
    return {
        "input": {
            "file": request.name,
            "kind": request.kind,
            **dict(zip(("width_mm", "height_mm"), map(to_mm, np.ptp(target, axis=0).tolist()))),
        },
        "pressure_Pa": inflation.report.pressure,
        "backend": inflation.report.backend,
        "solve": {
            "newton_steps": inflation.report.newton_steps,
            "converged": inflation.report.converged,
            "seconds": inflation.report.seconds,
        },
        "design": {
            "passes": design.passes,
            "silhouette_error_mm": {name: to_mm(value) for name, value in asdict(error).items()},
            "relative_error": error.mean / design.size,
            "reached": design.reached,
            "weld_range": None,
        },
        "inflated": {
            "volume_m3": inflation.volume,
            **dict(zip(("width_mm", "height_mm", "thickness_mm"), sizes)),
            "film_area_m2": area,
            "max_tension_N_per_m": float(inflation.tensions.max()),
            "max_strain": float(state.strains.max()),
            "area_shares": {kind.name.lower(): share for kind, share in state.shares().items()},
        },
        "puffiness": 6.0 * math.sqrt(math.pi) * inflation.volume / area**1.5,
        "advice": [
            finding_data(finding) for finding in design_findings(design, settings.body.accuracy or ACCURACY)
        ],
        "warnings": list(design.warnings),
    }


def film_area(bag: Bag) -> float:
    """Film inside the seams [m2]."""
    return float(sum(signed_area(loop) for panel in bag.panels if panel.cut for loop in panel.loops))
