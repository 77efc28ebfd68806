# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where balloons, patterns, prints and sheets of film lie in a document: beside each other.

A new object is placed once, as soon as it has a shape, beside all that is there. It stays; only where what
was made before it, or the balloon of a sketch, has come into its place does it go aside again. What the user
has moved stays for good. What follows a sketch lies on it, and goes aside only for what follows another one.
The target of a solid lies beside it, at its height.
All of it happens after a recompute: no `execute` knows its neighbours.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import FreeCAD as App

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.border.guard import Guarded
from BalloonWorkbench.app.document.kinds import (
    is_artwork,
    is_film_sheet,
    is_gored_body,
    is_ours,
    is_panel,
    is_pattern,
    is_source,
    is_target,
    leader,
)
from BalloonWorkbench.app.properties.property_table import Property

PROPERTIES = (
    Property("Bool", "Placed", "Base", "The workbench has given it a place", True, True, True),
    Property("PlacementList", "PlacedAt", "Base", "Where the workbench put it", None, True, True),
)
#: Of what follows a sketch, besides.
FROM_SKETCH = Property("Placement", "FromSketch", "Base", "Its place, seen from its sketch", None, True, True)

_RIGHT, _DOWN = App.Vector(1.0, 0.0, 0.0), App.Vector(0.0, -1.0, 0.0)
_PROFILE = App.Placement(App.Vector(), App.Rotation(App.Vector(1.0, 0.0, 0.0), 90.0))  # x to x, y to z
_GAP = 0.1  # between two of them, of the mean of width and height of the one that is placed
_TOUCHING = 1e-3  # mm that boxes may overlap
_SAME = 1e-6  # mm, and rad
_ENDLESS = 1e6  # mm; planes and axes for construction are no obstacles
_NEW, _AUTOMATIC, _FIXED = "new", "automatic", "fixed"


class _RecomputeWatch(Guarded):
    """Told by FreeCAD of each recompute."""

    def slotRecomputedDocument(self, document) -> None:
        arrange(document)

    def slotRecomputedObject(self, obj) -> None:
        """Of one object by itself; a recompute of the document is waited for."""
        if not obj.Document.Recomputing and "PlacedAt" in obj.PropertiesList:
            arrange(obj.Document)


_watching: list[_RecomputeWatch] = []


def watch() -> None:
    """Arrange each document after its recomputes from now on."""
    if not _watching:
        _watching.append(_RecomputeWatch())
        App.addDocumentObserver(_watching[0])


def place_when_ready(obj) -> None:
    """A new object is given a place as soon as it has a shape, unless the user puts it somewhere before."""
    obj.Placed = False


def arrange(doc) -> None:
    """Place what is new, and move aside what something has grown into."""
    units = sorted(_units(doc), key=lambda unit: not unit.follows_sketch)
    settled: list[_Unit] = []
    for unit in units:
        if unit.state == _AUTOMATIC:
            _make_way(unit, settled)
        if unit.state != _NEW:
            settled.append(unit)
    new = [unit for unit in units if unit.state == _NEW]
    waiting = [obj for unit in new for obj in unit.everything]
    for unit in new:
        there = [obj for obj in doc.Objects if obj not in waiting and (is_ours(obj) or obj.Visibility)]
        there = [obj for obj in there if not is_panel(obj)]  # they lie on their pattern
        if unit.follows_sketch:
            others = [obj for each in settled if each.follows_sketch for obj in each.everything]
            there = [obj for obj in there if is_ours(obj)] if _meets(unit, others) else []
            settled.append(unit)
        _place(unit, there)
        waiting = [obj for obj in waiting if obj not in unit.everything]


def free_shift(doc, low, high, but=()) -> float:
    """How far to the right [mm] there is room in a document for a box of the xy plane, corners (x, y).

    but  objects that are no obstacles
    """
    box = App.BoundBox(*low, 0.0, *high, 0.0)
    there = [obj for obj in doc.Objects if obj.Visibility and obj not in but]
    return _clearance(box, boxes(there, App.Placement()), _RIGHT).x


def boxes(objects, frame: App.Placement):
    """Boxes of objects along the axes of a frame; none of those without a shape of a size."""
    for obj in objects:
        if not obj.isDerivedFrom("App::GeoFeature"):
            continue  # asked for its shape, a group of FreeCAD 1.0 keeps one in the document
        mesh, shape = getattr(obj, "Mesh", None), getattr(obj, "Shape", None)
        has_size = getattr(mesh, "CountPoints", 0) or (shape is not None and not shape.isNull())
        if not (has_size or is_target(obj)):
            continue  # paths of a machine have no global placement in FreeCAD 0.20
        place = frame.inverse() * obj.getGlobalPlacement()
        if is_target(obj):  # its seams do not go round all of the body
            box = _about(obj.BodySize).transformed(place.toMatrix())
            if obj.BodySize.Length > 0.0:
                yield box
            continue
        if getattr(mesh, "CountPoints", 0):
            own = mesh.copy()
            own.Placement = place
        else:
            # moved, not copied: that is 30 times as quick
            own = shape.transformed((place * shape.Placement.inverse()).toMatrix())
        box = own.BoundBox
        if box.isValid() and box.DiagonalLength < _ENDLESS:
            yield box


