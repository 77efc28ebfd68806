# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives each document object its view provider."""

from __future__ import annotations

from BalloonWorkbench.gui import view
from BalloonWorkbench.gui.window import tree_signs


def _view_of(proxy: str):
    """The view provider of a kind of object; those of other rooms come when they are needed."""
    kind = proxy.replace("Proxy", "View")
    if hasattr(view, kind):
        return getattr(view, kind)
    from BalloonWorkbench.gui import making_view
    from BalloonWorkbench.gui.bags import view as bags_view

    return getattr(making_view, kind, None) or getattr(bags_view, kind)


def attach_view(obj) -> None:
    """Give an object its view provider unless it has one, as after loading a file saved without a window."""
    vobj = obj.ViewObject
    if vobj is None:
        return
    tree_signs.watch_trees()
    if isinstance(vobj.Proxy, view._View):
        vobj.Proxy.restored(vobj)
        return
    _view_of(type(obj.Proxy).__name__)(vobj)
    for each in (obj, obj.getParentGroup()):  # FreeCAD hides what it loads without its looks
        if each is not None:
            each.ViewObject.Visibility = True
    vobj.Proxy.updateData(obj, "Roles")  # colours of lines hold only for lines that are drawn already
