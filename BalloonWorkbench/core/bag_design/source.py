# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon of many panels is made for: a profile, an outline between two faces, a body, or a bag."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bodies.profile import Profile
from BalloonWorkbench.core.bodies.read_profile import read_profile
from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.files.user_file import read_user_file
from BalloonWorkbench.core.flattening.divide_flat import divide_flat
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.options.body import FOLLOW, BandOptions, BodyOptions, TargetOptions
from BalloonWorkbench.core.options.body import PANELS as PANELS_OF_MESH
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.seam_edits.apply_edits import apply_edits
from BalloonWorkbench.core.seam_edits.read_seams import edits_in
from BalloonWorkbench.core.targets.form import MESH, PANELS, SOLID, form_of
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Division, Target
from BalloonWorkbench.core.tracing.picture import Decode

Source = Profile | Outline | Bag | Division

#: What reads a solid: its file, and into how many panels it is divided, 0 for its faces.
ReadSolid = Callable[[str, int], Division]


@dataclass(frozen=True)
class Readers:
    """What reads the files that the engine does not: pictures of further kinds, and solids; None: nothing."""

    decode: Decode | None = None
    solid: ReadSolid | None = None


NO_READERS = Readers()


def check_together(
    path: str | Path,
    form: str | None,
    body: BodyOptions,
    band: BandOptions,
    target: TargetOptions,
    *,
    sized: bool,
) -> None:
    """Raise InputError for what does not go together; sized: a width or a height is asked for."""
    name, gored, banded = Path(path).name, body != BodyOptions(), band != BandOptions()
    if gored and banded:
        raise InputError(
            "A body of gores has no side band: leave out what you give of the one or of the other."
        )
    if form == PANELS and (gored or banded):
        raise InputError(f"'{name}' has its own panels: leave out what you give of gores or of a side band.")
    if form == PANELS and sized:
        raise InputError(f"'{name}' has the size of its panels: leave out the width and the height.")
    if form in (MESH, SOLID):
        _check_body(name, replace(body, accuracy=None) != BodyOptions() or banded, body, target)
    elif target != TargetOptions():
        raise InputError(
            f"'{name}' is no closed body: leave out --panels, or give an STL, OBJ, PLY, 3MF or STEP."
        )
    if form and banded:
        raise InputError(f"'{name}' is a profile, which has no side band: give a drawing for that.")
    if band.band > 0.0 and band.body_thickness > 0.0:
        raise InputError("The thickness of the balloon decides the width of its side band: give one of them.")
    if banded and not (band.band > 0.0 or band.body_thickness > 0.0):
        raise InputError("The side band has no width: give its width, or the thickness of the balloon.")


def _check_body(name: str, other: bool, body: BodyOptions, target: TargetOptions) -> None:
    """Raise InputError for what does not go together of a body; other: gores or a band are asked for."""
    if other:
        raise InputError(f"'{name}' is a body: leave out what you give of gores or of a side band.")
    if body.accuracy is not None and target.panels:
        raise InputError("The accuracy decides the number of panels: give one of them.")
    if body.accuracy is not None and target.lies != FOLLOW:
        raise InputError(
            "An accuracy is for a balloon that follows its body: give the number of panels of one that"
            " encloses or lines it."
        )


def profile_of_size(
    path: str | Path, body: BodyOptions, width: float | None = None, height: float | None = None
) -> Profile:
    """The profile in a file, as wide or high as the body shall be [m]; inside both where both are given."""
    profile = read_profile(path, body.lower_cap, body.upper_cap)
    if profile is None:
        raise InputError(
            f"'{Path(path).name}' has no profile: give half the outline of the body as an SVG, a DXF or JSON."
        )
    own = [2.0 * profile.points[:, 0].max(), np.ptp(profile.points[:, 1])]
    return replace(profile, points=profile.points * _smaller_scale((width, height), own))


def division_of_size(
    path: str | Path,
    options: TargetOptions,
    width: float | None = None,
    height: float | None = None,
    solid: ReadSolid | None = None,
) -> Division:
    """The body in a file, so wide or high [m], in as many panels as wanted, with the user's seams.

    Raises MissingPackageError for a solid where there is nothing that reads it.
    """
    edits = edits_in(options.seams)
    if form_of(path) == SOLID:
        read_user_file(Path(path), 1)  # a mistake in its name shows before the work
        if solid is None:
            raise MissingPackageError(
                f"'{Path(path).name}' is read by FreeCAD, which is not there: install it for the Python that"
                " runs this, or give an STL of the solid."
            )
        return apply_edits(of_size(solid(str(path), options.panels or 0), width, height), edits)
    division = divide_flat(read_target(path, width, height), options.panels or PANELS_OF_MESH)
    return apply_edits(division, edits)


def of_size(division: Division, width: float | None, height: float | None) -> Division:
    """The division of a body so wide and high [m], along x and z; inside both where both are given."""
    return division.scaled(_scale_of(division.target, width, height)).rounded()


def target_of_size(target: Target, width: float | None, height: float | None) -> Target:
    """The same of the body alone."""
    return replace(target, points=target.points * _scale_of(target, width, height))


def _scale_of(target: Target, width: float | None, height: float | None) -> float:
    size = np.ptp(target.points, axis=0)[[0, 2]].tolist()
    return _smaller_scale((width, height), size)


def _smaller_scale(asked: tuple[float | None, float | None], sizes: Sequence[float]) -> float:
    """How many times as large a body becomes that shall be so wide or high [m]; InputError for no size."""
    scales = [length / size for length, size in zip(asked, sizes) if length is not None]
    if not all(np.isfinite(scale) and scale > 0.0 for scale in scales):
        raise InputError("The width and the height must be more than 0.")
    return min(scales, default=1.0)


def size_of(source: Source) -> float:
    """The larger dimension of what is wanted [m]: of the drawing, of the body, of the largest panel."""
    if isinstance(source, Outline):
        return max(source.size)
    if isinstance(source, Profile):
        return float(max(2.0 * source.points[:, 0].max(), np.ptp(source.points[:, 1])))
    if isinstance(source, Division):
        return extent(source.target.points)
    return max(extent(panel.outer) for panel in source.panels)


def scaled(source: Source, scale: float) -> Source:
    """The source made larger about the origin."""
    if isinstance(source, Outline):
        return source.map(lambda loop: loop * scale)
    if isinstance(source, Profile):
        return replace(source, points=source.points * scale)
    if isinstance(source, Division):
        return source.scaled(scale)
    panels = [
        replace(panel, outer=panel.outer * scale, holes=tuple(hole * scale for hole in panel.holes))
        for panel in source.panels
    ]
    return replace(source, panels=tuple(panels))
