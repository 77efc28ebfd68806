# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Panel objects of patterns of many panels, in a group beside their pattern: one for each piece.

They are made, placed and removed after a recompute: no `execute` touches another object.
"""

from __future__ import annotations

import FreeCAD as App

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.document.parts import panels_of, patterns
from BalloonWorkbench.app.group import free_label, make_group
from BalloonWorkbench.app.panel import PanelProxy

_GROUP = "Panels"  # name and label


class _PatternWatch(Guarded):
    """Told by FreeCAD of each recompute."""

    def slotRecomputedDocument(self, document) -> None:
        for pattern in patterns(document):
            match(pattern)

    def slotRecomputedObject(self, obj) -> None:
        """Of one object by itself; a recompute of the document is waited for."""
        if is_pattern(obj) and not obj.Document.Recomputing:
            for panel in panels_of(obj):
                _compute(panel)
            match(obj)


_watching: list[_PatternWatch] = []


def watch() -> None:
    """Bring the panels in line with their patterns after each recompute from now on."""
    if not _watching:
        _watching.append(_PatternWatch())
        App.addDocumentObserver(_watching[0])


def match(pattern) -> None:
    """One Panel object for each piece of a pattern, in its place and called as it is.

    One that the pattern does not have any more is removed, unless something else in the document uses it.
    A pattern that is not up to date changes nothing.
    """
    if status.is_ready(pattern) and pattern.Pieces and not pattern.PanelNames:
        _compute(pattern)  # of an older document: it does not tell yet which wire is whose
    if not status.is_ready(pattern):
        return
    present, count = panels_of(pattern), len(pattern.PanelNames)
    kept = [panel for panel in present if panel.Number <= count]
    group, shown = _group_of(pattern, present), pattern.Visibility
    for number in sorted({*range(1, count + 1)} - {panel.Number for panel in kept}):
        group = group or _make_group(pattern)
        kept.append(_make(pattern, number, group))
        if not present:
            kept[-1].Visibility, pattern.Visibility = shown, False  # they show it
    remove([panel for panel in present if panel.Number > count and not _users(panel)], group)
    _name(kept)
    for panel in kept:
        if panel.Placement != pattern.Placement:
            panel.Placement = pattern.Placement
        panel.purgeTouched()
    if present and not count:
        pattern.Visibility = True
    for touched in (group, pattern.getParentGroup()):
        if touched is not None and kept:
            touched.purgeTouched()


def remove(panels: list, group=None) -> None:
    """Take panels out of the document, and their group when nothing is left in it."""
    if not panels:
        return
    doc, gone = panels[0].Document, {panel.Name for panel in panels}
    left = [obj for obj in getattr(group, "Group", ()) if obj.Name not in gone]
    for name in gone:
        doc.removeObject(name)
    if group is not None and not left:
        doc.removeObject(group.Name)


def remove_all(pattern) -> None:
    """Take all panels of a pattern out of the document, and their group."""
    panels = panels_of(pattern)
    remove(panels, _group_of(pattern, panels))


def _make(pattern, number: int, group):
    """A new Panel object, computed."""
    obj = pattern.Document.addObject("Part::FeaturePython", "Panel")
    PanelProxy(obj)
    obj.Pattern, obj.Number = pattern, number
    hooks.attach_view(obj)
    group.addObject(obj)
    _compute(obj)
    return obj


def _compute(obj) -> None:
    obj.Proxy.execute(obj)
    obj.purgeTouched()


def _name(panels: list) -> None:
    """Call panels as the pattern calls them, but those that the user has named."""
    own = [panel for panel in panels if not panel.NamedAs or panel.Label == panel.NamedAs]
    others = [panel for panel in own if panel.NamedAs.partition(" (")[0] != panel.PanelName]
    for panel in others:
        panel.Label = panel.Name  # two may change their names with each other
    for panel in others:
        panel.Label = panel.NamedAs = free_label(panel, panel.PanelName)


def _users(panel) -> list:
    """What is made from a panel."""
    return [obj for obj in panel.InList if not obj.isDerivedFrom("App::DocumentObjectGroup")]


def _group_of(pattern, panels: list):
    """The group of panels that a pattern has already; None without one."""
    groups = (panel.getParentGroup() for panel in panels)
    return next((group for group in groups if group not in (None, pattern.getParentGroup())), None)


def _make_group(pattern):
    """A new group for panels, in the one of the balloon."""
    group, above = make_group(pattern.Document, _GROUP), pattern.getParentGroup()
    group.Label = free_label(group, _GROUP)
    if above is not None:
        above.addObject(group)
    return group
