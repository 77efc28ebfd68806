# SPDX-License-Identifier: LGPL-2.1-or-later
"""From any object of a balloon to all of them."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import BalloonProxy
from BalloonWorkbench.app.document.create import Parts
from BalloonWorkbench.app.outline import OutlineProxy
from BalloonWorkbench.app.pattern import PatternProxy


def _is(obj, kind) -> bool:
    return isinstance(getattr(obj, "Proxy", None), kind)


def patterns(doc) -> list:
    """The pattern objects of a document."""
    return [obj for obj in doc.Objects if _is(obj, PatternProxy)]


def parts_of(obj) -> Parts | None:
    """The balloon that an object or group belongs to; None for other objects and incomplete balloons."""
    if obj.isDerivedFrom("App::DocumentObjectGroup"):
        found = [
            parts_of(member) for member in obj.Group if not member.isDerivedFrom("App::DocumentObjectGroup")
        ]
        return next((parts for parts in found if parts), None)
    if _is(obj, PatternProxy) and obj.Balloon is not None:
        return Parts(obj.Balloon.Outline, obj.Balloon, obj) if obj.Balloon.Outline else None
    if _is(obj, BalloonProxy):
        users = [user for user in obj.InList if _is(user, PatternProxy) and user.Balloon == obj]
        return parts_of(users[0]) if users else None
    if _is(obj, OutlineProxy):
        users = [user for user in obj.InList if _is(user, BalloonProxy) and user.Outline == obj]
        return parts_of(users[0]) if users else None
    return None
