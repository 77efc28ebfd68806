# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon's view provider can show: film, colour maps, its painting, its panels, the drawing over it.

State is in properties of the view provider: ColourMap chooses a result, and the display mode goes along; when
it is off again, the mode that was before comes back.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.app.host import COLOUR_PROPERTIES, is_replaying
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.results.colour_map import TENSION
from BalloonWorkbench.gui.bags.panel_display import PANELS, PanelDisplay
from BalloonWorkbench.gui.paint.preview.painting_display import MODE as PAINTED
from BalloonWorkbench.gui.paint.preview.painting_display import PaintedFilm
from BalloonWorkbench.gui.qt import QtCore, translate
from BalloonWorkbench.gui.view3d.curves import curve_nodes
from BalloonWorkbench.gui.view3d.film_display import FILM, MAP, FilmDisplay, look_of
from BalloonWorkbench.gui.view3d.film_map import CHOICES
from BalloonWorkbench.gui.view3d.legend_row import OFF, arrange
from BalloonWorkbench.gui.window.borders import undo_step

MODES = [FILM, MAP, PAINTED, PANELS]
#: The result and all that is shown beside it: a change of one of them changes the view.
_RESULTS = ("SolvedFor", "Status", "Mesh", "FilmPoints", "PanelPoints")
_GROUP = "Film Balloon"
_PROPERTIES = (
    (
        "Enumeration",
        "ColourMap",
        QT_TRANSLATE_NOOP("App::Property", "Result that is shown as colours, with a legend"),
    ),
    (
        "Bool",
        "CompareOutlines",
        QT_TRANSLATE_NOOP("App::Property", "Show the drawing and the silhouette over each other"),
    ),
    ("String", "ModeWithoutMap", QT_TRANSLATE_NOOP("App::Property", "Display mode when no map is shown")),
)


def complete(vobj) -> None:
    """Give a view provider those properties that it does not have yet."""
    for kind, name, tooltip in _PROPERTIES:
        if name not in vobj.PropertiesList:
            vobj.addProperty("App::Property" + kind, name, _GROUP, tooltip)
    if vobj.getEnumerationsOfProperty("ColourMap") != CHOICES:
        chosen = vobj.ColourMap if vobj.getEnumerationsOfProperty("ColourMap") else OFF
        vobj.ColourMap = CHOICES
        vobj.ColourMap = chosen if chosen in CHOICES else OFF
    if not vobj.ModeWithoutMap:
        vobj.ModeWithoutMap = FILM
    vobj.setEditorMode("ModeWithoutMap", 2)


class BalloonDisplay:
    """What is shown of one balloon. It follows its object a moment after the last change."""

    def __init__(self, vobj):
        from pivy import coin

        self.vobj = vobj
        self._document, self._name = vobj.Object.Document.Name, vobj.Object.Name
        self._film = FilmDisplay(vobj, self._show_soon)
        self._painted, self._panels = PaintedFilm(vobj), PanelDisplay(vobj)
        self._curves = coin.SoSwitch()
        self._curves.whichChild.setValue(coin.SO_SWITCH_NONE)
        vobj.RootNode.addChild(self._curves)
        self._switching = False
        self._soon = QtCore.QTimer()
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.follow)

    def _show_soon(self) -> None:
        self._soon.start(0)

    def object_changed(self, name: str) -> None:
        """A property of the balloon has changed."""
        if name in _RESULTS:
            self._show_soon()
        elif name in ("Film", "Material") and not is_replaying(self.vobj.Object.Document):
            take_look(self.vobj)

    def view_changed(self, name: str) -> None:
        """A property of the view provider has changed."""
        if name in (*COLOUR_PROPERTIES, "Transparency"):
            self._film.follow_colour(self.vobj)
        elif name in ("CompareOutlines", "Visibility"):
            self._show_soon()
        elif name in ("ColourMap", "DisplayMode") and not self._is_loading() and not self._switching:
            self._switching = True
            try:
                self._couple(name)
            finally:
                self._switching = False
            self._show_soon()

    def mode_chosen(self, mode: str) -> None:
        """FreeCAD is about to show a display mode."""
        if mode in MODES:
            self._show_soon()

    def follow(self) -> None:
        """Show everything as it is now; while the document opens, wait until all its objects are there."""
        if not self._is_there():
            return
        if self.vobj.Object.Document.Restoring:
            self._show_soon()
            return
        mode = self.vobj.DisplayMode
        if mode == PAINTED:
            self._painted.follow(self.vobj.Object)
        elif mode == PANELS:
            self._panels.follow(self.vobj.Object)
        else:
            self._film.follow(self.vobj, mode)
        self._show_curves()
        arrange(self._document)

    def _show_curves(self) -> None:
        from pivy import coin

        self._curves.removeAllChildren()
        self._curves.whichChild.setValue(coin.SO_SWITCH_NONE)
        if not (self.vobj.CompareOutlines and self.vobj.Visibility):
            return
        try:
            for node in curve_nodes(self.vobj.Object):
                self._curves.addChild(node)
        except BalloonError as error:
            hooks.report(error, self.vobj.Object.Label)
        self._curves.whichChild.setValue(coin.SO_SWITCH_ALL)

    def _couple(self, name: str) -> None:
        """Map and display mode go together."""
        vobj = self.vobj
        if name == "ColourMap":
            if vobj.ColourMap == OFF:
                if vobj.DisplayMode == MAP:
                    vobj.DisplayMode = vobj.ModeWithoutMap
            elif vobj.DisplayMode != MAP:
                vobj.ModeWithoutMap = vobj.DisplayMode
                vobj.DisplayMode = MAP
        elif vobj.DisplayMode == MAP and vobj.ColourMap == OFF:
            vobj.ColourMap = TENSION
        elif vobj.DisplayMode != MAP and vobj.ColourMap != OFF:
            vobj.ColourMap = OFF

    def _is_loading(self) -> bool:
        return "ModeWithoutMap" not in self.vobj.PropertiesList or is_replaying(self.vobj.Object.Document)

    def _is_there(self) -> bool:
        """The object may be gone by the time the timer rings, and another one have its name."""
        document = App.listDocuments().get(self._document)
        obj = None if document is None else document.getObject(self._name)
        is_ours = obj is not None and obj.ViewObject is self.vobj
        return is_ours and "ModeWithoutMap" in self.vobj.PropertiesList


def take_look(vobj) -> None:
    """Give a view provider the colour and the transparency of the balloon's film."""
    look = look_of(vobj.Object)
    vobj.ShapeColor = tuple(int(look.colour[place : place + 2], 16) / 255.0 for place in (1, 3, 5))
    vobj.Transparency = round(100.0 * (1.0 - look.opacity))


def fill_menu(obj, menu) -> None:
    """What the context menu of a balloon has beside FreeCAD's own."""
    from BalloonWorkbench.app.balloon import inflate_now
    from BalloonWorkbench.app.document.parts import parts_of
    from BalloonWorkbench.gui.window import macro_recorder

    def inflate(_checked=False):
        with undo_step(obj.Document, translate("Inflate now")):
            inflate_now(obj)
            obj.Document.commitTransaction()
        if parts_of(obj) is not None:
            macro_recorder.call("inflate", f"BalloonWorkbench.parts({macro_recorder.obj(obj)})")

    def run(command: str):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand(f"BalloonWorkbench_{command}")

    menu.addAction(translate("Inflate now")).triggered.connect(inflate)
    if obj.SolvedFor:
        for text, command in (("Colour map", "ColourMap"), ("Animate inflation", "Animate")):
            menu.addAction(translate(text)).triggered.connect(lambda _checked=False, name=command: run(name))
