# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Pattern object: the flat piece to cut and seal, made from the seam of a balloon."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import arrange, panel_objects
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.engine import bag_sheet
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.host import is_replaying
from BalloonWorkbench.app.properties.property_table import (
    Property,
    follow_needs,
    is_complete,
    options_from,
    properties_of,
    result,
    results,
    show_in_editor,
    with_switches,
    write_options,
)
from BalloonWorkbench.app.shapes import pattern_shape, piece_places
from BalloonWorkbench.app.shapes.pattern_shape import DIRECTION, PLACE
from BalloonWorkbench.core.options.pattern import FARTHEST, PatternOptions

#: What says in a document whether the property after it is given, by that property.
SWITCHES = {
    "IntakeAutoPlace": Property(
        "Bool",
        "IntakeAuto",
        "Intake",
        "Find the place of the intake",
        True,
        label="Find its place",
        needs="Intake",
    ),
    "IntakeAngle": Property(
        "Enumeration",
        "IntakeBy",
        "Intake",
        "What tells where the intake is",
        label="Place by",
        entries=lambda: (DIRECTION, PLACE),
    ),
    "TieTabAngle": Property(
        "Bool",
        "TieTabAuto",
        "Marks",
        "Put the tab opposite the intake",
        True,
        label="Opposite the intake",
        needs="TieTab",
    ),
}
PROPERTIES = (
    Property("Link", "Balloon", "Pattern", "The balloon that is cut from this pattern"),
    *with_switches(properties_of(PatternOptions), SWITCHES),
    Property("Bool", "Arcs", "Pattern", "Lines and arcs within 0.02 mm in place of many short lines", True),
    Property(
        "Bool",
        "Splines",
        "Pattern",
        "Smooth stretches as single splines in place of arcs",
        False,
        needs="Arcs",
    ),
    result("String", "HowToFill", "How the intake is made and used"),
    result("StringList", "Pieces", "Panels that are cut, each with what is equal to it"),
    result("StringList", "Seams", "Seams by the number on both edges, with their lengths"),
    result("StringList", "Order", "The seams in the order of the work"),
    result("StringList", "PanelNames", "Names of the panels and other pieces", hidden=True),
    result("IntegerList", "PanelNumbers", "Which of them each wire belongs to; 0: a copy", hidden=True),
    result("Length", "SeamLength", "Length of the weld"),
    result("Length", "PatternWidth", "Width of the piece of film"),
    result("Length", "PatternHeight", "Height of the piece of film"),
    result("StringList", "Roles", "What to do along each wire of the shape"),
    result("StringList", "Warnings", "Remarks made while the pattern was drawn"),
    result("String", "Status", "Up to date, or what is wrong"),
    *piece_places.PROPERTIES,
    *arrange.PROPERTIES,
)
#: What balloons of many panels alone have.
_OF_MANY = ("Opening", "OpeningShare")
#: What has no effect on them.
_OF_TWO = ("Mirror", "IntakeAuto", "IntakeAutoPlace", "IntakeAngle", "IntakeAlong")
#: What decides which of the others have an effect.
_DECIDING = {"IntakeAuto", "IntakeBy", "TieTabAuto"} | {item.needs for item in PROPERTIES}


