# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seam of a picked edge, thick on the balloon in the 3D view; and which edge is picked there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.pattern import bag_patterns
from BalloonWorkbench.core.arrangement.seam_vertices import along_edge
from BalloonWorkbench.core.geometry.polyline import extent
from BalloonWorkbench.core.pattern.pieces import PatternPieces
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.bags.panel_display import line_node
from BalloonWorkbench.gui.bags.seam_colours import seam_colour
from BalloonWorkbench.gui.view3d.skin import seam_lines

_WIDTH = 7.0  # px
_NEAR = 0.02  # of the balloon's size: a place that is as near to a seam means it


@dataclass(frozen=True)
class _Seams:
    """A balloon as it was solved.

    middles   (m, 3) mm, of all triangles; panels (m,) of each
    lines     (k, 3) mm, where each seam is by its number
    piece_of  the piece of each panel
    """

    middles: np.ndarray
    panels: np.ndarray
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

    def prepare(self, pieces: PatternPieces) -> None:
        """Read the balloon before anything is picked, so that a pick is answered at once."""
        self._seams(pieces)

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
        size = extent(seams.middles)
        if away.min() <= _NEAR * size:
            seam = owners[int(away.argmin())]
            return next(number for number, edge in enumerate(pieces.edges) if edge.seam == seam), None
        panel = int(seams.panels[np.linalg.norm(seams.middles - place, axis=1).argmin()])
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
    assembly, metres = film_result.shape(pattern.Balloon)
    positions = to_mm(metres)
    middles = positions[assembly.surface.triangles].mean(axis=1)
    panels = np.repeat(np.arange(len(assembly.panels)), [len(panel.triangles) for panel in assembly.panels])
    if has_many_panels(pattern.Balloon):
        lines = {number: positions[line] for number, line in enumerate(seam_lines(assembly), 1)}
        piece_of = {panel: piece for piece, panel in enumerate(bag_patterns(pattern).panels)}
        return _Seams(middles, panels, lines, piece_of)
    (panel,) = assembly.panels
    vertices = {
        edge.seam: along_edge(edge.line, panel.loops, panel.rest_positions)
        for edge in pieces.edges
        if edge.piece == 0
    }
    lower = pattern.Balloon.LowerFilmPoints
    below = np.array([tuple(point) for point in lower]) if lower else positions * (1.0, 1.0, -1.0)
    both = np.concatenate([middles, below[panel.triangles].mean(axis=1)])
    return _Seams(
        both,
        np.repeat([0, 1], len(middles)),
        {seam: positions[each] for seam, each in vertices.items()},
        {0: 0, 1: 1},
    )
