# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API on balloons: what macros use, and what the commands of the window write into macros.

`import BalloonWorkbench` offers these functions by name; docs/api.md has examples. A balloon is a `Parts`:
its outline, balloon and pattern object. Values are given by the names of the objects' properties in small
letters, such as mesh_size for MeshSize: as numbers in FreeCAD's units, quantities, or text such as "300 mm".
"""

from __future__ import annotations

from BalloonWorkbench.app import balloon
from BalloonWorkbench.app.api.call import bordered, done, parts_with
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.document.parts import Parts, panels_of
from BalloonWorkbench.app.drawings import outline_edits
from BalloonWorkbench.app.engine import advice, repairs
from BalloonWorkbench.app.properties import values
from BalloonWorkbench.core.errors import InputError


@bordered
def from_picture(doc, path, width=None, height=None, **options) -> Parts:
    """A new balloon from a picture, SVG, DXF or JSON file; pictures need a width or a height.

    A painting that the paint window has saved is such a picture. Raises BalloonError when no balloon comes
    out; the document is then as before.
    """
    return done[-1] if done else create.balloon_from_picture(doc, path, width, height, values=options)


@bordered
def from_sketch(doc, source, elements=(), **options) -> Parts:
    """A new balloon that follows a sketch, wire or face; elements such as ["Face6"] pick a part of it.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return done[-1] if done else create.balloon_from_sketch(doc, source, elements, values=options)


@bordered
def from_profile(doc, source=None, elements=(), **options) -> Parts:
    """A new balloon of gores from a profile: a sketch or wire, or an SVG, DXF or JSON file; None makes the
    natural shape, whose gores are `gore_length` long.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return done[-1] if done else create.balloon_from_profile(doc, source, elements, values=options)


@bordered
def from_panels(doc, source, seams=(), **options) -> Parts:
    """A new balloon of flat panels: a JSON file, the name of a ready body such as "Box", or a list of
    sketches and pairs (object, ["Face1", "Face2"]); seams are texts such as "Sketch.Edge1=Sketch001.Edge3".

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return done[-1] if done else create.balloon_from_panels(doc, source, seams, values=options)


@bordered
def from_body(doc, source, **options) -> Parts:
    """A new balloon that fills a closed body: a solid or a mesh, or an STL, OBJ, PLY, 3MF or STEP file;
    panels says into how many pieces it is divided, 0 takes the faces of a solid, 1 only the seams that are
    drawn: seam_edits has texts of what is done to the seams, seam_sketches sketches that are projected.

    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    return done[-1] if done else create.balloon_from_body(doc, source, values=options)


@bordered
def parts(obj) -> Parts:
    """The balloon that an object or its group belongs to; InputError for other objects."""
    return parts_with(obj)


@bordered
def panels(made: Parts) -> list:
    """The Panel objects of a balloon of many panels: each piece that is cut for it, to name, hide, measure
    and export alone. Two equal panels have none."""
    return panels_of(made.pattern)


@bordered
def change(made: Parts, **options) -> None:
    """Change values of a balloon and bring the document up to date; InputError for unknown names."""
    if not done:
        values.assign(made, options)
        made.balloon.Document.recompute()


@bordered
def inflate(made: Parts) -> None:
    """Inflate a balloon that does not do so by itself, `live` being off; its Status tells what came of it."""
    if not done:
        balloon.inflate_now(made.balloon)


@bordered
def edit_outline(made: Parts, do: str, at, to=None, mirrored: bool = False) -> None:
    """Edit an outline by hand: "move" the node nearest to `at` [mm] `to` a place, "add" one, "remove" it, or
    make it "sharp" or "round", or "fill" its hole; mirrored: on both sides of a symmetric one. InputError."""
    if not done:
        outline_edits.edit(made.outline, do, at, to, mirrored)
        made.balloon.Document.recompute()


@bordered
def findings(made: Parts) -> list:
    """The findings about a balloon, the worst first: rule, severity, text, place and repair."""
    return advice.findings(made)


@bordered
def repair(made: Parts, rule: str, near=(0.0, 0.0)) -> None:
    """Take the repair of a finding: the one of this rule whose place is nearest to `near` [mm].

    Raises InputError when there is none.
    """
    from BalloonWorkbench.core.units import to_mm

    if done:
        return
    repairable = [each for each in advice.findings(made) if each.rule == rule and each.repair is not None]
    if not repairable:
        raise InputError(f'There is no "{rule}" to repair in {made.balloon.Label}: see its advice.')
    x, y = near
    nearest = min(
        repairable, key=lambda each: (to_mm(each.place[0]) - x) ** 2 + (to_mm(each.place[1]) - y) ** 2
    )
    repairs.take(made, nearest.repair)
    made.balloon.Document.recompute()
