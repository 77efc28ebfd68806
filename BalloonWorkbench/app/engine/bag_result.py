# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design of a balloon of many panels in the Balloon object, in full: panels, seams, inflated film."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.properties.property_table import result

PROPERTIES = (
    result("Integer", "PanelCount", "Number of flat panels that it is made of; 0: two equal ones"),
    result("Integer", "SeamCount", "Number of seams between them"),
    result("Length", "Apart", "How far the seams of a body of gores are farther out than the gores' centres"),
    result("String", "FlatPanels", "Flat panels and their seams as JSON, in metres", hidden=True),
    result("String", "DesignText", "What the design of many panels has figures, as JSON", hidden=True),
)
#: Beside its flat panels, of its size, a balloon of a bag as it is has so much room.
_GAP = 0.1


def has_many_panels(balloon) -> bool:
    """The result in a balloon object is one of many panels."""
    return bool(balloon.FlatPanels)


def clear(obj) -> None:
    """Forget the panels of an earlier result: there are two equal ones."""
    obj.PanelCount, obj.SeamCount, obj.Apart = 0, 0, 0.0
    obj.FlatPanels, obj.DesignText = "", ""


def beside_panels(design):
    """The BagDesign with the balloon of a bag as it is behind its flat panels, where it can be seen."""
    from BalloonWorkbench.app.shapes.bag_shapes import moved_beside
    from BalloonWorkbench.core.bags.bag import Bag

    if not isinstance(design.source, Bag):
        return design
    inflation = design.inflation
    shift = moved_beside(inflation.positions, _GAP * design.size)
    return replace(design, inflation=replace(inflation, positions=inflation.positions + shift))


def store(obj, design, film, values: dict) -> None:
    """Write a BagDesign into the object; values: those of its own properties, by name, that led to it."""
    from BalloonWorkbench.app.shapes.bag_shapes import text_of
    from BalloonWorkbench.core.bag_design.source import size_of
    from BalloonWorkbench.core.units import to_mm

    film_result.store(obj, design.inflation, film, values)
    obj.PanelCount, obj.SeamCount = len(design.bag.panels), len(design.bag.seams)
    obj.Apart = to_mm(design.apart)
    obj.FlatPanels = text_of(design.bag)
    obj.DesignText = json.dumps(
        {
            "source_size": size_of(design.source),
            "size": design.size,
            "residual": None if design.residual is None else asdict(design.residual),
            "apart": design.apart,
            "target": None if design.target is None else design.target.tolist(),
            "passes": design.passes,
            "seconds": design.seconds,
            "reached": design.reached,
            "warnings": list(design.warnings),
        }
    )


def stored(obj) -> tuple:
    """The BagDesign kept by `store`, and its Film. InputError where there is none.

    Its mesh cannot be moved with the points of its panels: it has no weights.
    """
    import numpy as np

    from BalloonWorkbench.app.shapes.bag_shapes import bag_from
    from BalloonWorkbench.core.bag_design.bag_design import BagDesign
    from BalloonWorkbench.core.bag_design.source import scaled, size_of
    from BalloonWorkbench.core.bags.mesh_bag import MeshedBag
    from BalloonWorkbench.core.design.design import Residual

    inflation, film = film_result.stored(obj)
    bag, figures = bag_from(obj.FlatPanels), json.loads(obj.DesignText)
    residual, target = figures.pop("residual"), figures.pop("target")
    source, size = _source(obj), figures.pop("source_size")
    return BagDesign(
        scaled(source, size / size_of(source)),  # a goal may have made it larger
        bag,
        MeshedBag(bag, inflation.assembly, (), ()),
        inflation,
        residual=None if residual is None else Residual(**residual),
        target=None if target is None else np.array(target),
        **{**figures, "warnings": tuple(figures["warnings"])},
    ), film


def off_target(obj):
    """Distances (n,) m of the film from the profile or drawing that it was made for; None without such."""
    if not has_many_panels(obj) or is_bag(obj.Outline):
        return None
    from BalloonWorkbench.core.results import off_target as of_design

    return of_design.off_target(stored(obj)[0])


def _source(obj):
    """What the balloon is to be."""
    source = obj.Outline
    if is_gored_body(source):
        from BalloonWorkbench.app.gored_body import profile

        return profile(source)
    if is_bag(source):
        from BalloonWorkbench.app.bag import bag

        return bag(source)
    if is_target(source):
        from BalloonWorkbench.app.target import division

        return division(source)
    from BalloonWorkbench.app.shapes.part_shapes import stored as outline_of

    return outline_of(source, "Loop")
