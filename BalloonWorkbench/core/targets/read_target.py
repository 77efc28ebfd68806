# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed body from a mesh file: STL, OBJ, PLY or 3MF."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.user_file import read_whole
from BalloonWorkbench.core.targets.form import MESHES
from BalloonWorkbench.core.targets.mending.repair import mended, uncrossed
from BalloonWorkbench.core.targets.mesh_files import RawMesh, read_obj, read_stl
from BalloonWorkbench.core.targets.ply import read_ply
from BalloonWorkbench.core.targets.simplify import simplified
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.targets.three_mf import read_3mf
from BalloonWorkbench.core.units import from_mm, length_text, number_text

_READERS = dict(zip(MESHES, (read_stl, read_obj, read_ply, read_3mf), strict=True))
_MOST_BYTES = 400 << 20
#: Of a file without a unit: bodies up to this size, in its unit, are in metres, others in millimetres.
_IN_METRES = 5.0
#: Of more triangles a mesh is made simpler: that changes less than film can follow.
MOST_TRIANGLES = 20_000
#: What is made of film, between these sizes [m].
SMALLEST, LARGEST = 0.01, 100.0


def read_target(path: str | Path, width: float | None = None, height: float | None = None) -> Target:
    """The largest closed body in a mesh file, mended where that is safe.

    width, height  m, along x and z: the body is scaled to one of them, inside both where both are given
    Raises InputError with one sentence for what is no body.
    """
    path = Path(path)
    raw = _READERS[path.suffix.lower().lstrip(".")](read_whole(path, _MOST_BYTES))
    return target_of(raw, path.name, width, height)


def target_of(raw: RawMesh, source: str, width: float | None = None, height: float | None = None) -> Target:
    """The same from a mesh as it was written."""
    body = mended(raw.points, raw.triangles)
    if len(body.triangles) > MOST_TRIANGLES:
        body.notes.append(f"The mesh was made simpler. Its triangles were: {len(body.triangles)}.")
        body.points, body.triangles = simplified(body.points, body.triangles, MOST_TRIANGLES)
    uncrossed(body)
    points, notes = body.points - 0.5 * (body.points.max(axis=0) + body.points.min(axis=0)), body.notes
    size = np.ptp(points, axis=0)
    scales = [asked / own for asked, own in zip((width, height), size[[0, 2]]) if asked is not None]
    if not all(np.isfinite(scale) and scale > 0.0 for scale in scales):
        raise InputError("The width and the height must be more than 0.")
    scale = min(scales, default=0.0) or _unit(raw.unit, float(size.max()), notes)
    largest = float(size.max()) * scale
    if not SMALLEST <= largest <= LARGEST:
        raise InputError(
            f"The body is {length_text(largest)} long. Give a width or a height, so that it is between"
            f" {length_text(SMALLEST)} and {length_text(LARGEST)}."
        )
    return Target(points * scale, body.triangles, source, tuple(notes))


def _unit(unit: float | None, size: float, notes: list[str]) -> float:
    """Metres in a unit of the file."""
    if unit is not None:
        return unit
    if size > _IN_METRES:
        return from_mm(1.0)
    notes.append(
        f"The file does not name its unit: the largest size in it, {number_text(size)}, is taken as metres."
        " Give a width to have another one."
    )
    return 1.0