def _about(size: App.Vector):
    """A box of this size about the origin."""
    return App.BoundBox(*(size * -0.5), *(size * 0.5))


# what belongs together


@dataclass
class _Unit:
    """Objects that are placed together and keep their places to each other.

    owners  what they lie beside, in whose plane
    bodies  the solids that they are made for
    along   the other objects that go where the first ones go
    way     where they go to from what is in the way, in their plane
    """

    objects: list
    owners: list = field(default_factory=list)
    along: list = field(default_factory=list)
    way: App.Vector = field(default_factory=lambda: _RIGHT)
    bodies: list = field(default_factory=list)
    moved: bool = False

    @property
    def state(self) -> str:
        return _state(self.objects[0])

    @property
    def follows_sketch(self) -> bool:
        return _follows_sketch(self.objects[0])

    @property
    def everything(self) -> list:
        return [*self.objects, *self.along]

    def frame(self) -> App.Placement:
        """Their plane: x and y lie in it."""
        return _plane((self.owners or self.objects)[0])

    def box(self):
        """What they take of it."""
        whole = App.BoundBox()
        for box in boxes(self.everything, self.frame()):
            whole.add(box)
        return whole


def _plane(obj) -> App.Placement:
    """The plane in which an object is drawn: a body of gores stands upright on that of its profile."""
    place = obj.getGlobalPlacement()
    if is_target(obj):  # the one on which the body stands
        return place * App.Placement(App.Vector(0.0, 0.0, -0.5 * obj.BodySize.z), App.Rotation())
    return place * _PROFILE if is_gored_body(obj) and obj.Source else place


def _units(doc) -> list[_Unit]:
    """All that has a shape and a place, in the order in which it was made."""
    outlines, patterns, units = [], [], {}
    for obj in filter(is_ours, doc.Objects):
        if "PlacedAt" not in obj.PropertiesList or not (status.is_ready(obj) and _has_shape(obj)):
            continue
        if is_source(obj):
            outlines.append(obj)
        elif is_pattern(obj):
            patterns.append(obj)
        elif is_artwork(obj):
            units[obj] = _Unit([obj], [obj.Pattern], way=_DOWN)
        elif is_film_sheet(obj):
            units[obj] = _Unit([obj], list(obj.Patterns), way=_DOWN)
    for together in _alike(outlines, leader):
        along = [mesh for obj in together for mesh in _balloons(obj)]
        bodies = [obj.Solid for obj in together if is_target(obj) and obj.Solid]
        units[together[0]] = _Unit(together, along=along, bodies=bodies)
    for together in _alike(patterns, lambda obj: leader(obj.Balloon.Outline)):
        balloons = [obj.Balloon for obj in together]
        units[together[0]] = _Unit(together, [*(each.Outline for each in balloons), *balloons])
    return [units[obj] for obj in doc.Objects if obj in units]


def _alike(objects, first) -> list[list]:
    """Objects of the same drawing that are placed together; one that the user has put somewhere is alone."""
    groups: dict = {}
    for obj in objects:
        state = _state(obj)
        groups.setdefault(obj if state == _FIXED else (first(obj), state), []).append(obj)
    return list(groups.values())


def _balloons(outline) -> list:
    """The balloons that lie in an outline's place."""
    return [obj for obj in outline.InList if getattr(obj, "Outline", None) == outline]


def _has_shape(obj) -> bool:
    return next(boxes([obj], App.Placement()), None) is not None


def _state(obj) -> str:
    """Whether the object waits for a place, lies where it was put, or stays where it is."""
    if not obj.Placed:
        return _NEW
    if _follows_sketch(obj):
        return _AUTOMATIC if obj.PlacedAt else _FIXED
    return _AUTOMATIC if obj.PlacedAt and _is_same(obj.PlacedAt[0], obj.Placement) else _FIXED


def _follows_sketch(obj) -> bool:
    """It lies on a sketch, or as far from it as it was put aside."""
    return FROM_SKETCH.name in obj.PropertiesList and bool(leader(obj).Source)


def _is_same(a: App.Placement, b: App.Placement) -> bool:
    return (a.Base - b.Base).Length < _SAME and a.Rotation.isSame(b.Rotation, _SAME)


# where it goes


def _make_way(unit: _Unit, settled: list[_Unit]) -> None:
    """Place a unit anew where something has grown into it, or what it lies beside has gone elsewhere."""
    left_behind = any(each.moved and set(each.everything) & set(unit.owners) for each in settled)
    there = [obj for each in settled for obj in each.everything]
    there += [obj for obj in unit.owners if obj not in there]
    there += [obj for obj in unit.bodies if obj.Visibility]
    if left_behind or _meets(unit, there) or not _is_apart(unit):
        _place(unit, there)
        unit.moved = True


