# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edits of an outline by hand: kept in the Outline that has the drawing, applied to whatever is traced.

Places are in mm in the frame of the drawing.
"""

from __future__ import annotations

from BalloonWorkbench.app.document.kinds import is_outline, leader
from BalloonWorkbench.core.errors import InputError


def editable(obj):
    """The Outline that has the drawing of an outline, for its edits. InputError for other objects."""
    if not is_outline(obj):
        raise InputError(f"{obj.Label} has no outline to edit: choose a balloon from a picture.")
    first = leader(obj)
    if first.Source:
        raise InputError(f"{first.Label} follows {first.Source[0].Label}: edit that.")
    if not first.Drawing:
        raise InputError(f"{first.Label} has no drawing yet: choose a picture.")
    return first


def edit(obj, do: str, at, to=None, mirrored: bool = False) -> None:
    """Do something to the node nearest to a place (2,) mm of an outline, see core/outline_edits/edit.py;
    nothing is computed. InputError, OutlineError where the outline would cross itself; it stays as it was.
    """
    import numpy as np

    from BalloonWorkbench.app.outline import read_plain
    from BalloonWorkbench.core.outline_edits.apply_edits import EditFrame, appended, apply_edits, node_edit
    from BalloonWorkbench.core.outline_edits.edit import KINDS, MOVE, edit_text, edits_of
    from BalloonWorkbench.core.units import from_mm

    if do not in KINDS:
        raise InputError(f'An outline cannot be edited by "{do}": choose one of {", ".join(KINDS)}.')
    if (to is None) == (do == MOVE):
        raise InputError("A node that moves needs a place to move to; nothing else does.")
    first = editable(obj)
    (drawing, _kind), edits = read_plain(first), edits_of(first.OutlineEdits)
    before = apply_edits(drawing, edits)
    places = [None if place is None else from_mm(np.array(place, dtype=float)) for place in (at, to)]
    made = EditFrame.of(drawing).kept(node_edit(before.nodes, do, *places, mirrored=mirrored))
    after = appended(edits, made)
    refused = apply_edits(drawing, after).left_out[len(before.left_out) :]
    if refused:
        raise InputError(refused[-1])
    first.OutlineEdits = [edit_text(each) for each in after]
