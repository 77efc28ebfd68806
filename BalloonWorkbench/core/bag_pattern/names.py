# SPDX-License-Identifier: LGPL-2.1-or-later
"""The name of a panel on its film, as large as there is room."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.core.errors import InputError, MissingPackageError
from BalloonWorkbench.core.pattern.label import with_label
from BalloonWorkbench.core.pattern.pattern import Pattern, Role

#: Heights that are tried, of the one that is wanted.
_SHARES = (1.0, 0.6, 0.35)


def named(pattern: Pattern, label: str, name: str, piece: str, height: float) -> Pattern:
    """The pattern with the user's label, its name and which piece it is, such as 3/8.

    height  of capital letters [m]; lower where there is no room, and then without the name
    """
    inside = tuple(contour for contour in pattern.contours if contour.role is not Role.NOTCH)
    outside = tuple(contour for contour in pattern.contours if contour.role is Role.NOTCH)
    bare = replace(pattern, contours=inside)
    for text in (" ".join(filter(None, (label, name, piece))), piece):
        for share in _SHARES:
            try:
                labelled = with_label(bare, text, share * height)
                return replace(labelled, contours=(*outside, *labelled.contours))
            except InputError:
                continue
            except MissingPackageError as error:
                return replace(pattern, warnings=(*pattern.warnings, f"The panels have no names. {error}"))
    said = f"Panel {name} has no room for its name: write it beside the cut when you lay it out."
    return replace(pattern, warnings=(*pattern.warnings, said))