def _place(unit: _Unit, there: list) -> None:
    """Lay a unit beside its owners, and beside all that is there, unless the user has moved it."""
    by_user = not unit.follows_sketch and any(
        not obj.Placed and not obj.Placement.isIdentity() for obj in unit.objects
    )
    if not by_user:
        frame = unit.frame()
        for obj, start in zip(unit.objects, _starts(unit), strict=True):
            if start is not None:
                _put(obj, frame * start)
        for body in boxes(unit.bodies, App.Placement()):
            _shift(unit, body.Center - unit.objects[0].getGlobalPlacement().Base)
        _shift(unit, frame.Rotation.multVec(_clearance(unit.box(), _around(unit, there), unit.way)))
    for obj in unit.objects:
        obj.PlacedAt = [] if by_user else [obj.Placement]
        obj.Placed = True


def _meets(unit: _Unit, objects) -> bool:
    """Something lies on the unit, or under it."""
    own = unit.box()
    return any(_overlap(own, box) for box in _around(unit, objects))


def _around(unit: _Unit, objects) -> list:
    """Boxes of objects in the unit's plane: sketches may lie above each other."""
    others = list(boxes(objects, unit.frame()))
    if not unit.follows_sketch:
        return others
    own = unit.box()
    return [box for box in others if own.ZMin < box.ZMax and box.ZMin < own.ZMax]


def _starts(unit: _Unit) -> list:
    """Where each object is before it goes its way, in the unit's plane; None: where it lies."""
    if not unit.owners:
        return [None] * len(unit.objects)
    corner = App.Vector()
    if is_film_sheet(unit.objects[0]):
        lying = list(boxes(unit.owners, unit.frame()))
        corner = App.Vector(min(box.XMin for box in lying), min(box.YMin for box in lying), 0.0)
    shifts = _on_a_sheet(unit.objects) if len(unit.objects) > 1 else [App.Vector()]
    return [App.Placement(corner + shift, App.Rotation()) for shift in shifts]


def _on_a_sheet(patterns: list) -> list:
    """Shifts that lay patterns of a drawing beside each other: 0 where they have room as drawn."""
    from BalloonWorkbench.core.pattern.layout import beside
    from BalloonWorkbench.core.units import to_mm

    shifts = beside([obj.Proxy.cut_pattern(obj) for obj in patterns])
    return [App.Vector(*to_mm(shift).tolist(), 0.0) for shift in shifts]


def _is_apart(unit: _Unit) -> bool:
    """The patterns of a drawing lie beside each other, or in each other's holes as they are drawn."""
    own = list(boxes(unit.objects, unit.frame())) if unit.owners else []
    if not any(_overlap(a, b) for number, a in enumerate(own) for b in own[:number]):
        return True
    back = unit.frame().inverse()
    lying = [back.multVec(obj.getGlobalPlacement().Base) for obj in unit.objects]
    intended = _on_a_sheet(unit.objects)
    return all(
        ((a - lying[0]) - (b - intended[0])).Length < _SAME for a, b in zip(lying, intended, strict=True)
    )


def _clearance(box, others, way: App.Vector) -> App.Vector:
    """How far a box has to go until it is free of all others, and a little away from those it has met."""
    gap = _GAP * 0.5 * (box.XLength + box.YLength)
    far, others = 0.0, list(others)
    met = others
    while met:
        moved = App.BoundBox(box)
        moved.move(way * far)
        met = [other for other in others if _overlap(moved, other, gap)]
        if far == 0.0 and not any(_overlap(moved, other) for other in met):
            break
        for other in met:
            passed = other.XMax - box.XMin if way.x > 0.0 else box.YMax - other.YMin
            far = max(far, passed + gap + _TOUCHING)
    return way * far


def _overlap(a, b, gap: float = -_TOUCHING) -> bool:
    """Two boxes come nearer to each other than a gap, in x and y."""
    return a.XMin < b.XMax + gap and b.XMin < a.XMax + gap and a.YMin < b.YMax + gap and b.YMin < a.YMax + gap


def _shift(unit: _Unit, by: App.Vector) -> None:
    for obj in unit.everything:
        place = obj.getGlobalPlacement()
        _put(obj, App.Placement(place.Base + by, place.Rotation))


def _put(obj, place: App.Placement) -> None:
    """Move an object; what it shows is not older than before."""
    touched = "Touched" in obj.State
    beyond = obj.getGlobalPlacement() * obj.Placement.inverse()
    before, obj.Placement = obj.Placement, beyond.inverse() * place
    if FROM_SKETCH.name in obj.PropertiesList and _follows_sketch(obj):
        obj.FromSketch = obj.FromSketch * before.inverse() * obj.Placement
    if not touched and all(
        is_ours(user) or user.isDerivedFrom("App::DocumentObjectGroup") for user in obj.InList
    ):
        obj.purgeTouched()
