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
        "STL, OBJ, PLY, 3MF, STEP, IGES or BREP file of a closed body; a copy travels in the document",
    ),
    Property(
        "Length",
        "Width",
        "Body",
        "Width of a body from a file, along x; 0 follows from the height, or the file",
        label="Width",
    ),
    Property("Length", "Height", "Body", "Height of a body from a file, along z; 0 follows", label="Height"),
    *properties_of(TargetOptions),
    Property(
        "StringList",
        "SeamEdits",
        "Body",
        "How the seams were changed: panels merged, seams cut and moved, one JSON text each",
    ),
    Property(
        "LinkListGlobal",
        "SeamSketches",
        "Body",
        "Sketches whose lines are seams: they are projected onto the body along the normal of their plane",
    ),
    Property("Bool", "NearSide", "Body", "Sketches are projected onto the side that is nearer to them only"),
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
    result(
        "VectorList",
        "TargetFlats",
        "Corners of the triangles on the flat film; z is not 0 where a face does not unroll",
        hidden=True,
        group="Target",
    ),
    result("IntegerList", "TargetBent", "Edges that stand for pieces of curves", hidden=True, group="Target"),
    result("VectorList", "TargetCurves", "Three places on each of these, flat", hidden=True, group="Target"),
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
            made = read(obj)
            show(obj, made)
            if made.seams:
                status.set_status(obj, status.READY)
            else:  # it is shown, so that the first seam can be drawn on it
                status.set_problem(obj, False, "The body has no seam. Draw seams, or take 2 panels or more.")


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
    from BalloonWorkbench.app.drawings.seam_sketches import sketch_edits
    from BalloonWorkbench.app.drawings.solid import division_of
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.seam_edits.apply_edits import apply_edits
    from BalloonWorkbench.core.seam_edits.read_seams import edits_of

    size = metres(obj.Width) or None, metres(obj.Height) or None
    division = division_of(obj.Solid or obj.BodyFile, obj.Panels, *size)
    edits = (*sketch_edits(obj), *edits_of(obj.SeamEdits))
    return apply_edits(division, edits) if edits or obj.Panels != 1 else division


def body(obj):
    """The Target as a whole, before it is divided."""
    from BalloonWorkbench.app.drawings.solid import body_of
    from BalloonWorkbench.app.properties.quantities import metres

    return body_of(obj.Solid or obj.BodyFile, metres(obj.Width) or None, metres(obj.Height) or None)


def division(obj):
    """The Division that the object shows, on the grid of the engine."""
    import numpy as np

    from BalloonWorkbench.core.targets.target import Division, Target
    from BalloonWorkbench.core.units import from_mm

    points = from_mm(_array(obj.TargetPoints))
    triangles = np.array(obj.TargetTriangles, dtype=np.int32).reshape(-1, 3)
    target = Target(points, triangles, obj.Kind, tuple(obj.Notes))
    cuts = np.array(obj.TargetCuts, dtype=np.int32).reshape(-1, 2)
    panels = np.array(obj.TargetPanels, dtype=np.int32)
    return Division(target, panels, tuple(obj.PanelNames), cuts, _flats(obj)).rounded()


def _flats(obj):
    """The FaceFlats that the object keeps, or None."""
    import numpy as np

    from BalloonWorkbench.core.targets.target import FaceFlats
    from BalloonWorkbench.core.units import from_mm

    if not obj.TargetFlats:
        return None
    corners, curves = (_array(points) for points in (obj.TargetFlats, obj.TargetCurves))
    corners[corners[:, 2] != 0.0] = np.nan
    return FaceFlats(
        from_mm(corners[:, :2].reshape(-1, 3, 2)),
        np.array(obj.TargetBent, dtype=np.intp),
        from_mm(curves[:, :2].reshape(-1, 3, 2)),
    )


def _write_flats(output, flats) -> None:
    """Keep FaceFlats, or None, in the object."""
    import FreeCAD as App
    import numpy as np

    from BalloonWorkbench.core.units import to_mm

    def places(points) -> list:
        known = np.isfinite(points).all(axis=1)
        whole = np.column_stack([np.where(known[:, None], to_mm(points), 0.0), np.where(known, 0.0, 1.0)])
        return [App.Vector(*at) for at in whole.tolist()]

    output.TargetFlats = [] if flats is None else places(flats.corners.reshape(-1, 2))
    output.TargetBent = [] if flats is None else flats.bent.tolist()
    output.TargetCurves = [] if flats is None else places(flats.between.reshape(-1, 2))


def _array(points):
    """Vectors as an array (k, 3)."""
    import numpy as np

    return np.array([(at.x, at.y, at.z) for at in points], dtype=float).reshape(-1, 3)


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
        _write_flats(output, made.flats)
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
