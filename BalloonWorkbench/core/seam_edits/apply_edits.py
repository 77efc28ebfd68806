# SPDX-License-Identifier: LGPL-2.1-or-later
"""All edits of a division in their order; one whose seam or panels are gone is told and left out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.memoize import memoized
from BalloonWorkbench.core.seam_edits.edit import CUT, LINE, MERGE, MOVE, NEAR, PLANE, SYMMETRY, SeamEdit
from BalloonWorkbench.core.seam_edits.operations import (
    cut,
    cut_at_line,
    cut_at_plane,
    merge,
    move,
    names_at,
    seam_between,
    seam_near,
)
from BalloonWorkbench.core.seam_edits.other_side import REPEATED, Plane, image_of, mirror_plane
from BalloonWorkbench.core.seam_edits.redivide import no_disc, opened_to_discs, panels_not_discs
from BalloonWorkbench.core.targets.symmetry_planes import symmetry_planes
from BalloonWorkbench.core.targets.target import Division, SeamLine
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import place_text


def apply_edits(division: Division, edits: Sequence[SeamEdit]) -> Division:
    """The division after all edits, in their order; what was left out is told in its target's notes.

    Of one without seams, as for 1 panel, the panels are what the seams bound: InputError where one of these
    cannot be laid flat. Panels of others are cut open where they go round the body, and that is told.
    """
    alone, notes = len(division.names) == 1, []
    box = np.ptp(division.target.points, axis=0)
    planes = _planes(division, edits)
    number = 0
    for edit in edits:
        checkpoint()
        number += not edit.source
        name = edit.source or f"Seam edit {number}"
        try:
            division, remarks = with_edit(division, edit.on(box), planes, alone=alone)
            notes += [f"{name}: {remark}" for remark in remarks]
        except InputError as error:
            notes.append(f"{name} is left out. {error}")
    if alone:
        _check_alone(division, notes)
    noted = (*division.target.notes, *notes)
    return replace(division, target=replace(division.target, notes=noted))


def _planes(division: Division, edits: Sequence[SeamEdit]) -> tuple[Plane, ...]:
    """The planes of symmetry of a body, where an edit may be repeated."""
    if not any(edit.mirrored and edit.kind in REPEATED for edit in edits):
        return ()
    return _all_planes(division.target.points, division.target.triangles)


@memoized(4)
def _all_planes(points: Floats, triangles: Ints) -> tuple[Plane, ...]:
    """The planes of symmetry of a surface."""
    return tuple(symmetry_planes(points, triangles))


@memoized(16)
def with_edit(
    division: Division, edit: SeamEdit, planes: Sequence[Plane] | None = None, *, alone: bool = False
) -> tuple[Division, tuple[str, ...]]:
    """The division after one edit, and after its image on the other side; remarks about them.

    planes  of symmetry of the body; None: they are looked for
    alone   all seams are drawn by the user, as on a body without any
    InputError for an edit that cannot be made, and one whose seam or panels are gone.
    """
    alone = alone or len(division.names) == 1
    planes = _planes(division, (edit,)) if planes is None else planes
    plane = mirror_plane(division, planes) if edit.mirrored and edit.kind in REPEATED else None
    image = None if plane is None else image_of(division, edit, plane)
    made, remarks = _with_one(division, edit, alone)
    if image is not None:
        try:
            made, more = _with_one(made, image, alone)
            remarks += more
        except InputError as error:
            remarks += (f"It is not repeated on the other side. {error}",)
    return made, remarks


def _with_one(division: Division, edit: SeamEdit, alone: bool) -> tuple[Division, tuple[str, ...]]:
    made = _EDITS[edit.kind](division, edit, alone)
    return (made, ()) if alone else opened_to_discs(made)


def _check_alone(division: Division, notes: Sequence[str]) -> None:
    """InputError where the seams that the user has drawn make no panels."""
    if not division.seam_edges.any():
        said = f" {notes[0]}" if notes else ""
        raise InputError(f"The body has no seam. Draw seams, or take 2 panels or more.{said}")
    for panel in panels_not_discs(division).tolist():
        raise InputError(no_disc(division, panel))


def _needs(edit: SeamEdit, count: int) -> None:
    if len(edit.points) < count:
        raise InputError("It needs more places: give them all.")


def _the_seam(division: Division, edit: SeamEdit) -> tuple[SeamLine, float]:
    """The seam that an edit is about, and how far along it the place given is, of its length."""
    if not len(edit.points):
        return seam_between(division, edit.panels), 0.5
    seam, at = seam_near(division, edit.points[0])
    names = names_at(division, seam)
    if edit.panels and set(edit.panels) != set(names):
        raise InputError(
            f"The seam near {place_text(edit.points[0])} is one of {' and '.join(names)}, not of"
            f" {' and '.join(edit.panels)}."
        )
    return seam, at


def _merge(division: Division, edit: SeamEdit, alone: bool) -> Division:
    del alone
    return merge(division, _the_seam(division, edit)[0])


def _cut(division: Division, edit: SeamEdit, alone: bool) -> Division:
    _needs(edit, 2)
    return cut(division, edit.points, panels=edit.panels, alone=alone)


def _move(division: Division, edit: SeamEdit, alone: bool) -> Division:
    del alone
    _needs(edit, 2)
    seam, at = _the_seam(division, edit)
    return move(division, seam, at, edit.points[1])


def _plane(division: Division, edit: SeamEdit, alone: bool) -> Division:
    _needs(edit, 1)
    if not np.linalg.norm(edit.direction) > 0.0:
        raise InputError("A plane needs its normal. Give one.")
    return cut_at_plane(division, edit.points[0], edit.direction, alone=alone)


def _symmetry(division: Division, edit: SeamEdit, alone: bool) -> Division:
    """Seams in the planes of symmetry; in a plane that divides nothing any more there are some already."""
    del edit
    target = division.target
    planes = _all_planes(target.points, target.triangles)
    if not planes:
        raise InputError("The body has no plane of symmetry.")
    made = division
    for middle, normal in planes:
        try:
            made = cut_at_plane(made, middle, normal, alone=alone)
        except InputError:
            continue
    if made is division:
        raise InputError("There are seams in the planes of symmetry already.")
    return made


def _line(division: Division, edit: SeamEdit, alone: bool) -> Division:
    return cut_at_line(division, edit.points, edit.direction, near=edit.side == NEAR, alone=alone)


_EDITS: dict[str, Callable[[Division, SeamEdit, bool], Division]] = {
    MERGE: _merge,
    CUT: _cut,
    MOVE: _move,
    PLANE: _plane,
    SYMMETRY: _symmetry,
    LINE: _line,
}
