# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Balloon object: the inflated balloon as a mesh, both panels, with its measures."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_outline, is_target
from BalloonWorkbench.app.document.proxy import DocumentProxy
from BalloonWorkbench.app.engine import bag_result, film_result
from BalloonWorkbench.app.properties import film, size_goal
from BalloonWorkbench.app.properties.property_table import (
    Property,
    is_complete,
    options_from,
    properties_of,
    result,
    results,
    show_in_editor,
    with_switches,
)
from BalloonWorkbench.core.options.body import BandOptions
from BalloonWorkbench.core.options.simulation import InflationOptions, ModelOptions

FIT = "Fit to drawing"
PRESSURE, VOLUME = "Pressure", "Volume"
SWITCHES = {
    "TargetVolume": Property(
        "Enumeration",
        "Load",
        "Inflation",
        "What is given: the pressure, or the volume that it shall reach",
        label="Given",
        page="Solver",
        entries=lambda: (PRESSURE, VOLUME),
    )
}

PROPERTIES = (
    Property("Link", "Outline", "Inflation", "What it is to be: an outline, a body of gores or a bag"),
    *film.PROPERTIES,
    Property(
        "Bool",
        "Live",
        "Inflation",
        "Follow every change at once; switch it off for heavy models and inflate when you ask for it",
        True,
        page="Solver",
        preference="Follow every change at once",
    ),
    *with_switches(properties_of(InflationOptions), SWITCHES),
    *properties_of(ModelOptions),
    *properties_of(BandOptions),
    *size_goal.PROPERTIES,
    result("Length", "InflatedWidth", "Width of the inflated balloon"),
    result("Length", "InflatedHeight", "Height of the inflated balloon"),
    result("Length", "InflatedThickness", "Thickness of the inflated balloon"),
    result("Volume", "Volume", "Volume of the inflated balloon"),
    result("Area", "FilmArea", "Area of film inside the welds, all panels"),
    result("Pressure", "ActivePressure", "Pressure in the inflated balloon"),
    result("Float", "MaxTension", "Largest membrane tension in N/m"),
    result("Float", "MaxStrain", "Largest strain of the film"),
    result("Float", "WrinkledShare", "Part of the film's area that is wrinkled"),
    result("Float", "SlackShare", "Part of the film's area that hangs loose"),
    result("Length", "ResidualMean", "Mean distance between drawing and silhouette"),
    result("Length", "ResidualP95", "Distance that 95 % of the silhouette keep to"),
    result("Length", "ResidualMax", "Largest distance between drawing and silhouette"),
    result("Length", "CreasedMean", "Mean distance between drawing and silhouette if the weld creases"),
    result("Length", "CreasedP95", "Distance that 95 % of the silhouette keep to if the weld creases"),
    result("Length", "CreasedMax", "Largest distance between drawing and silhouette if the weld creases"),
    result("VectorList", "Creases", "Places of the outline that move if the weld creases, the worst first"),
    result("Bool", "Reached", "The silhouette is within the tolerance of the drawing"),
    result("Bool", "Converged", "The balloon shown has come to rest"),
    result("Integer", "Passes", "Corrections of the pattern"),
    result("Integer", "NewtonSteps", "Steps of the solver in the last inflation"),
    result("String", "ActiveBackend", "Solver that was used"),
    *size_goal.RESULTS,
    Property(
        "Float",
        "Puffiness",
        "Result",
        "Air that it holds, as a share of what a round balloon of as much film would",
        result=True,
    ),
    Property("StringList", "Advice", "Result", "What would make the balloon better", result=True),
    *film_result.PROPERTIES,
    *bag_result.PROPERTIES,
    result("StringList", "Warnings", "Remarks made during the design"),
    result("String", "Status", "Up to date, or what is wrong"),
    result("String", "Report", "The whole report as JSON", hidden=True),
    result("VectorList", "SeamPoints", "Corners of the pattern's seam", hidden=True),
    result("IntegerList", "SeamCounts", "Number of corners of each seam", hidden=True),
    result("VectorList", "SeamWeldPoints", "Corners of the welds inside", hidden=True),
    result("IntegerList", "SeamWeldCounts", "Number of corners of each weld", hidden=True),
    result("String", "SolvedFor", "Label of the values the mesh belongs to", hidden=True),
)


