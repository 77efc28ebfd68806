# SPDX-License-Identifier: LGPL-2.1-or-later
"""The display modes of a balloon that the workbench adds to FreeCAD's own: as film, as a colour map."""

from __future__ import annotations

from collections.abc import Callable

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.app.engine import film_result, maker
from BalloonWorkbench.core.errors import BalloonError, ProgramFault
from BalloonWorkbench.core.film.film import Look
from BalloonWorkbench.core.results.colour_map import TENSION
from BalloonWorkbench.gui.long_work.call import Call
from BalloonWorkbench.gui.long_work.latest import LatestWork
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.view3d.film_look import FilmLook
from BalloonWorkbench.gui.view3d.film_map import map_nodes
from BalloonWorkbench.gui.view3d.legend_row import OFF
from BalloonWorkbench.gui.view3d.skin import SkinNodes, skin_of

FILM, MAP = "Film", "Colour map"


class FilmDisplay:
    """Nodes of the modes FILM and MAP; they are made when they are looked at.

    changed  is called when there is more to show than before
    """

    def __init__(self, vobj, changed: Callable[[], None]):
        from pivy import coin

        self._changed = changed
        self._safety = LatestWork(self._worked_out)
        self._film, self._map = coin.SoGroup(), coin.SoGroup()
        self._look = FilmLook()
        for node, mode in ((self._film, FILM), (self._map, MAP)):
            vobj.addDisplayMode(_selectable(coin, vobj.Object, node), mode)

    def follow(self, vobj, mode: str) -> None:
        """Show the balloon as it is now in a mode."""
        self._safety.leave()
        if mode == FILM:
            self._film.removeAllChildren()
            self.follow_colour(vobj)
            self._show_film(vobj.Object)
        elif mode == MAP:
            self._map.removeAllChildren()
            self._show_map(vobj)

    def follow_colour(self, vobj) -> None:
        """Take the colour and the transparency of the view provider, and the kind of film."""
        self._look.show(look_of(vobj.Object).kind, vobj.ShapeColor[:3], 1.0 - 0.01 * vobj.Transparency)

    def _show_film(self, obj) -> None:
        from pivy import coin

        skin = skin_of(obj)
        if skin is None:
            return
        nodes = SkinNodes(skin)
        for look, shape in ((self._look.film, nodes.film), (self._look.seam, nodes.seam)):
            part = coin.SoSeparator()
            part.addChild(look)
            part.addChild(shape)
            self._film.addChild(part)

    def _show_map(self, vobj) -> None:
        if vobj.ColourMap == OFF:
            return
        try:
            for node in map_nodes(vobj.Object, vobj.ColourMap):
                self._map.addChild(node)
            if vobj.ColourMap == TENSION and film_result.is_known(vobj.Object):
                self._work_out_safety(vobj.Object)
        except BalloonError as error:
            hooks.report(error, vobj.Object.Label)

    def _work_out_safety(self, obj) -> None:
        """What the film can bear, which takes many seconds for many panels, once for each result."""
        if not maker.is_safety_known(obj):
            self._safety.ask(Call(maker.working_out_safety(obj)))

    def _worked_out(self, worker: Worker) -> None:
        if worker.error is None:
            self._changed()
        elif not isinstance(worker.error, ProgramFault):
            hooks.report(worker.error)


def look_of(obj) -> Look:
    """The look of a balloon's film as it is chosen now."""
    from BalloonWorkbench.app.properties.film import read

    try:
        return read(obj).look
    except BalloonError:  # numbers that no film can have
        return Look()


def _selectable(coin, obj, node):
    """A node that FreeCAD highlights when it is pointed at or selected."""
    wrapped = coin.SoType.fromName("SoFCSelection").createInstance()
    wrapped.documentName.setValue(obj.Document.Name)
    wrapped.objectName.setValue(obj.Name)
    wrapped.subElementName.setValue("")
    wrapped.addChild(node)
    return wrapped
