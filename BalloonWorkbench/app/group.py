# SPDX-License-Identifier: LGPL-2.1-or-later
"""The group of a balloon: Outline, Balloon and Pattern, or those of all shapes of a drawing."""

from __future__ import annotations

from BalloonWorkbench.app import migrate
from BalloonWorkbench.app.properties import add_missing
from BalloonWorkbench.app.stateless import Stateless


class GroupProxy(Stateless):
    """Behaviour of the group (App::DocumentObjectGroupPython): none but its looks."""

    def __init__(self, obj):
        add_missing(obj, (migrate.VERSION,))
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        from BalloonWorkbench.app import hooks

        migrate.bring_up_to_date(obj, ())
        hooks.dress(obj)


def make_group(doc, label: str):
    """A new group."""
    from BalloonWorkbench.app import hooks

    obj = doc.addObject("App::DocumentObjectGroupPython", "BalloonGroup")
    GroupProxy(obj)
    hooks.dress(obj)
    obj.Label = label
    return obj