class BalloonProxy(DocumentProxy):
    """Behaviour of the Balloon object (Mesh::FeaturePython)."""

    properties = PROPERTIES

    def __init__(self, obj):
        super().__init__(obj)
        film.set_choices(obj)
        follow_load(obj)
        size_goal.follow(obj)
        follow_band(obj)

    def opened(self, obj):
        film.complete(obj)
        film.protect(obj)
        follow_load(obj)
        size_goal.follow(obj)
        follow_band(obj)

    def onChanged(self, obj, name):
        from BalloonWorkbench.app.host import is_replaying

        edited = not is_replaying(obj.Document)
        if name == "Film" and edited:
            film.follow_choice(obj)
        if name == "Load" and "SolvedFor" in obj.PropertiesList:
            if edited and obj.Load == VOLUME and not obj.TargetVolume:
                obj.TargetVolume = obj.Volume
            follow_load(obj)
        if name in ("Outline", "Band", "BodyThickness") and is_complete(obj, PROPERTIES):
            follow_band(obj)
        if name in size_goal.DECIDING and "SolvedFor" in obj.PropertiesList:
            if edited and name == "SizeGoal":
                size_goal.begin(obj)
            size_goal.follow(obj)

    def compute(self, obj):
        from BalloonWorkbench.app.border import hooks

        if status.waits_for(obj, obj.Outline, bool(obj.SolvedFor), "Choose the outline to inflate."):
            return
        with status.reported(obj, bool(obj.SolvedFor)):
            current = request(obj)
            if current.key() != obj.SolvedFor or not film_result.is_known(obj):
                if not obj.Live:
                    status.set_problem(obj, bool(obj.SolvedFor), _not_asked(obj))
                    return
                design, report = hooks.run_blocking(f"Inflating {obj.Label}", current.solve)
                show(obj, current, design, report)
            size_goal.show_lift(obj)
            status.set_status(obj, _verdict(obj))
        if obj.Placement != obj.Outline.Placement:
            obj.Placement = obj.Outline.Placement


def inflate_now(obj) -> None:
    """Inflate a balloon that does not do so by itself, property Live; the document follows.

    Why nothing comes of it is told in its Status.
    """
    from BalloonWorkbench.app.border import hooks

    with status.reported(obj, bool(obj.SolvedFor)):
        current = request(obj)
        if current.key() != obj.SolvedFor:
            design, report = hooks.run_blocking(f"Inflating {obj.Label}", current.solve)
            show(obj, current, design, report)
        obj.touch()
        obj.Document.recompute()


def follow_load(obj) -> None:
    """Show the pressure or the volume in the property editor: what is given."""
    by_volume = obj.Load == VOLUME
    show_in_editor(
        obj, Pressure="hide" if by_volume else "edit", TargetVolume="edit" if by_volume else "hide"
    )


def follow_band(obj) -> None:
    """Offer a side band where there is an outline, which it goes along."""
    drawn = obj.Outline is None or is_outline(obj.Outline)
    mode, piece = "edit" if drawn else "hide", drawn and bool(obj.Band or obj.BodyThickness)
    show_in_editor(obj, Band=mode, BodyThickness=mode, BandPiece="edit" if piece else "hide", TwoPanels=mode)


def asks_for_many_panels(obj) -> bool:
    """The object's values ask for a body of gores, a bag or a side band; else for two equal panels."""
    return not is_outline(obj.Outline) or bool(obj.Band or obj.BodyThickness)


def request(obj):
    """What the object's values ask of the engine; InputError when they make no sense."""
    from BalloonWorkbench.app.engine.solve import Request
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.reports.report import Source

    source, settings = obj.Outline, _settings(obj)
    if asks_for_many_panels(obj):
        return _bag_request(source, settings)
    return Request(Source(_drawing_name(source), source.Kind, part_shapes.stored(source, "Loop")), settings)


def _bag_request(source, settings):
    """The request for many panels of what a balloon is to be."""
    from BalloonWorkbench.app import bag, gored_body, target
    from BalloonWorkbench.app.engine.bag_solve import BagRequest
    from BalloonWorkbench.app.shapes import part_shapes

    if is_gored_body(source):
        return BagRequest(gored_body.profile(source), source.Label, source.Kind, settings)
    if is_bag(source):
        return BagRequest(bag.bag(source), source.Label, source.Kind, settings)
    if is_target(source):
        return BagRequest(target.division(source), source.Label, source.Kind, settings)
    return BagRequest(part_shapes.stored(source, "Loop"), _drawing_name(source), source.Kind, settings)


def _drawing_name(outline) -> str:
    """What a drawing is called: its sketch, or its file."""
    import os

    return outline.Source[0].Label if outline.Source else os.path.basename(outline.Drawing)


