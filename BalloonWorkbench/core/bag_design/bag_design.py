# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design of a balloon of many panels: flat panels, the balloon, how far it is from what was wanted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bag_design.source import Source
from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
from BalloonWorkbench.core.design.design import Residual
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Bools, Floats


@dataclass(frozen=True)
class BagDesign:
    """A balloon of many panels and what it was made for.

    source      what was wanted: a profile, an outline to be seen between two faces, a divided body, or the
                bag itself
    bag         its panels, flat: what is free film inside the seams
    meshed      their triangles; inflation.assembly is that of meshed
    inflation   the balloon, with the volume up to its open ends; a gored body stands upright (z up, on the
                axis), a letter lies in x and y with its front up, in the drawing's frame
    size        m, the length that errors are told in parts of: the larger side of the drawing, the diagonal
                of the profile's or the body's box; of a bag as it is that of its balloon
    residual    how far from the source the balloon is, None for a bag as it is: between silhouette and
                outline, between the film and the body of revolution or the body, by area
    apart       m, how far seams and centres of gores are apart, at most; 0.0 of others
    target      (k, 2) m, what the residual compares with: profile or outline points; None for a bag as it is
    passes      simulations that it took
    reached     the residual is what was asked for, or what can be reached
    warnings    one sentence each, for the user
    """

    source: Source
    bag: Bag
    meshed: MeshedBag
    inflation: Inflation
    size: float
    residual: Residual | None = None
    apart: float = 0.0
    target: Floats | None = None
    passes: int = 1
    seconds: float = 0.0
    reached: bool = True
    warnings: tuple[str, ...] = ()

    @property
    def film(self) -> Bools:
        """Which vertices (n,) are of panels that are cut, and do not only close an open end."""
        counts = np.diff(self.inflation.assembly.offsets)
        return np.repeat([panel.cut for panel in self.bag.panels], counts)
