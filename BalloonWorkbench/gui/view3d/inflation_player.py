# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflation of a balloon as a film: computed in a worker, shown in place of the balloon."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app.engine import bag_result, film_result
from BalloonWorkbench.app.shapes import bag_shapes, part_shapes
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.assembly import Assembly
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.dynamics.animation import Frame, inflate_in_time
from BalloonWorkbench.core.solver.dynamics.coarser import coarser
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.solver.lift import Lift
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.view3d.film_display import look_of
from BalloonWorkbench.gui.view3d.film_look import FilmLook
from BalloonWorkbench.gui.view3d.skin import Skin, SkinNodes, normals, skin_from

FRAMES = 60
_MOST = 700  # vertices; a finer panel is meshed anew, so that nobody waits long


@dataclass(frozen=True)
class Strip:
    """A balloon on its way from flat to rest."""

    rest: Inflation
    skin: Skin
    frames: tuple[Frame, ...]
    positions: tuple[np.ndarray, ...]
    normals: tuple[np.ndarray, ...]


@dataclass(frozen=True)
class StripRequest:
    """What a worker needs for a Strip, free of the document.

    flat  the seam of two equal panels, or the flat panels of others
    """

    inflation: Inflation
    film: Film
    flat: Outline | Bag

    def solve(self, progress) -> Strip:
        """Raises BalloonError, Cancelled when progress says stop."""
        report = self.inflation.report
        body, start, lift = self._body()
        inflation, frames = inflate_in_time(
            body,
            self.film,
            report.pressure,
            frames=FRAMES,
            model=report.model,
            start=start,
            lift=lift,
            progress=lambda fraction, _text: progress(fraction, "inflating in time"),
        )
        skin = skin_from(inflation, self.film)
        positions = tuple(_all_panels(frame, mirror=inflation.assembly.mirror) for frame in frames)
        return Strip(
            inflation, skin, frames, positions, tuple(normals(places, skin.triangles) for places in positions)
        )

    def _body(self) -> tuple[Panel | Assembly, np.ndarray | None, Lift | None]:
        """What is blown up, where its vertices lie at rest, and its lift."""
        if isinstance(self.flat, Bag):
            coarse = coarser(self.inflation, self.flat, _MOST)
            return coarse.assembly, coarse.places, coarse.lift
        if len(self.inflation.panel.rest_positions) <= _MOST:
            return self.inflation.panel, None, None
        size = math.sqrt(self.flat.area / _MOST * 2.0 / math.sqrt(3.0))
        return triangulate(self.flat, size), None, None


def request_of(obj) -> StripRequest:
    """What to compute for a balloon object. Raises InputError where it is not inflated."""
    inflation, film = film_result.stored(obj)
    many = bag_result.has_many_panels(obj)
    return StripRequest(
        inflation, film, bag_shapes.bag_from(obj.FlatPanels) if many else part_shapes.stored(obj, "Seam")
    )


class Player:
    """Shows frames in place of a balloon; `close` brings it back. No property is changed."""

    def __init__(self, obj, strip: Strip):
        from pivy import coin

        self.strip = strip
        self._vobj = vobj = obj.ViewObject
        self._skin, look = SkinNodes(strip.skin), FilmLook()
        look.show(look_of(obj).kind, vobj.ShapeColor[:3], 1.0 - 0.01 * vobj.Transparency)
        self._node = coin.SoSeparator()
        for before, shape in ((look.film, self._skin.film), (look.seam, self._skin.seam)):
            part = coin.SoSeparator()
            part.addChild(before)
            part.addChild(shape)
            self._node.addChild(part)
        self._child_before = vobj.SwitchNode.whichChild.getValue()
        vobj.SwitchNode.whichChild.setValue(coin.SO_SWITCH_NONE)
        vobj.RootNode.addChild(self._node)

    def show(self, number: int) -> None:
        """Show a frame, counted from 0."""
        self._skin.move(self.strip.positions[number], self.strip.normals[number])

    def close(self) -> None:
        """Show the balloon as it was."""
        self._vobj.RootNode.removeChild(self._node)
        self._vobj.SwitchNode.whichChild.setValue(self._child_before)


def _all_panels(frame: Frame, *, mirror: bool) -> np.ndarray:
    """Positions (n, 3) mm of all film; of two equal panels the upper and then the lower one."""
    if not mirror:
        return to_mm(frame.positions)
    lower = frame.positions * MIRROR if frame.lower is None else frame.lower
    return to_mm(np.concatenate([frame.positions, lower]))