class PatternProxy(DocumentProxy):
    """Behaviour of the Pattern object (Part::Part2DObjectPython)."""

    properties = PROPERTIES
    weighed_before = None  # a change of a value

    def __init__(self, obj):
        panel_objects.watch()
        super().__init__(obj)
        self.follow_intake(obj)

    def opened(self, obj):
        panel_objects.watch()

    def onChanged(self, obj, name):
        if not is_complete(obj, PROPERTIES):
            return
        if name in _DECIDING:
            self.follow_intake(obj)
        if _is_edited(obj, name) and (name == "Balloon" or _weighing(obj) != self.weighed_before):
            obj.Balloon.touch()  # it tells what it weighs, and may have its size from that

    def onBeforeChange(self, obj, name):
        self.weighed_before = _weighing(obj) if _is_edited(obj, name) else None
        if self.weighed_before is not None and name == "Balloon":
            obj.Balloon.touch()  # it weighs what the usual pattern weighs from now on

    def follow_intake(self, obj):
        """Offer only what has an effect."""
        follow_needs(obj, PROPERTIES)
        show_in_editor(
            obj,
            IntakeAutoPlace="edit" if obj.Intake and obj.IntakeAuto else "hide",
            IntakeBy="edit" if obj.Intake and not obj.IntakeAuto else "hide",
            IntakeAngle=_mode(obj, DIRECTION),
            IntakeAlong=_mode(obj, PLACE),
            TieTabAngle="edit" if obj.TieTab and not obj.TieTabAuto else "hide",
            **dict.fromkeys(_OF_MANY, "edit" if obj.Intake and _is_of_many(obj) else "hide"),
        )
        if getattr(obj.Balloon, "FlatPanels", ""):
            chosen = ("Mirror",) if obj.Mirror else ()
            needless = {*_OF_TWO[: None if obj.IntakeAuto else 1]} - {*chosen}
            show_in_editor(obj, **dict.fromkeys(needless, "hide"))
        else:
            show_in_editor(obj, Mirror="edit")

    def compute(self, obj):
        from BalloonWorkbench.app.border import hooks

        has_result = bool(obj.Roles)
        if status.waits_for(obj, obj.Balloon, has_result, "Choose the balloon that it belongs to."):
            return
        with status.reported(obj, has_result):
            drawing = _drawing(obj)
            curves = hooks.run_blocking(f"Drawing {obj.Label}", lambda progress: drawing())
            with results(obj) as output:
                shown = pattern_shape.show(
                    output, sheet(obj), curves, kind_of(obj).note if obj.Intake else ""
                )
                bag_sheet.show(output, bag_patterns(obj) if has_many_panels(obj.Balloon) else None, shown)
            self.follow_intake(obj)  # there may be more panels now
            status.set_status(obj, status.READY)
        obj.positionBySupport()

    def cut_pattern(self, obj):
        """All that is cut: the panel with the pieces of its intake, the second panel, copies."""
        return sheet(obj)

    def pieces(self, obj):
        """The pieces of one balloon with their edges, the core's PatternPieces."""
        from BalloonWorkbench.app.border import hooks
        from BalloonWorkbench.core.bag_pattern.make import bag_pieces
        from BalloonWorkbench.core.pattern.pieces import two_panel_pieces

        if has_many_panels(obj.Balloon):
            return hooks.ask(f"Drawing {obj.Label}", bag_pieces, *_bag_request(obj))
        return hooks.ask(f"Drawing {obj.Label}", two_panel_pieces, *_request(obj))

    def piece(self, obj, number: int):
        """One panel or other piece of many, by its number from 1, the core's Pattern."""
        patterns = bag_patterns(obj)
        return (*patterns.patterns, *patterns.pieces)[number - 1]


def _is_of_many(obj) -> bool:
    """The balloon has many panels, or something is said that only they have."""
    many = bool(getattr(obj.Balloon, "FlatPanels", ""))
    return many or any(getattr(obj, name) for name in _OF_MANY)


def _is_edited(obj, name: str) -> bool:
    """A value of a balloon's pattern is changed, by the user or by what they have written."""
    own = any(item.name == name and not item.result for item in PROPERTIES)
    if not own or not getattr(obj, "Balloon", None) or is_replaying(obj.Document):
        return False
    # an older object is first given what it lacks
    needed = [item.name for item in PROPERTIES if item.type == "Enumeration"]
    return all(getattr(obj, each, None) is not None for each in (*needed, PROPERTIES[-1].name))


def _weighing(obj):
    """What its weight depends on."""
    from BalloonWorkbench.core.making.weight import weighing

    return weighing(values(obj))


def _mode(obj, by: str) -> str:
    """How the direction or the place of the intake appears: what is not given is a result."""
    return "hide" if not obj.Intake else "edit" if not obj.IntakeAuto and obj.IntakeBy == by else "show"


def kind_of(obj):
    """The kind of the intake, from the core."""
    from BalloonWorkbench.core.pattern.intake.kinds import intake_kinds

    return next(kind for kind in intake_kinds().values() if kind.title == obj.IntakeKind)


