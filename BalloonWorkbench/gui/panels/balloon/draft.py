# SPDX-License-Identifier: LGPL-2.1-or-later
"""The draft of a new balloon in the 3D view: about what it will look like, until the engine has found it."""

from __future__ import annotations

from dataclasses import dataclass

import FreeCADGui as Gui

from BalloonWorkbench.core.design.draft import Draft, draft
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results.stl import balloon_mesh
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.qt import QtCore
from BalloonWorkbench.gui.view3d.film_display import look_of
from BalloonWorkbench.gui.view3d.film_look import FilmLook
from BalloonWorkbench.gui.view3d.fit_view import view_of
from BalloonWorkbench.gui.view3d.skin import Skin, SkinNodes, normals


@dataclass(frozen=True)
class _DraftRequest:
    """What a draft is made from; pressure in Pa."""

    outline: Outline
    film: Film
    pressure: float

    def solve(self, progress) -> Draft:
        """Raises what `draft` raises."""
        return draft(self.outline, self.film, self.pressure, progress=progress)


class DraftView(QtCore.QObject):
    """Draws the drafts of a balloon in a thread, and shows the last one; `drawn` carries it."""

    drawn = QtCore.Signal(object)

    def __init__(self, parts, parent):
        super().__init__(parent)
        self._parts = parts
        self._document = parts.balloon.Document.Name
        self._worker: Worker | None = None
        self._root = self._node = None

    def begin(self, request) -> None:
        """Draw what a request of the document will give, as far as a draft can tell."""
        self._stop()
        settings = request.settings
        if not settings.correct or settings.goal is not None:
            return  # as drawn it is there as soon; and nobody knows its size yet
        asked = _DraftRequest(request.source.outline, settings.film, settings.pressure)
        self._worker = Worker(asked, self)
        self._worker.ended.connect(self._show)
        self._worker.start()

    def clear(self) -> None:
        """Take it away: the balloon is there, or will not come."""
        self._stop()
        if self._node is not None and self._gui_document() is not None:
            self._root.removeChild(self._node)
        self._root = self._node = None

    def _stop(self) -> None:
        if self._worker is not None:
            self._worker.abandon()
            self._worker = None

    def _gui_document(self):
        """None while it is being closed."""
        try:
            return Gui.getDocument(self._document)
        except NameError:
            return None

    def _show(self) -> None:
        worker, self._worker = self._worker, None
        view = view_of(self._gui_document())
        if worker is None or worker.design is None or view is None:
            return  # the engine will say why there is no balloon
        self.clear()
        self._root, self._node = view.getSceneGraph(), self._nodes(worker.design)
        self._root.addChild(self._node)
        self.drawn.emit(worker.design)

    def _nodes(self, drafted: Draft):
        from pivy import coin

        positions, triangles = balloon_mesh(drafted.inflation)
        shape = SkinNodes(Skin(to_mm(positions), triangles, normals(positions, triangles)))
        film, look = FilmLook(), look_of(self._parts.balloon)
        colour = tuple(int(look.colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
        film.show(look.kind, colour, look.opacity)
        node, style, place = coin.SoSeparator(), coin.SoPickStyle(), coin.SoTransform()
        style.style.setValue(coin.SoPickStyle.UNPICKABLE)
        at = self._parts.outline.getGlobalPlacement()
        place.translation.setValue(*at.Base)
        place.rotation.setValue(*at.Rotation.Q)
        for child in (style, place, film.film, shape.film):
            node.addChild(child)
        return node
