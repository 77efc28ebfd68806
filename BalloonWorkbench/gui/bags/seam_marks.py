# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both edges of a seam, thick in the 3D view: on the flat panels, and where they meet on the balloon."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.gui.bags.bag_edges import BagEdges
from BalloonWorkbench.gui.bags.panel_display import line_node
from BalloonWorkbench.gui.bags.seam_colours import WRONG, seam_colour
from BalloonWorkbench.gui.view3d.skin import skin_of

_WIDTH = 7.0  # px


class SeamMarks:
    """Marks over a Bag object and its balloon; `clear` takes them away."""

    def __init__(self, bag_obj, balloon):
        self._owners = bag_obj, balloon
        self._nodes: list[tuple] = []  # the node of an object in the view, and what was put into it

    def show(self, shown: BagEdges | None, seam: int | None) -> None:
        """Mark a seam; nothing where none is meant."""
        self.clear()
        if shown is None or seam is None or seam >= len(shown.lengths):
            return
        flat, balloon = self._owners
        colour = WRONG if seam in shown.wrong else seam_colour(seam)
        for edge in shown.of_seam(seam):
            self._add(flat, np.column_stack([edge.line, np.zeros(len(edge.line))]), colour)
        skin = skin_of(balloon) if balloon is not None else None
        if skin is not None and len(skin.lines) == len(shown.lengths):
            self._add(balloon, skin.positions[skin.lines[seam]], colour)

    def clear(self) -> None:
        """Take the marks away."""
        for root, node in self._nodes:
            root.removeChild(node)
        self._nodes.clear()

    def _add(self, obj, points: np.ndarray, colour) -> None:
        root, node = obj.ViewObject.RootNode, line_node(points, colour, _WIDTH)
        root.addChild(node)
        self._nodes.append((root, node))
