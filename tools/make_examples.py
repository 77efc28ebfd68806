# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the example documents in resources/examples. `make examples` runs it inside FreeCAD's window.

Each is made as a user would make it, and saved as it looks best.
"""

import math
import os
import sys
import traceback
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "examples"
MESHES = FOLDER / "meshes"
MESH = 9.0  # mm


def painted_fish(doc):
    """Strokes, as the paint window has them; a double-click on the Outline opens them."""
    import fish_painting

    from BalloonWorkbench.app.drawings import painting
    from BalloonWorkbench.core.job import Settings
    from BalloonWorkbench.gui.paint.painting.layers import SIDE
    from BalloonWorkbench.gui.paint.painting.painted import Painting
    from BalloonWorkbench.gui.paint.preview.painting_display import MODE

    paper = Painting()
    for step in fish_painting.steps(SIDE):
        paper.do(step)
    file = Path(doc.TransientDir) / "fish.png"
    paper.file_image().save(str(file), "PNG")
    solved = painting.solve(file, 300.0, Settings())
    parts = painting.make(doc, file, 300.0, solved)
    parts.balloon.getParentGroup().Label = "Painted fish"
    parts.balloon.ViewObject.DisplayMode = MODE
    return parts


def parametric_heart(doc):
    """A sketch whose dimensions, and the pressure, come from a spreadsheet: change a cell, all follows."""
    from BalloonWorkbench.app.document import create

    sheet = doc.addObject("Spreadsheet::Sheet", "Sizes")
    rows = (("Width", "width", "250 mm"), ("Height", "height", "230 mm"), ("Pressure", "pressure", "2 kPa"))
    for row, (title, alias, value) in enumerate(rows, 1):
        sheet.set(f"A{row}", title)
        sheet.set(f"B{row}", f"={value}")
        sheet.setAlias(f"B{row}", alias)
    doc.recompute()
    sketch = heart_sketch(doc)
    lobe = "0.29 * Sizes.width"
    sketch.setExpression("Constraints.Lobe", lobe)
    sketch.setExpression("Constraints.Apart", f"Sizes.width - 2 * {lobe}")
    sketch.setExpression("Constraints.Depth", f"Sizes.height - {lobe}")
    doc.recompute()
    parts = create.balloon_from_sketch(doc, sketch, mesh_size=MESH)
    parts.balloon.setExpression("Pressure", "Sizes.pressure")
    doc.recompute()
    sketch.ViewObject.Visibility = False
    return parts


def heart_sketch(doc):
    """Two lobes and two tangents to the tip: free are only the three named dimensions."""
    import Part
    import Sketcher

    def point(x, y):
        return App.Vector(x, y, 0)

    def lobe(x, start, end):
        circle = Part.Circle(point(x, 0), App.Vector(0, 0, 1), 72.5)
        return Part.ArcOfCircle(circle, math.radians(start), math.radians(end))

    obj = doc.addObject("Sketcher::SketchObject", "Heart")
    right, left = lobe(52.5, -45, 136), lobe(-52.5, 44, 225)
    down = Part.LineSegment(point(104, -51), point(0, -157))
    up = Part.LineSegment(point(0, -157), point(-104, -51))
    obj.addGeometry([right, left, down, up], False)
    start, end, centre, upright, origin = 1, 2, 3, -2, 1
    coincident = [(0, end, 1, start), (2, end, 3, start)]
    for a, pa, b, pb in coincident:
        obj.addConstraint(Sketcher.Constraint("Coincident", a, pa, b, pb))
    for a, pa in ((0, end), (2, end)):
        obj.addConstraint(Sketcher.Constraint("PointOnObject", a, pa, upright))
    obj.addConstraint(Sketcher.Constraint("PointOnObject", 0, centre, -1))
    obj.addConstraint(Sketcher.Constraint("Tangent", 0, start, 2, start))
    obj.addConstraint(Sketcher.Constraint("Tangent", 3, end, 1, end))
    obj.addConstraint(Sketcher.Constraint("Symmetric", 0, centre, 1, centre, -1, origin))
    sizes = (
        ("Lobe", Sketcher.Constraint("Radius", 0, 72.5)),
        ("Apart", Sketcher.Constraint("DistanceX", 1, centre, 0, centre, 105.0)),
        ("Depth", Sketcher.Constraint("DistanceY", 2, end, -1, origin, 157.5)),
    )
    for name, constraint in sizes:
        obj.renameConstraint(obj.addConstraint(constraint), name)
    doc.recompute()
    return obj


def letter_s(doc):
    """Nothing but arcs: two bowls, broad strokes, round ends."""
    from BalloonWorkbench.app.document import create

    parts = create.balloon_from_sketch(doc, s_sketch(doc), mesh_size=MESH)
    doc.LetterS.ViewObject.Visibility = False
    return parts


def banded_letter(doc):
    """The same letter with a band between front and back."""
    from BalloonWorkbench.app.document import create

    parts = create.balloon_from_sketch(doc, s_sketch(doc), mesh_size=12.0, band=40.0)
    doc.LetterS.ViewObject.Visibility = False
    return parts


def s_sketch(doc):
    """The letter S."""
    import Part

    bowl, stroke, end = 62.0, 60.0, math.radians(10)

    def arc(x, y, radius, start, stop):
        """Counter-clockwise."""
        circle = Part.Circle(App.Vector(x, y, 0), App.Vector(0, 0, 1), radius)
        return Part.ArcOfCircle(circle, start, stop)

    half, quarter = 0.5 * stroke, 0.5 * math.pi
    geometry = []
    for side, turn in ((1, 0.0), (-1, math.pi)):  # the lower half is the upper one, turned round
        x, y = side * bowl * math.cos(end), side * (bowl + bowl * math.sin(end))
        geometry += [
            arc(0, side * bowl, bowl + half, end + turn, 3 * quarter + turn),
            arc(0, side * bowl, bowl - half, end + turn, 3 * quarter + turn),
            arc(x, y, half, end + turn - math.pi, end + turn),
        ]
    sketch = doc.addObject("Sketcher::SketchObject", "LetterS")
    sketch.Label = "Letter S"
    sketch.addGeometry(geometry, False)
    doc.recompute()
    return sketch


def airship(doc):
    """Half an ellipse over its axis, a construction line: 2.1 m long, 0.73 m thick, six gores."""
    import Part

    from BalloonWorkbench.app.document import create

    long, thick = 1050.0, 365.0
    sketch = doc.addObject("Sketcher::SketchObject", "HalfOutline")
    sketch.Label = "Half outline"
    ellipse = Part.Ellipse(App.Vector(long, 0, 0), App.Vector(0, thick, 0), App.Vector())
    sketch.addGeometry([Part.ArcOfEllipse(ellipse, 0.0, math.pi)], False)
    sketch.addGeometry([Part.LineSegment(App.Vector(-long, 0, 0), App.Vector(long, 0, 0))], True)
    doc.recompute()
    parts = create.balloon_from_profile(doc, sketch, gores=6, pressure=0.5, mesh_size=55.0)
    sketch.ViewObject.Visibility = False
    return parts


def pouch(doc):
    """A ready body whose sizes come from a spreadsheet."""
    from BalloonWorkbench.app.document import create

    sheet = doc.addObject("Spreadsheet::Sheet", "Sizes")
    rows = (("Width", "width", 200), ("Height", "height", 300), ("Depth", "depth", 100))
    for row, (title, alias, value) in enumerate(rows, 1):
        sheet.set(f"A{row}", title)
        sheet.set(f"B{row}", f"={value} mm")
        sheet.setAlias(f"B{row}", alias)
    doc.recompute()
    parts = create.balloon_from_panels(doc, "Pouch", mesh_size=12.0)
    for title, alias, _ in rows:
        parts.outline.setExpression(title, f"Sizes.{alias}")
    doc.recompute()
    return parts


def ring(doc):
    """Two circles with their diameters as dimensions."""
    import Part
    import Sketcher

    from BalloonWorkbench.app.document import create

    sketch = doc.addObject("Sketcher::SketchObject", "Circles")
    for number, (name, radius) in enumerate((("Outside", 150.0), ("Inside", 70.0))):
        sketch.addGeometry(Part.Circle(App.Vector(), App.Vector(0, 0, 1), radius), False)
        sketch.addConstraint(Sketcher.Constraint("Coincident", number, 3, -1, 1))
        added = sketch.addConstraint(Sketcher.Constraint("Diameter", number, 2 * radius))
        sketch.renameConstraint(added, name)
    doc.recompute()
    parts = create.balloon_from_sketch(doc, sketch, mesh_size=12.0)
    sketch.ViewObject.Visibility = False
    return parts


def housing(doc):
    """A solid with fillets whose sizes come from a spreadsheet, and the balloon that fills it."""
    from BalloonWorkbench.app.document import create

    solid = filleted(doc)
    parts = create.balloon_from_body(doc, solid, panels=12, mesh_size=12.0)
    solid.ViewObject.Visibility = False
    return parts


def filleted(doc):
    """A block in PartDesign, all of its edges round."""
    sheet = doc.addObject("Spreadsheet::Sheet", "Sizes")
    rows = (
        ("Length", "length", 240),
        ("Width", "width", 160),
        ("Height", "height", 120),
        ("Fillet", "fillet", 45),
    )
    for row, (title, alias, value) in enumerate(rows, 1):
        sheet.set(f"A{row}", title)
        sheet.set(f"B{row}", f"={value} mm")
        sheet.setAlias(f"B{row}", alias)
    doc.recompute()
    body = doc.addObject("PartDesign::Body", "Housing")
    block = body.newObject("PartDesign::AdditiveBox", "Block")
    for _, alias, _ in rows[:3]:
        block.setExpression(alias.capitalize(), f"Sizes.{alias}")
    doc.recompute()
    fillet = body.newObject("PartDesign::Fillet", "Fillet")
    fillet.Base = (block, [f"Edge{number}" for number in range(1, 13)])
    fillet.setExpression("Radius", "Sizes.fillet")
    doc.recompute()
    return body


def spot(doc):
    """The cow Spot by Keenan Crane, 300 mm high, in 16 panels."""
    from BalloonWorkbench.app.document import create

    return create.balloon_from_body(doc, MESHES / "spot.obj", panels=16, height=300.0, mesh_size=13.0)


def bottle(doc):
    """A solid of Part: half a section turned round, its edges rounded."""
    from BalloonWorkbench.app.document import create

    section = doc.addObject("Part::Polygon", "HalfSection")
    corners = ((0, 0), (60, 0), (60, 170), (26, 215), (26, 260), (0, 260))
    section.Nodes = [App.Vector(x, 0, z) for x, z in corners]
    section.Close = True
    turned = doc.addObject("Part::Revolution", "Turned")
    turned.Source, turned.Axis, turned.Angle, turned.Solid = section, App.Vector(0, 0, 1), 360.0, True
    doc.recompute()
    solid = doc.addObject("Part::Fillet", "Bottle")
    solid.Base = turned
    round_ones = [number for number, edge in enumerate(turned.Shape.Edges, 1) if edge.isClosed()]
    solid.Edges = [(number, 16.0, 16.0) for number in round_ones]
    doc.recompute()
    parts = create.balloon_from_body(doc, solid, panels=8, mesh_size=13.0)
    for obj in (section, turned, solid):
        obj.ViewObject.Visibility = False
    return parts


EXAMPLES = {
    "painted-fish": painted_fish,
    "parametric-heart": parametric_heart,
    "letter": letter_s,
    "ring": ring,
    "airship": airship,
    "banded-letter": banded_letter,
    "pouch": pouch,
    "housing": housing,
    "spot": spot,
    "bottle": bottle,
}


def make(name):
    """Make one, and save it."""
    from BalloonWorkbench.gui.view3d.fit_view import fit_all

    doc = App.newDocument(name.replace("-", " ").capitalize())
    parts = EXAMPLES[name](doc)
    wrong = [obj.Status for obj in parts if obj.Status != "up to date"]
    if wrong:
        raise SystemExit(f"{name}: {wrong}")
    Gui.activeDocument().activeView().viewTop()
    fit_all()
    Gui.updateGui()
    doc.CreatedBy = doc.LastModifiedBy = ""
    doc.saveAs(str(FOLDER / f"{name}.FCStd"))
    App.closeDocument(doc.Name)
    sys.stderr.write(f"{name}: {(FOLDER / f'{name}.FCStd').stat().st_size // 1024} KiB\n")


def run():
    """Make all, or those that the environment variable EXAMPLES names, and end the program."""
    code = 1
    try:
        Gui.activateWorkbench("BalloonWorkbench")
        settings = App.ParamGet("User parameter:BaseApp/Preferences/Document")
        settings.SetBool("SaveThumbnail", False)
        settings.SetBool("CreateBackupFiles", False)
        wanted = os.environ.get("EXAMPLES", "").split() or list(EXAMPLES)
        for name in wanted:
            make(name)
        code = 0
    finally:
        if code:
            traceback.print_exc()
        sys.stderr.flush()
        os._exit(code)


sys.path.append(str(Path(__file__).resolve().parent))
sys.path.insert(0, os.path.join(App.getUserAppDataDir(), "AdditionalPythonPackages"))
from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(0, run)
