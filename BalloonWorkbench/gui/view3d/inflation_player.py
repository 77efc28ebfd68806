# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflation of a balloon as a film: computed in a worker, shown in place of the balloon."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.shapes import part_shapes
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.dynamics.animation import Frame, inflate_in_time
from BalloonWorkbench.core.solver.inflation import MIRROR, Inflation
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.view3d.film_display import look_of
from BalloonWorkbench.gui.view3d.film_look import FilmLook
from BalloonWorkbench.gui.view3d.skin import Skin, SkinNodes, normals, skin_from

FRAMES = 60
_MOST = 700  # vertices; a finer panel is meshed anew, so that nobody waits long


@dataclass(frozen=True)
class Strip:
    """A balloon on its way from the flat panel to rest."""

    skin: Skin
    frames: tuple[Frame, ...]
    positions: tuple[np.ndarray, ...]
    normals: tuple[np.ndarray, ...]


@dataclass(frozen=True)
class StripRequest:
    """What a worker needs for a Strip, free of the document."""

    inflation: Inflation
    film: Film
    seam: Outline

    def solve(self, progress) -> Strip:
        """Raises BalloonError, Cancelled when progress says stop."""
        report = self.inflation.report
        inflation, frames = inflate_in_time(
            self._panel(),
            self.film,
            report.pressure,
            frames=FRAMES,
            model=report.model,
            progress=lambda fraction, _text: progress(fraction, "inflating in time"),
        )
        skin = skin_from(inflation, self.film)
        positions = tuple(_both_panels(frame) for frame in frames)
        return Strip(skin, frames, positions, tuple(normals(places, skin.triangles) for places in positions))

    def _panel(self) -> Panel:
        if len(self.inflation.panel.rest_positions) <= _MOST:
            return self.inflation.panel
        size = math.sqrt(self.seam.area / _MOST * 2.0 / math.sqrt(3.0))
        return triangulate(self.seam, size)


def request_of(obj) -> StripRequest:
    """What to compute for a balloon object. Raises InputError where it is not inflated."""
    inflation, film = film_result.stored(obj)
    return StripRequest(inflation, film, part_shapes.stored(obj, "Seam"))


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


def _both_panels(frame: Frame) -> np.ndarray:
    """Positions (2 n, 3) mm of the upper and the lower film."""
    lower = frame.positions * MIRROR if frame.lower is None else frame.lower
    return to_mm(np.concatenate([frame.positions, lower]))
