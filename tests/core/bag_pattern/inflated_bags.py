# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarse balloons of the bags of `made_bags`, as they are."""

from __future__ import annotations

from functools import cache

from made_bags import BAGS

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bags.mesh_bag import default_size
from BalloonWorkbench.core.film.library import film

FILM = film("bopp-foil")


@cache
def inflated_bag(name: str, vertices: int = 500) -> BagDesign:
    bag = BAGS[name]
    return inflate_bag(bag, FILM, 1000.0, mesh_size=default_size(bag, vertices))