def _settings(obj):
    """The object's values, and those of what it is to be, as the engine's settings."""
    from BalloonWorkbench.app.properties.quantities import cubic_metres
    from BalloonWorkbench.core.job import Settings
    from BalloonWorkbench.core.options.body import BodyOptions, TargetOptions
    from BalloonWorkbench.core.solver.model import Model

    many = asks_for_many_panels(obj)
    body = options_from(obj.Outline, BodyOptions) if is_gored_body(obj.Outline) else BodyOptions()
    own = options_from(obj.Outline, TargetOptions) if is_target(obj.Outline) else TargetOptions()
    volume = cubic_metres(obj.TargetVolume) if obj.Load == VOLUME else None
    return Settings(
        **vars(options_from(obj, InflationOptions, volume=volume)),
        film=film.read(obj),
        goal=size_goal.goal(obj),
        filling=size_goal.filling(obj),
        pattern=size_goal.pattern_options(obj),
        model=Model(**vars(options_from(obj, ModelOptions))),
        body=body,
        target=own,
        side_band=options_from(obj, BandOptions) if many and is_outline(obj.Outline) else BandOptions(),
    )


def show(obj, current, design, report: dict | None = None) -> None:
    """Write a design into the object; the next recompute finds it and does not solve again.

    report  what the request says of the design where it is known
    """
    import json

    from BalloonWorkbench.app.shapes import part_shapes

    many = asks_for_many_panels(obj)
    report = report or current.describe(design)
    if many:
        design = bag_result.beside_panels(design)
    with results(obj) as output:
        _show_mesh(output, design.inflation)
        _show_measures(output, report)
        output.Warnings = list(design.warnings)
        output.Advice = [f"{finding['severity']}: {finding['text']}" for finding in report["advice"]]
        output.Puffiness = report["puffiness"]
        output.Report = json.dumps(report, ensure_ascii=False)
        if many:
            bag_result.store(output, design, current.settings.film, _values(obj))
        else:
            part_shapes.store(output, "Seam", design.pattern)
            film_result.store(output, design.inflation, current.settings.film, _values(obj))
            bag_result.clear(output)
        output.SolvedFor = current.key()


def _show_mesh(obj, inflation) -> None:
    """The closed mesh of the balloon."""
    from BalloonWorkbench.app.host import mesh_from_arrays
    from BalloonWorkbench.core.results.stl import balloon_mesh
    from BalloonWorkbench.core.units import to_mm

    positions, triangles = balloon_mesh(inflation)
    obj.Mesh = mesh_from_arrays(to_mm(positions), triangles)


def _values(obj) -> dict:
    """The object's own values, by name."""
    names = [item.name for item in PROPERTIES if not item.result and item.name not in ("Outline", "Live")]
    return {name: getattr(getattr(obj, name), "Value", getattr(obj, name)) for name in names}


def _not_asked(obj) -> str:
    """Why a balloon that does not follow by itself is not up to date."""
    if not obj.SolvedFor:
        return "It is not inflated yet: choose Inflate now in its context menu, or switch Live on."
    changed = ", ".join(film_result.changed_since(obj, _values(obj))) or "The outline"
    return f"{changed} changed since. Choose Inflate now in its context menu, or switch Live on."


def _show_measures(obj, report) -> None:
    from BalloonWorkbench.app.properties import quantities

    inflated, design, error = report["inflated"], report["design"], report["design"]["silhouette_error_mm"]
    obj.InflatedWidth, obj.InflatedHeight = inflated["width_mm"], inflated["height_mm"]
    obj.InflatedThickness = inflated["thickness_mm"]
    obj.Volume = quantities.cubic_millimetres(inflated["volume_m3"])
    obj.FilmArea = quantities.square_millimetres(inflated["film_area_m2"])
    obj.ActivePressure = quantities.kilopascals(report["pressure_Pa"])
    obj.MaxTension, obj.MaxStrain = inflated["max_tension_N_per_m"], inflated["max_strain"]
    obj.WrinkledShare = inflated["area_shares"]["wrinkled"]
    obj.SlackShare = inflated["area_shares"]["slack"]
    obj.ResidualMean, obj.ResidualP95, obj.ResidualMax = error["mean"], error["p95"], error["max"]
    _show_creases(obj, design["weld_range"])
    obj.Reached, obj.Converged = bool(design["reached"]), bool(report["solve"]["converged"])
    obj.Passes, obj.NewtonSteps = int(design["passes"]), int(report["solve"]["newton_steps"])
    obj.ActiveBackend = report["backend"]


def _show_creases(obj, creased) -> None:
    """What the report tells of the weld that creases; nothing where that was not simulated."""
    import FreeCAD as App

    error = creased["silhouette_error_mm"] if creased else {"mean": 0.0, "p95": 0.0, "max": 0.0}
    obj.CreasedMean, obj.CreasedP95, obj.CreasedMax = error["mean"], error["p95"], error["max"]
    obj.Creases = [App.Vector(*place["at_mm"]) for place in (creased["creases"] if creased else ())]


def _verdict(obj) -> str:
    if obj.Converged:
        return status.READY
    return status.UNSURE + "what is shown is the last good state. Lower the pressure or change the mesh size."
