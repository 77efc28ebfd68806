# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GoredBody object: a body of revolution that is to be made of gores, from a sketch, a file or ready."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.properties.property_table import (
    Property,
    is_complete,
    options_from,
    properties_of,
    result,
    results,
    show_in_editor,
)
from BalloonWorkbench.core.options.body import ACCURACY, BodyOptions

#: What the profile comes from where it does not follow a sketch.
FROM_FILE, NATURAL_SHAPE = "File", "Natural shape"

PROPERTIES = (
    Property(
        "LinkSubGlobal", "Source", "Profile", "Sketch or wire of half the outline, which the body follows"
    ),
    Property(
        "Enumeration",
        "ProfileFrom",
        "Profile",
        "Where the profile comes from without a sketch: a file, or the shape of a balloon without weight",
        label="Profile",
        entries=lambda: (FROM_FILE, NATURAL_SHAPE),
    ),
    Property(
        "FileIncluded",
        "ProfileFile",
        "Profile",
        "SVG, DXF or JSON file of half the outline; a copy travels in the document",
    ),
    Property(
        "Length",
        "Width",
        "Profile",
        "Diameter of a body from a file; 0 follows from the height, or the file",
        label="Width",
    ),
    Property("Length", "Height", "Profile", "Height of a body from a file; 0 follows", label="Height"),
    Property(
        "Length",
        "GoreLength",
        "Profile",
        "Length of the natural shape's gores, from its lower to its upper end",
        1000.0,
        label="Length of a gore",
    ),
    *properties_of(BodyOptions),
    *arrange.PROPERTIES,
    arrange.FROM_SKETCH,
    result(
        "Integer", "GoresNeeded", "Gores that the accuracy needs, foretold from the profile", group="Body"
    ),
    result("Length", "BodyDiameter", "Largest diameter of the profile", group="Body"),
    result("Length", "BodyHeight", "Height of the profile", group="Body"),
    result("Length", "MeridianLength", "Length of the profile from end to end", group="Body"),
    result("String", "Kind", "What the profile was read from", group="Body"),
    result("StringList", "Notes", "Remarks made while the profile was read", group="Body"),
    result("String", "Status", "Up to date, or what is wrong", group="Body"),
    result(
        "VectorList", "ProfilePoints", "Points of the profile: radius, 0, height", hidden=True, group="Body"
    ),
    result(
        "StringList", "ProfileEnds", "How its lower and its upper end are closed", hidden=True, group="Body"
    ),
)


class GoredBodyProxy(DocumentProxy):
    """Behaviour of the GoredBody object (Part::FeaturePython): its shape is the section through the body."""

    properties = PROPERTIES

    def __init__(self, obj):
        super().__init__(obj)
        self.follow_source(obj)

    def onChanged(self, obj, name):
        if name in ("Source", "ProfileFrom") and is_complete(obj, PROPERTIES):
            self.follow_source(obj)

    def follow_source(self, obj):
        """Offer only what has an effect."""
        own = not obj.Source
        of_file = "edit" if own and obj.ProfileFrom == FROM_FILE else "hide"
        show_in_editor(
            obj,
            ProfileFrom="edit" if own else "hide",
            **dict.fromkeys(("ProfileFile", "Width", "Height"), of_file),
            GoreLength="edit" if own and obj.ProfileFrom == NATURAL_SHAPE else "hide",
        )

    def compute(self, obj):
        has_result = bool(obj.ProfilePoints)
        if not has_profile(obj):
            status.set_problem(obj, has_result, "Choose a sketch or a file with half the outline.")
            return
        with status.reported(obj, has_result):
            profile, kind, placement = read(obj)
            show(obj, profile, kind)
            if placement is not None and obj.Placement != placement * obj.FromSketch:
                obj.Placement = placement * obj.FromSketch
            status.set_status(obj, status.READY)


def has_profile(obj) -> bool:
    """Whether there is anything to read."""
    return bool(obj.Source or obj.ProfileFrom == NATURAL_SHAPE or obj.ProfileFile)


def set_profile(obj, path) -> None:
    """Copy a file into the document as the profile, keeping its name; OSError if it cannot be read."""
    import os

    from BalloonWorkbench.app.outline import in_letters

    obj.ProfileFrom = FROM_FILE
    obj.ProfileFile = (os.fspath(path), os.path.basename(in_letters(path)))


def options(obj) -> BodyOptions:
    """The object's own values."""
    return options_from(obj, BodyOptions)


def read(obj):
    """The profile, what it was read from, and the placement of a linked sketch (None for others)."""
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.bag_design.source import profile_of_size
    from BalloonWorkbench.core.bodies.check_profile import with_ends

    own = options(obj)
    ends = own.lower_cap, own.upper_cap
    if obj.Source:
        from BalloonWorkbench.app.drawings.profile_sketch import profile_of

        profile, placement = profile_of(*obj.Source, *ends)
        return profile, "sketch", placement
    if obj.ProfileFrom == NATURAL_SHAPE:
        from BalloonWorkbench.core.bodies.natural_shape import natural_shape

        return with_ends(natural_shape(metres(obj.GoreLength)), *ends), "natural shape", None
    size = metres(obj.Width) or None, metres(obj.Height) or None
    kind = obj.ProfileFile.rpartition(".")[2].lower()
    return profile_of_size(obj.ProfileFile, own, *size), kind, None


def profile(obj):
    """The profile that the object shows, on the grid of the engine."""
    import numpy as np

    from BalloonWorkbench.core.bodies.profile import Profile
    from BalloonWorkbench.core.units import from_mm

    points = from_mm(np.array([(at.x, at.z) for at in obj.ProfilePoints]).reshape(-1, 2))
    return Profile(np.round(points, 9) + 0.0, *obj.ProfileEnds)


def show(obj, read_profile, kind: str) -> None:
    """Write a profile into the object: both halves of the section, and the axis between its ends."""
    import FreeCAD as App
    import numpy as np
    import Part

    from BalloonWorkbench.core.bag_design.gore_count import gores_needed
    from BalloonWorkbench.core.geometry.polyline import length
    from BalloonWorkbench.core.units import to_mm

    points = to_mm(read_profile.points)
    right, left = ([App.Vector(side * r, 0.0, z) for r, z in points.tolist()] for side in (1.0, -1.0))
    ends = [App.Vector(0.0, 0.0, z) for z in points[[0, -1], 1].tolist()]
    axis = [Part.makeLine(*ends)] if ends[0] != ends[1] else []
    section = [*right, *(at for at in reversed(left) if at.x < 0.0)]
    with results(obj) as output:
        output.Shape = Part.Compound([Part.makePolygon([*section, section[0]]), *axis])
        output.ProfilePoints = right
        output.ProfileEnds = [read_profile.lower, read_profile.upper]
        output.GoresNeeded = int(gores_needed(read_profile, options(obj).accuracy or ACCURACY))
        output.BodyDiameter = 2.0 * float(points[:, 0].max())
        output.BodyHeight = float(np.ptp(points[:, 1]))
        output.MeridianLength = length(points)
        output.Kind = kind
        output.Notes = list(read_profile.notes)
