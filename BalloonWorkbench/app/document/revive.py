# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose behaviour was lost are given it again.

A FreeCAD without this workbench opens and saves our documents with all their shapes and values, but forgets
which class an object belongs to. The values tell.
"""

from __future__ import annotations

from importlib import import_module

import FreeCAD as App

from BalloonWorkbench.app.border.guard import Guarded

#: By a property that no other kind has: module and class.
_KINDS = {
    "KeepAspect": ("outline", "OutlineProxy"),
    "UpperCap": ("gored_body", "GoredBodyProxy"),
    "SeamLengths": ("bag", "BagProxy"),
    "TargetPanels": ("target", "TargetProxy"),
    "SolvedFor": ("balloon", "BalloonProxy"),
    "IntakeKind": ("pattern", "PatternProxy"),
    "PanelName": ("panel", "PanelProxy"),
    "Bleed": ("artwork", "ArtworkProxy"),
    "LaidOutFor": ("film_sheet", "FilmSheetProxy"),
    "Failed": ("studies.study", "StudyProxy"),
}
_GROUP = ("group", "GroupProxy")


class _OpenedWatch(Guarded):
    """Told by FreeCAD of each document that was opened."""

    def slotActivateDocument(self, document) -> None:
        if not document.Restoring:
            revive(document)


def watch() -> None:
    """Revive the objects of every document that is opened from now on."""
    App.addDocumentObserver(_OpenedWatch())


def revive(document) -> None:
    """Give objects of ours without a class the one that their values speak of."""
    lost = {obj: kind for obj in document.Objects if (kind := _kind(obj))}
    groups = {group for obj in lost for group in [obj.getParentGroup()] if group is not None}
    lost |= {group: _GROUP for group in groups if _is_lost(group)}
    for obj, (module, name) in lost.items():
        proxy = object.__new__(getattr(import_module(f"BalloonWorkbench.app.{module}"), name))
        obj.Proxy = proxy
        proxy.onDocumentRestored(obj)


def _is_lost(obj) -> bool:
    return "SchemaVersion" in obj.PropertiesList and "Proxy" in obj.PropertiesList and obj.Proxy is None


def _kind(obj) -> tuple[str, str] | None:
    if not _is_lost(obj):
        return None
    return next((kind for name, kind in _KINDS.items() if name in obj.PropertiesList), None)
