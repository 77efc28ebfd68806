# SPDX-License-Identifier: LGPL-2.1-or-later
"""How prints, sheets of film and studies look in the tree and in the 3D view."""

from __future__ import annotations

from BalloonWorkbench.gui.paint.preview.painting_display import MODE
from BalloonWorkbench.gui.view import _layer_colour, _View

#: Resolution of the print in the view [dpi]; more is finer than the screen.
_DPI = 50.0
_NOTHING = "Nothing"  # display mode of what the 3D view does not show
_FILM = (0.45, 0.49, 0.56)


class LinesView(_View):
    """Lines in the colours of the cutter's layers."""

    def style(self, vobj):
        vobj.DisplayMode = "Wireframe"
        vobj.PointSize = 1.0

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name == "Roles" and obj.Shape.Wires:
            obj.ViewObject.LineColorArray = [
                _layer_colour(role) if role else _FILM
                for role, wire in zip(obj.Roles, obj.Shape.Wires)
                for _ in wire.Edges
            ]


class ArtworkView(LinesView):
    """The print, and the lines round it."""

    icon = "artwork"

    def attach(self, vobj):
        from pivy import coin

        super().attach(vobj)
        self.print = coin.SoSeparator()
        vobj.RootNode.addChild(self.print)

    def updateData(self, obj, name):
        super().updateData(obj, name)
        if name in ("Shape", "Status") and hasattr(self, "print"):
            self.show_print(obj)
            balloon = obj.Pattern.Balloon if obj.Pattern else None
            if balloon is not None and hasattr(balloon.ViewObject.Proxy, "display"):
                balloon.ViewObject.Proxy.display.mode_chosen(MODE)

    def restored(self, vobj):
        self.show_print(vobj.Object)

    def changed(self, vobj, name):
        if name == "Visibility" and hasattr(self, "print"):
            self.show_print(vobj.Object)

    def show_print(self, obj):
        """The picture as it is printed, lying behind the lines; nothing where there is none."""
        from BalloonWorkbench.app import artwork
        from BalloonWorkbench.app.border import status
        from BalloonWorkbench.core.errors import BalloonError

        self.print.removeAllChildren()
        if not obj.ViewObject.Visibility or not status.is_ready(obj) or not obj.Pattern:
            return
        try:
            front, back = artwork.sheets(obj, _DPI)
        except BalloonError:
            return
        image = back if obj.Side == artwork.BACK else front
        for node in _plane(image):
            self.print.addChild(node)

    def doubleClicked(self, vobj):
        from BalloonWorkbench.gui.panels import is_free
        from BalloonWorkbench.gui.panels.making.artwork import show_panel

        if is_free():
            show_panel(vobj.Object)
        return True


class FilmSheetView(LinesView):
    """Pieces on their film."""

    icon = "nest"

    def doubleClicked(self, vobj):
        from BalloonWorkbench.gui.panels import is_free
        from BalloonWorkbench.gui.panels.making.nest import show_panel

        if is_free():
            show_panel(vobj.Object)
        return True


class StudyView(_View):
    """A place in the tree, which is grey there for what FreeCAD has no way to show."""

    icon = "study"

    def attach(self, vobj):
        from pivy import coin

        super().attach(vobj)
        vobj.addDisplayMode(coin.SoGroup(), _NOTHING)

    def getDisplayModes(self, vobj):
        return [_NOTHING]

    def getDefaultDisplayMode(self):
        return _NOTHING

    def setDisplayMode(self, mode):
        return mode

    def doubleClicked(self, vobj):
        from BalloonWorkbench.gui.panels import is_free
        from BalloonWorkbench.gui.panels.results.study import show_panel

        if is_free():
            show_panel(vobj.Object)
        return True


def _plane(sheet) -> list:
    """Nodes of a rectangle with the picture of a sheet, a little behind the lines."""
    from pivy import coin

    from BalloonWorkbench.core.units import to_mm

    height, width = sheet.pixels.shape[:2]
    picture = coin.SoTexture2()
    upward = sheet.pixels[::-1].tobytes()
    picture.image.setValue(coin.SbVec2s(width, height), 4, upward)
    light, material = coin.SoLightModel(), coin.SoMaterial()
    light.model = coin.SoLightModel.BASE_COLOR
    material.diffuseColor.setValue(1.0, 1.0, 1.0)
    (x0, y0), (across, up) = to_mm(sheet.origin), map(to_mm, sheet.size)
    x1, y1 = x0 + across, y0 + up
    corners, places, face = coin.SoCoordinate3(), coin.SoTextureCoordinate2(), coin.SoFaceSet()
    corners.point.setValues(0, 4, [(x0, y0, -0.1), (x1, y0, -0.1), (x1, y1, -0.1), (x0, y1, -0.1)])
    places.point.setValues(0, 4, [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    face.numVertices.setValue(4)
    return [light, material, picture, corners, places, face]
