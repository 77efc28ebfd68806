# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the objects look in the tree and in the 3D view."""

from __future__ import annotations

from BalloonWorkbench.app.document.proxy import Stateless
from BalloonWorkbench.gui.qt import drawn_icon


class _View(Stateless):
    """What the three view providers have in common."""

    icon = ""

    def __init__(self, vobj):
        vobj.Proxy = self
        self.style(vobj)

    def style(self, vobj):
        """The first look; from then on it is the user's."""

    def attach(self, vobj):
        self.Object = vobj.Object

    def restored(self, vobj):
        """The document is open again: what an older one lacks is added."""

    def onChanged(self, vobj, name):
        """FreeCAD sets what it reads from a file before our objects are up to date: `restored` follows."""
        if not vobj.Object.Document.Restoring:
            self.changed(vobj, name)

    def changed(self, vobj, name):
        """A property of the view provider has changed."""

    def icon_name(self) -> str:
        """The icon in the tree, with a sign where something is wrong."""
        from BalloonWorkbench.gui.window.tree_signs import sign

        return self.icon + sign(self.Object)

    def getIcon(self):
        return drawn_icon(self.icon_name())

    def updateData(self, obj, name):
        if name in ("Status", "Reached"):
            for each in (obj, obj.getParentGroup()):
                if each is not None and each.ViewObject is not None:
                    each.ViewObject.signalChangeIcon()

    def doubleClicked(self, vobj):
        from BalloonWorkbench.gui.panels import edit

        edit(vobj.Object)
        return True


class GroupView(_View):
    """Its members say what is wrong; so does it, when it is closed."""

    icon = "group"


class OutlineView(_View):
    """A thin line."""

    icon = "outline"

    def style(self, vobj):
        vobj.DisplayMode = "Wireframe"
        vobj.LineWidth = 2.0

    def doubleClicked(self, vobj):
        """A painting goes back to the paint window."""
        from BalloonWorkbench.gui.paint.window import paint_again

        return paint_again(vobj.Object) or super().doubleClicked(vobj)


class BalloonView(_View):
    """Film, or what it does as colours."""

    icon = "balloon"

    def style(self, vobj):
        from BalloonWorkbench.gui.view3d.balloon_display import complete, take_look
        from BalloonWorkbench.gui.view3d.film_display import FILM

        complete(vobj)
        vobj.CreaseAngle = 40.0  # in FreeCAD's own modes: smooth panels, a sharp seam
        vobj.DisplayMode = FILM
        take_look(vobj)

    def attach(self, vobj):
        from BalloonWorkbench.gui.view3d.balloon_display import BalloonDisplay

        super().attach(vobj)
        self.display = BalloonDisplay(vobj)

    def restored(self, vobj):
        from BalloonWorkbench.gui.view3d.balloon_display import complete

        complete(vobj)
        self.display.follow()

    def getDisplayModes(self, vobj):
        """Beside FreeCAD's own for meshes."""
        from BalloonWorkbench.gui.view3d.balloon_display import MODES

        return MODES

    def setDisplayMode(self, mode):
        self.display.mode_chosen(mode)
        return mode

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if hasattr(self, "display"):
            self.display.object_changed(name)

    def setupContextMenu(self, vobj, menu):
        from BalloonWorkbench.gui.view3d.balloon_display import fill_menu

        fill_menu(vobj.Object, menu)

    def changed(self, vobj, name):
        if hasattr(self, "display"):
            self.display.view_changed(name)


class PatternView(_View):
    """A sheet with lines in the colours of the cutter's layers."""

    icon = "pattern"

    def style(self, vobj):
        vobj.DisplayMode = "Flat Lines"
        vobj.ShapeColor = (0.85, 0.88, 0.92)
        vobj.Transparency = 40
        vobj.PointSize = 1.0

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Roles":
            obj.ViewObject.LineColorArray = layer_colours(obj)


def layer_colours(obj) -> list:
    """A colour for each edge of a pattern's shape: that of its layer."""
    return [_layer_colour(role) for role, wire in zip(obj.Roles, obj.Shape.Wires) for _ in wire.Edges]


def _layer_colour(role: str) -> tuple[float, ...]:
    """The colour of the layer in the files, from 0 to 1; black for what another release has written."""
    from BalloonWorkbench.core.machines.layers import LAYERS

    rgb = next((layer.rgb for known, layer in LAYERS.items() if known.value == role), "#000000")
    return tuple(int(rgb[i : i + 2], 16) / 255 for i in (1, 3, 5))
