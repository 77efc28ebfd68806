# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Target object: a closed body that a balloon is to fill, and its panels."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.properties.property_table import (
    Property,
    is_complete,
    properties_of,
    result,
    results,
    show_in_editor,
)
from BalloonWorkbench.core.options.body import TargetOptions

PROPERTIES = (
    Property("LinkGlobal", "Solid", "Body", "Solid or mesh that the balloon is to fill, which it follows"),
    Property(
        "FileIncluded",
        "BodyFile",
        "Body",
        "STL, OBJ, PLY, 3MF or STEP file of a closed body; a copy travels in the document",
    ),
    Property(
        "Length",
        "Width",
        "Body",
        "Width of a mesh from a file, along x; 0 follows from the height, or the file",
        label="Width",
    ),
    Property("Length", "Height", "Body", "Height of a mesh from a file, along z; 0 follows", label="Height"),
    *properties_of(TargetOptions),
    *arrange.PROPERTIES,
    result("Integer", "PanelCount", "Number of panels", group="Target"),
    result("Length", "SeamLength", "Length of all seams on the body", group="Target"),
    result("Volume", "BodyVolume", "Volume of the body", group="Target"),
    result("Vector", "BodySize", "Size of the body along x, y and z", group="Target"),
    result("StringList", "PanelNames", "Names of the panels", group="Target"),
    result("String", "Kind", "What the body was read from", group="Target"),
    result("StringList", "Notes", "Remarks made while the body was read", group="Target"),
    result("String", "Status", "Up to date, or what is wrong", group="Target"),
    result("VectorList", "TargetPoints", "Points of the body's triangles", hidden=True, group="Target"),
    result("IntegerList", "TargetTriangles", "Three points of each triangle", hidden=True, group="Target"),
    result("IntegerList", "TargetPanels", "Panel of each triangle", hidden=True, group="Target"),
    result(
        "IntegerList",
        "TargetCuts",
        "Two points of each edge at which a panel is cut open",
        hidden=True,
        group="Target",
    ),
)


class TargetProxy(DocumentProxy):
    """Behaviour of the Target object (Part::FeaturePython): its shape is the seams on the body."""

    properties = PROPERTIES

    def __init__(self, obj):
        super().__init__(obj)
        self.follow_source(obj)

    def onChanged(self, obj, name):
        if name == "Solid" and is_complete(obj, PROPERTIES):
            self.follow_source(obj)

    def follow_source(self, obj):
        """Offer only what has an effect."""
        show_in_editor(obj, **dict.fromkeys(("BodyFile", "Width", "Height"), "hide" if obj.Solid else "edit"))

    def compute(self, obj):
        has_result = bool(obj.TargetPoints)
        if not has_body(obj):
            status.set_problem(obj, has_result, "Choose a solid, a mesh or a file with one.")
            return
        with status.reported(obj, has_result):
            show(obj, read(obj))
            status.set_status(obj, status.READY)


def has_body(obj) -> bool:
    """Whether there is anything to read."""
    return bool(obj.Solid or obj.BodyFile)


def set_body(obj, path) -> None:
    """Copy a file into the document as the body, keeping its name; OSError if it cannot be read."""
    import os

    from BalloonWorkbench.app.outline import in_letters

    obj.BodyFile = (os.fspath(path), os.path.basename(in_letters(path)))


def read(obj):
    """The Division of the solid, the mesh or the file."""
    from BalloonWorkbench.app.drawings.solid import division_of
    from BalloonWorkbench.app.properties.quantities import metres

    size = metres(obj.Width) or None, metres(obj.Height) or None
    return division_of(obj.Solid or obj.BodyFile, obj.Panels, *size)


def division(obj):
    """The Division that the object shows, on the grid of the engine."""
    import numpy as np

    from BalloonWorkbench.core.targets.target import Division, Target
    from BalloonWorkbench.core.units import from_mm

    points = from_mm(np.array([(at.x, at.y, at.z) for at in obj.TargetPoints], dtype=float).reshape(-1, 3))
    triangles = np.array(obj.TargetTriangles, dtype=np.int32).reshape(-1, 3)
    target = Target(np.round(points, 9) + 0.0, triangles, obj.Kind, tuple(obj.Notes))
    cuts = np.array(obj.TargetCuts, dtype=np.int32).reshape(-1, 2)
    return Division(target, np.array(obj.TargetPanels, dtype=np.int32), tuple(obj.PanelNames), cuts)


def show(obj, made) -> None:
    """Write a Division into the object: its seams as lines on the body."""
    import FreeCAD as App
    import numpy as np
    import Part

    from BalloonWorkbench.app.properties.quantities import cubic_millimetres
    from BalloonWorkbench.core.geometry.polyline import length
    from BalloonWorkbench.core.units import to_mm

    target = made.target
    places = [App.Vector(*at) for at in to_mm(target.points).tolist()]
    lines = [[places[vertex] for vertex in seam.vertices.tolist()] for seam in made.seams]
    with results(obj) as output:
        output.Shape = Part.Compound([Part.makePolygon(line) for line in lines])
        output.TargetPoints = places
        output.TargetTriangles = target.triangles.ravel().tolist()
        output.TargetPanels = made.panels.tolist()
        output.TargetCuts = made.cuts.ravel().tolist()
        output.BodySize = App.Vector(*to_mm(np.ptp(target.points, axis=0)).tolist())
        output.PanelNames = list(made.names)
        output.PanelCount = len(made.names)
        output.SeamLength = to_mm(sum(length(target.points[seam.vertices]) for seam in made.seams))
        output.BodyVolume = cubic_millimetres(target.volume)
        output.Kind = _kind(obj)
        output.Notes = list(target.notes)


def _kind(obj) -> str:
    """What the body was read from."""
    if not obj.Solid:
        return obj.BodyFile.rpartition(".")[2].lower()
    return "mesh" if hasattr(obj.Solid, "Mesh") else "solid"
