# SPDX-License-Identifier: LGPL-2.1-or-later
"""The group of a balloon: what it is made from, Balloon and Pattern, or those of all shapes of a drawing."""

from __future__ import annotations

from BalloonWorkbench.app.document import migrate
from BalloonWorkbench.app.document.proxy import Stateless
from BalloonWorkbench.app.properties.property_table import add_missing


class GroupProxy(Stateless):
    """Behaviour of the group (App::DocumentObjectGroupPython): none but its looks."""

    def __init__(self, obj):
        add_missing(obj, (migrate.VERSION,))
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        from BalloonWorkbench.app.border import hooks

        migrate.bring_up_to_date(obj, ())
        hooks.attach_view(obj)


#: What a balloon is made from.
OUTLINE, GORED_BODY, BAG, TARGET = "Outline", "GoredBody", "Bag", "Target"
#: What its members are called: their labels are theirs.
MEMBERS = (OUTLINE, "Balloon", "Pattern")


def make_group(doc, name: str = "BalloonGroup"):
    """A new group, still without a label of its own."""
    from BalloonWorkbench.app.border import hooks

    obj = doc.addObject("App::DocumentObjectGroupPython", name)
    GroupProxy(obj)
    hooks.attach_view(obj)
    return obj


def name_group(group, label: str) -> None:
    """Call a group by what its balloon is made from: the first one "Fish", the next one "Fish 2"."""
    label = f"{label} drawing" if label in (*MEMBERS, GORED_BODY, BAG, TARGET) else label
    name = free_label(group, label, "{} {}")
    if group.Label != name:
        group.Label = name


def free_label(obj, label: str, numbered: str = "{} ({})") -> str:
    """A label that no other object of the document has: the first one as it is, the next one with a 2."""
    taken = {other.Label for other in obj.Document.Objects if other != obj}
    name, number = label, 1
    while name in taken:
        number += 1
        name = numbered.format(label, number)
    return name
