# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proxies that store nothing: the state of a document object is in its properties."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document import arrange, migrate, sources
from BalloonWorkbench.app.properties import expression_units
from BalloonWorkbench.app.properties.property_table import add_missing, offer_choices
from BalloonWorkbench.core.errors import InputError


class Stateless(Guarded):
    """Base of all proxies; FreeCAD asks these methods what to save beside the properties."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # FreeCAD 0.20 asks for these names
    __getstate__ = dumps
    __setstate__ = loads


class DocumentProxy(Stateless):
    """Base of our document objects: gives them their properties, brings older ones up to date."""

    properties = ()

    def __init__(self, obj):
        arrange.watch()
        sources.watch()
        add_missing(obj, (migrate.VERSION, *self.properties))
        offer_choices(obj, self.properties)
        obj.Proxy = self

    def execute(self, obj):
        """FreeCAD asks for the result; whatever goes wrong, the object keeps the one it had and says why."""
        with status.reported(obj, status.has_result(obj)):
            if sources.follows_itself(obj):
                raise InputError(f"{obj.Label} follows itself: choose something that is not made of it.")
            expression_units.check(obj, self.properties)
            self.compute(obj)

    def compute(self, obj):
        """Bring the object up to date with its values."""

    def onDocumentRestored(self, obj):
        from BalloonWorkbench.app.border import hooks

        arrange.watch()
        sources.watch()
        if migrate.bring_up_to_date(obj, self.properties):
            offer_choices(obj, self.properties)
        self.opened(obj)
        hooks.attach_view(obj)

    def opened(self, obj):
        """What an object of an opened document needs besides."""
