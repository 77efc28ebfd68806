# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Bag object: flat panels and the seams between their edges, from sketches and faces, a file or ready."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.host import is_replaying
from BalloonWorkbench.app.properties import ready_bodies
from BalloonWorkbench.app.properties.property_table import (
    Property,
    is_complete,
    result,
    results,
    show_in_editor,
)

PROPERTIES = (
    Property(
        "LinkSubListGlobal",
        "Panels",
        "Bag",
        "Sketches, wires and flat faces that are the panels, each seen from outside",
    ),
    Property(
        "StringList",
        "Seams",
        "Bag",
        "Edges that are joined, such as Sketch.Edge1=Sketch001.Edge3; edges that faces share need no word",
    ),
    *ready_bodies.PROPERTIES,
    Property(
        "FileIncluded", "PanelFile", "Bag", "JSON file of panels and seams; a copy travels in the document"
    ),
    Property(
        "String",
        "OpeningAt",
        "Bag",
        "Edge at which the bag is filled, such as Sketch.Edge3; of a file or ready body: the panel and the"
        " number of a point, such as side.2, or the number of a seam; empty: as the file or body says",
    ),
    Property("Float", "Ease", "Bag", "How much longer one side of a seam may be, as a part of its length"),
    *arrange.PROPERTIES,
    result("String", "Kind", "What the panels were read from", group="Panels"),
    result("StringList", "PanelNames", "Names of the panels", group="Panels"),
    result("StringList", "SeamNames", "Which edges are joined", group="Panels"),
    result("FloatList", "SeamLengths", "Lengths of both sides of each seam in mm", group="Panels"),
    result("StringList", "Problems", "What does not fit yet, a sentence each", group="Panels"),
    result("StringList", "Notes", "Remarks made while the panels were read", group="Panels"),
    result("String", "Status", "Up to date, or what is wrong", group="Panels"),
    result("StringList", "EdgeNames", "What each edge of the shape is called", hidden=True, group="Panels"),
    result("String", "BagText", "Panels and seams as JSON, in metres", hidden=True, group="Panels"),
)


class BagProxy(DocumentProxy):
    """Behaviour of the Bag object (Part::Part2DObjectPython): its shape is all panels side by side."""

    properties = PROPERTIES

    def __init__(self, obj):
        super().__init__(obj)
        self.follow_source(obj)

    def onChanged(self, obj, name):
        if name in ("Panels", "Ready") and is_complete(obj, PROPERTIES):
            if name == "Ready" and not is_replaying(obj.Document):
                ready_bodies.begin(obj)
            self.follow_source(obj)

    def follow_source(self, obj):
        """Offer only what has an effect."""
        own = not obj.Panels
        show_in_editor(
            obj,
            Seams="hide" if own else "edit",
            Ease="hide" if own else "edit",
            Ready="edit" if own else "hide",
            PanelFile="edit" if own and obj.Ready == ready_bodies.NONE else "hide",
        )
        ready_bodies.follow(obj, own)

    def compute(self, obj):
        has_result = bool(obj.BagText)
        if not has_panels(obj):
            status.set_problem(obj, has_result, "Choose sketches, a file or a ready body.")
            return
        with status.reported(obj, has_result):
            with results(obj) as output:
                problems = show(output, *read(obj))
            if problems:
                status.set_problem(obj, True, problems[0])
            else:
                status.set_status(obj, status.READY)
        obj.positionBySupport()


def has_panels(obj) -> bool:
    """Whether there is anything to read."""
    return bool(obj.Panels or obj.Ready != ready_bodies.NONE or obj.PanelFile)


def set_panels(obj, sources) -> None:
    """Take sketches, wires and faces as the panels: document objects, or pairs of one and names of faces."""
    pairs = [each if isinstance(each, tuple) else (each, ("",)) for each in sources]
    obj.Panels = [
        (source, (elements,) if isinstance(elements, str) else tuple(elements)) for source, elements in pairs
    ]


def set_file(obj, path) -> None:
    """Copy a file into the document, keeping its name; OSError if it cannot be read."""
    import os

    from BalloonWorkbench.app.outline import in_letters

    obj.PanelFile = (os.fspath(path), os.path.basename(in_letters(path)))


def bag(obj):
    """The bag that the object shows, in the core's form."""
    from BalloonWorkbench.app.shapes.bag_shapes import bag_from

    return bag_from(obj.BagText)


def read(obj):
    """The panels with what their edges and seams are called, and what they were read from."""
    if obj.Panels:
        from BalloonWorkbench.app.drawings import panel_sketches

        panels = panel_sketches.drawn_panels(obj.Panels)
        pairs = panel_sketches.joined_pairs(panels, obj.Seams)
        drawn = panel_sketches.bag_of(panels, pairs, obj.OpeningAt, obj.Ease)
        return drawn, [*panel_sketches.unequal(drawn), *panel_sketches.unjoined(panels, pairs)], "sketch"
    from BalloonWorkbench.core.bags.opening import bag_with_opening

    made, kind = _made(obj)
    return _named((bag_with_opening(made, obj.OpeningAt) if obj.OpeningAt else made, kind))


def _made(obj):
    """The bag of a ready body or of a file, and its kind."""
    if obj.Ready != ready_bodies.NONE:
        return ready_bodies.bag(obj), "ready"
    from pathlib import Path

    from BalloonWorkbench.core.bags.read_bag import read_bag
    from BalloonWorkbench.core.outline.budget import Budget
    from BalloonWorkbench.core.readers.vector import read_bytes

    return read_bag(read_bytes(Path(obj.PanelFile)), Budget()), "json"


def _named(made_of):
    """A bag with its edges called by panel and point."""
    import numpy as np

    from BalloonWorkbench.app.drawings.panel_sketches import DrawnBag

    made, kind = made_of
    panels = made.panels
    names = {
        (number, k, at): f"{panel.name}.{at}" if k == 0 else f"{panel.name}.hole {k}.{at}"
        for number, panel in enumerate(panels)
        for k, loop in enumerate(panel.loops)
        for at in range(len(loop))
    }
    texts, lengths = [], []
    for seam in made.seams:
        lengths.append([_length(panels, seam.a, against=False), _length(panels, seam.b, against=True)])
        texts.append("=".join(f"{panels[side.panel].name}.{side.start}-{side.end}" for side in seam.sides))
    return DrawnBag(made, tuple(texts), np.array(lengths).reshape(-1, 2), names), [], kind


def _length(panels, side, *, against: bool) -> float:
    from BalloonWorkbench.core.geometry.polyline import length

    line = panels[side.panel].loops[side.loop][side.points(panels, against=against)]
    return length(line)


def show(obj, drawn, problems, kind: str) -> list[str]:
    """Write a bag into the object; returns what does not fit, a sentence each."""
    from BalloonWorkbench.app.shapes import bag_shapes
    from BalloonWorkbench.core.bags.check_bag import check_bag
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.units import to_mm

    misfits = list(problems)
    if not misfits:
        try:
            check_bag(drawn.bag, opening_needed=False)
        except InputError as error:
            misfits.append(str(error))
    obj.Shape = bag_shapes.panel_shape(drawn.bag)
    obj.EdgeNames = bag_shapes.edge_names(drawn.bag, obj.Shape, drawn.names)
    obj.BagText = bag_shapes.text_of(drawn.bag)
    obj.PanelNames = [panel.name for panel in drawn.bag.panels]
    obj.SeamNames = list(drawn.seams)
    obj.SeamLengths = to_mm(drawn.lengths).ravel().tolist()
    obj.Problems, obj.Notes, obj.Kind = misfits, list(drawn.bag.notes), kind
    return misfits
