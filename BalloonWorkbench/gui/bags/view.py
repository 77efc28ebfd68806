# SPDX-License-Identifier: LGPL-2.1-or-later
"""How bodies of gores and bags of panels look in the tree and in the 3D view."""

from __future__ import annotations

from BalloonWorkbench.gui.bags.seam_colours import FREE, WRONG, panel_tint, seam_colour
from BalloonWorkbench.gui.view import OutlineView, _View, layer_colours


class GoredBodyView(OutlineView):
    """A thin line: the section through the body."""

    icon = "gored_body"

    def doubleClicked(self, vobj):
        return _View.doubleClicked(self, vobj)


class TargetView(_View):
    """Lines: the seams on the body, in the colours and with the numbers of those of the pattern."""

    icon = "target"

    def style(self, vobj):
        vobj.LineWidth = 3.0
        vobj.PointSize = 1.0

    def attach(self, vobj):
        from BalloonWorkbench.gui.bags.target_display import TargetDisplay

        super().attach(vobj)
        self.display = TargetDisplay(vobj)

    def restored(self, vobj):
        self.display.follow()

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Notes" and hasattr(self, "display"):  # the last of a division that is written
            self.display.follow()

    def changed(self, vobj, name):
        if name == "Visibility" and hasattr(self, "display"):
            self.display.follow_visibility()


class PanelView(_View):
    """A piece of film in the tint of its panel, with lines in the colours of the cutter's layers."""

    icon = "pattern"

    def style(self, vobj):
        vobj.DisplayMode = "Flat Lines"
        vobj.ShapeColor = panel_tint(vobj.Object.Number - 1)
        vobj.Transparency = 40
        vobj.PointSize = 1.0
        if vobj.Object.Pattern is not None:
            vobj.Object.Pattern.Visibility = False  # its panels show it

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Roles":
            obj.ViewObject.LineColorArray = layer_colours(obj)


class BagView(_View):
    """Flat panels, each in its tint, each seam in its colour on both edges."""

    icon = "bag"

    def style(self, vobj):
        vobj.DisplayMode = "Flat Lines"
        vobj.LineWidth = 3.0
        vobj.PointSize = 1.0

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name in ("BagText", "Problems", "Roles"):
            self.colour(obj)

    def restored(self, vobj):
        self.colour(vobj.Object)

    def colour(self, obj):
        """The colours of faces and edges, in the order in which the shape has them."""
        from BalloonWorkbench.gui.bags.bag_edges import edge_seams, edges_of

        shown = edges_of(obj)
        if shown is None or not obj.Shape.Edges:
            return
        obj.ViewObject.DiffuseColor = [(*panel_tint(number), 0.0) for number in range(len(shown.loops))]
        obj.ViewObject.LineColorArray = [
            FREE if seam is None else WRONG if seam in shown.wrong else seam_colour(seam)
            for seam in edge_seams(obj, shown)
        ]