def choose_kind(obj, title: str) -> None:
    """Take another kind of intake, with its usual sizes; one that follows an expression keeps it."""
    from BalloonWorkbench.core.units import to_mm

    obj.IntakeKind = title
    driven = {path for path, _ in obj.ExpressionEngine}
    for name, size in (("IntakeWidth", to_mm(kind_of(obj).width)), ("IntakeLength", 0.0)):
        if name not in driven:
            setattr(obj, name, size)


def values(obj) -> PatternOptions:
    """The object's own values."""
    from BalloonWorkbench.app.properties.quantities import metres, radians

    by = None if obj.IntakeAuto else obj.IntakeBy
    return options_from(
        obj,
        PatternOptions,
        intake_width=metres(obj.IntakeWidth),
        intake_angle=radians(obj.IntakeAngle) if by == DIRECTION else None,
        intake_along=metres(obj.IntakeAlong) if by == PLACE else None,
        **({} if obj.IntakeAuto else {"intake_place": FARTHEST}),
        tie_tab_angle=None if obj.TieTabAuto else radians(obj.TieTabAngle),
    )


def set_values(obj, options: PatternOptions) -> None:
    """Give the object other values."""
    from BalloonWorkbench.core.units import to_mm

    write_options(obj, options, PatternOptions)
    if options.intake_width is None:
        obj.IntakeWidth = to_mm(kind_of(obj).width)
    obj.IntakeAuto = options.intake_angle is None and options.intake_along is None
    obj.IntakeBy = DIRECTION if options.intake_along is None else PLACE
    obj.TieTabAuto = options.tie_tab_angle is None


def build(obj):
    """The pattern of one panel in full precision, from the balloon's seam and the object's own values.

    Of many panels it is that of all.

    Raises InputError where the film of the intake's pieces does not weld to the balloon's.
    """
    from dataclasses import replace

    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.pattern.make import make_pattern, pieces_remarks

    if has_many_panels(obj.Balloon):
        return bag_patterns(obj).sheet
    remarks = pieces_remarks(values(obj), film.read(obj.Balloon))
    pattern = make_pattern(*_request(obj))
    return replace(pattern, warnings=(*pattern.warnings, *remarks))


def sheet(obj):
    """All that is cut: the panel with the pieces of its intake, the second panel, copies."""
    from BalloonWorkbench.core.pattern.make import sheet_of

    return build(obj) if has_many_panels(obj.Balloon) else sheet_of(build(obj), values(obj))


def bag_patterns(obj):
    """What is cut for a balloon of many panels, the core's BagPatterns."""
    from BalloonWorkbench.core.bag_pattern import make

    return make.bag_patterns(*_bag_request(obj))


def _bag_request(obj) -> tuple:
    """Flat panels, film and values: all that the patterns of many panels are made from."""
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.app.shapes.bag_shapes import bag_from

    return bag_from(obj.Balloon.FlatPanels), film.read(obj.Balloon), values(obj)


def _drawing(obj):
    """A function that gives what is drawn of an object's pattern and does not touch the document."""
    from functools import partial

    if has_many_panels(obj.Balloon):
        return partial(bag_sheet.draw, *_bag_request(obj), obj.Arcs)
    return partial(draw, *_request(obj), obj.Arcs)


def _request(obj) -> tuple:
    """Seam, width of the film's weld and values: all that a pattern is made from."""
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.app.shapes import part_shapes

    return part_shapes.stored(obj.Balloon, "Seam"), metres(obj.Balloon.SealWidth), values(obj)


def draw(seam, seal_width: float, options, arcs: bool = True) -> tuple:
    """What is drawn of a pattern: a curve for each contour of its sheet; touches no document.

    arcs  lines and arcs in place of many short lines
    Raises what `make_pattern` raises.
    """
    from BalloonWorkbench.core.arcs.curves import polyline
    from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
    from BalloonWorkbench.core.pattern.make import make_pattern, sheet_of

    curve = fit_curve if arcs else polyline
    contours = sheet_of(make_pattern(seam, seal_width, options), options).contours
    return tuple(curve(contour.points, contour.closed) for contour in contours)
