# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three objects of a balloon: from any of them to all, and to the other balloons of the same drawing."""

from __future__ import annotations

from typing import NamedTuple

from BalloonWorkbench.app.document.kinds import is_balloon, is_panel, is_pattern, is_source, leader


class Parts(NamedTuple):
    """The three objects of one balloon; outline: what it is to be, which may be a body of gores or a bag."""

    outline: object
    balloon: object
    pattern: object


def patterns(doc) -> list:
    """The pattern objects of a document."""
    return [obj for obj in doc.Objects if is_pattern(obj)]


def panels_of(pattern) -> list:
    """The Panel objects of a pattern, by their number."""
    panels = (obj for obj in dict.fromkeys(pattern.InList) if is_panel(obj) and obj.Pattern == pattern)
    return sorted(panels, key=lambda panel: panel.Number)


def parts_of(obj) -> Parts | None:
    """The balloon that an object or group belongs to; None for other objects and incomplete balloons."""
    if obj.isDerivedFrom("App::DocumentObjectGroup"):
        members = (each for each in obj.Group if not each.isDerivedFrom("App::DocumentObjectGroup"))
        return next(filter(None, map(parts_of, members)), None)
    if is_pattern(obj) and obj.Balloon is not None:
        return Parts(obj.Balloon.Outline, obj.Balloon, obj) if obj.Balloon.Outline else None
    if is_panel(obj):
        return parts_of(obj.Pattern) if obj.Pattern is not None else None
    if is_balloon(obj):
        users = [user for user in obj.InList if is_pattern(user) and user.Balloon == obj]
        return parts_of(users[0]) if users else None
    if is_source(obj):
        users = [user for user in obj.InList if is_balloon(user) and user.Outline == obj]
        return parts_of(users[0]) if users else None
    return None


def companions(parts: Parts) -> list[Parts]:
    """The other balloons of the same drawing, by the number of their shape."""
    made = filter(None, map(parts_of, filter(is_pattern, parts.balloon.getParentGroup().Group)))
    others = [each for each in made if leader(each.outline) == parts.outline != each.outline]
    return sorted(others, key=lambda other: other.outline.Part)
