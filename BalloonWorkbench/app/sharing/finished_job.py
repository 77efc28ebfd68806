# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a document as the core's finished job: what is shown, nothing is solved anew."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.document.kinds import is_outline, leader
from BalloonWorkbench.app.engine import advice, bag_result, film_result, maker, panel_prints
from BalloonWorkbench.app.engine.cut_sheet import insist_on_ready


@dataclass(frozen=True)
class FinishedJob:
    """A balloon with what is printed on it; any thread may read it.

    balloon  the core's Balloon or FinishedBags; printed: the core's Printed or None
    count    gives the core's Numbers, see `maker.counting`
    """

    title: str
    balloon: Any
    printed: Any
    count: Callable[[], Any]

    def with_numbers(self):
        """The job with its numbers."""
        (part,) = self.balloon.parts
        return replace(self.balloon, parts=(replace(part, numbers=self.count()),))


def finished_job(parts, *, advised: bool = False) -> FinishedJob:
    """What is shown of a balloon; advised: with the advice on it.

    Raises ExportError where something of it is not up to date.
    """
    print_obj = artwork.of_balloon(parts.balloon)
    for obj in (*parts, *([] if print_obj is None else [print_obj])):
        insist_on_ready(obj)
    group = parts.balloon.getParentGroup()
    title = group.Label if group else parts.balloon.Label
    many = bag_result.has_many_panels(parts.balloon)
    job = panel_prints.finished(parts.pattern) if many else _two_panels(parts)
    if advised:
        findings = [{"severity": each.severity.value, "text": each.text} for each in advice.findings(parts)]
        warnings = json.loads(parts.balloon.Report).get("warnings", [])
        job = replace(job, report={"parts": [{"advice": findings}], "warnings": warnings})
    if print_obj is None:
        printed = None if many else _painting(parts.balloon, job.settings.film)
    else:
        printed = panel_prints.chosen(print_obj)[1] if many else _artwork(print_obj)
    return FinishedJob(title, job, printed, maker.counting(parts))


def _two_panels(parts):
    """Two equal panels as a finished job."""
    from BalloonWorkbench.app.pattern import build, values
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.job import Balloon, Part, Settings
    from BalloonWorkbench.core.outline.drawing import Drawing

    design = film_result.design(parts.balloon)
    settings = Settings(film=film.read(parts.balloon), pattern=values(parts.pattern))
    return Balloon(Drawing((design.target,)), settings, (Part(design, build(parts.pattern), None),), {})


def _artwork(obj):
    from BalloonWorkbench.core.scenes.surface_mesh import Painted

    return Painted(*artwork.in_place(obj))


def _painting(balloon, film):
    """The painting of the outline on its film; None where it is not painted."""
    import numpy as np

    from BalloonWorkbench.app.drawings import painting
    from BalloonWorkbench.core.artwork.picture import Picture
    from BalloonWorkbench.core.pictures.render import rgb
    from BalloonWorkbench.core.scenes.surface_mesh import Painted
    from BalloonWorkbench.core.units import from_mm

    if not is_outline(leader(balloon.Outline)):
        return None
    art = painting.artwork(balloon.Outline)
    if art is None:
        return None
    opacity = art.rgba[..., 3:] / 255.0
    colours = opacity * art.rgba[..., :3] + (1.0 - opacity) * 255.0 * rgb(film.look.colour)
    pixels = np.full(art.rgba.shape, 255, np.uint8)
    pixels[..., :3] = np.rint(colours)
    picture = Picture(pixels, from_mm(art.corner), from_mm(np.full(2, art.pixel)))
    return Painted(picture, picture)
