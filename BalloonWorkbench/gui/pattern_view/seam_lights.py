# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam of a picked edge, thick on the balloon in the 3D view; and which edge is picked there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.pattern import bag_patterns
from BalloonWorkbench.core.arrangement.seam_vertices import along_edge
from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.gui.bags.panel_display import line_node
from BalloonWorkbench.gui.bags.seam_colours import seam_colour
from BalloonWorkbench.gui.view3d.skin import Skin, skin_from

_WIDTH = 7.0  # px
_NEAR = 0.02  # of the balloon's size: a place that is as near to a seam means it


@dataclass(frozen=True)
class _Seams:
    """A balloon as it was solved: its film, the line (k, 3) mm of each seam by its number, and the piece of
    each of its panels."""

    skin: Skin
    lines: dict[int, np.ndarray]
    piece_of: dict[int, int]


class SeamLights:
    """Of the balloon of a Pattern object; `clear` takes the light away."""

    def __init__(self, pattern_obj):
        self._pattern = pattern_obj
        self._known: tuple = (None, None)  # what the seams belong to, and they
        self._shown: tuple | None = None  # the node of the balloon, and what was put into it

    def show(self, pieces: PatternPieces, edge: int) -> None:
        """Light the place of an edge of the pieces, as the pattern lays them; nothing without a result."""
        self.clear()
        seams, seam = self._seams(pieces), pieces.edges[edge].seam
        if seams is None or seam not in seams.lines:
            return
        root = self._pattern.Balloon.ViewObject.RootNode
        self._shown = root, line_node(seams.lines[seam], seam_colour(seam - 1), _WIDTH)
        root.addChild(self._shown[1])

    def clear(self) -> None:
        """Take the light away."""
        if self._shown is not None:
            root, node = self._shown
            root.removeChild(node)
            self._shown = None

    def meant(self, pieces: PatternPieces, place: np.ndarray) -> tuple[int | None, int | None]:
        """The edge that is meant at a place (3,) mm of the balloon, else the piece; None each for none."""
        seams = self._seams(pieces)
        if seams is None:
            return None, None
        owners = [number for number, line in seams.lines.items() for _ in line]
        away = np.linalg.norm(np.concatenate([*seams.lines.values()]) - place, axis=1)
        size = float(np.ptp(seams.skin.positions, axis=0).max())
        if away.min() <= _NEAR * size:
            seam = owners[int(away.argmin())]
            return next(number for number, edge in enumerate(pieces.edges) if edge.seam == seam), None
        if seams.skin.panels is None:
            return None, None
        middles = seams.skin.positions[seams.skin.triangles].mean(axis=1)
        panel = int(seams.skin.panels[np.linalg.norm(middles - place, axis=1).argmin()])
        return None, seams.piece_of.get(panel)

    def _seams(self, pieces: PatternPieces) -> _Seams | None:
        balloon = self._pattern.Balloon
        if balloon is None or balloon.ViewObject is None or not film_result.is_known(balloon):
            return None
        key = (balloon.Name, balloon.SolvedFor, pieces)
        if self._known[0] is None or not _same(key, self._known[0]):
            self._known = key, _seams_of(self._pattern, pieces)
        return self._known[1]


def _same(one: tuple, other: tuple) -> bool:
    return one[:2] == other[:2] and one[2] is other[2]


def _seams_of(pattern, pieces: PatternPieces) -> _Seams:
    inflation, film = film_result.stored(pattern.Balloon)
    skin = skin_from(inflation, film)
    if has_many_panels(pattern.Balloon):
        lines = {number: skin.positions[line] for number, line in enumerate(skin.lines, 1)}
        return _Seams(skin, lines, {panel: piece for piece, panel in enumerate(bag_patterns(pattern).panels)})
    panel = inflation.panel
    front = [edge for edge in pieces.edges if edge.piece == 0]
    vertices = {edge.seam: along_edge(edge.line, panel.loops, panel.rest_positions) for edge in front}
    return _Seams(skin, {seam: skin.positions[each] for seam, each in vertices.items()}, {0: 0, 1: 1})
