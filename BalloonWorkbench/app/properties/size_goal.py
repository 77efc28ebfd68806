# SPDX-License-Identifier: LGPL-2.1-or-later
"""What decides a balloon's size, and what it weighs and carries.

The Outline has the width that was drawn. A balloon with a goal is that drawing made larger or smaller about
its origin: the Outline stays as it is, the Balloon and its Pattern have the size that meets the goal.
"""

from __future__ import annotations

from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.properties.property_table import (
    Property,
    engine_value,
    options_from,
    properties_of,
    result,
    show_in_editor,
    with_switches,
    write_options,
)
from BalloonWorkbench.core.options.drawing import FillingOptions, GoalOptions
from BalloonWorkbench.core.options.option import option_of, options_of

WIDTH, VOLUME, LIFT = "Width", "Volume", "Lift"
WARM_AIR = "warm-air"
SWITCHES = {
    "GoalVolume": Property(
        "Enumeration",
        "SizeGoal",
        "Size",
        "What decides the size: the outline as it is, a volume to hold or a load to carry",
        label="Size from",
        entries=lambda: (WIDTH, VOLUME, LIFT),
    )
}
#: What decides which of the others have an effect.
DECIDING = ("SizeGoal", "Gas")

PROPERTIES = (
    *with_switches(properties_of(GoalOptions), SWITCHES),
    *properties_of(FillingOptions),
)
RESULTS = (
    result("Float", "Weight", "Film of both panels with weld and intake, in grams"),
    result("Float", "Lift", "What it carries with its gas, in grams; below 0 it sinks"),
    result("Bool", "Floats", "It carries itself"),
    result("Length", "FloatsFrom", "Width from which it carries itself; 0 when never"),
)


def follow(obj) -> None:
    """Offer only what has an effect."""
    show_in_editor(
        obj,
        GoalVolume="edit" if obj.SizeGoal == VOLUME else "hide",
        GoalLift="edit" if obj.SizeGoal == LIFT else "hide",
        # an older object that is just being completed has no gas yet
        GasTemperature="edit" if obj.Gas and _gas(obj) == WARM_AIR else "hide",
    )


def begin(obj) -> None:
    """A goal that was just chosen starts from what the balloon has."""
    if obj.SizeGoal == VOLUME and not obj.GoalVolume:
        obj.GoalVolume = obj.Volume
    if obj.SizeGoal == LIFT and obj.GoalLift == 0.0 and obj.Lift > 0.0:
        obj.GoalLift = obj.Lift


def goal(obj):
    """The core's goal, None where the outline's own size counts."""
    from BalloonWorkbench.app.properties.quantities import cubic_metres
    from BalloonWorkbench.core.design.size_goal import SizeGoal
    from BalloonWorkbench.core.units import from_grams

    if obj.SizeGoal == VOLUME:
        return SizeGoal(volume=cubic_metres(obj.GoalVolume))
    return SizeGoal(lift=from_grams(obj.GoalLift)) if obj.SizeGoal == LIFT else None


def _gas(obj) -> str:
    """The gas, as the core calls it."""
    return engine_value(option_of(FillingOptions, "gas"), obj.Gas)


def filling(obj):
    """The gas and the air around it."""
    from BalloonWorkbench.core.film.filling import Filling, gas

    values = dict(vars(options_from(obj, FillingOptions)))
    if values["gas"] != WARM_AIR:
        values["gas_temperature"] = None
    return Filling(gas(values.pop("gas")), **values)


def set_filling(obj, filling) -> None:
    """Write a filling into the object's properties."""
    options = FillingOptions(filling.gas.name, filling.temperature, filling.air_temperature, filling.altitude)
    names = [option.name for option in options_of(FillingOptions)]
    if filling.gas.name != WARM_AIR:
        names.remove("gas_temperature")
    write_options(obj, options, FillingOptions, *names)


def pattern_options(obj):
    """How the pattern of a balloon is made, `PatternOptions`; the usual way where it has none yet."""
    from BalloonWorkbench.app import pattern
    from BalloonWorkbench.core.options.pattern import PatternOptions

    for other in obj.InList:
        if is_pattern(other) and other.Balloon == obj:
            return pattern.values(other)
    return PatternOptions()


def show_lift(obj) -> None:
    """Weight and lift of the balloon that is shown, for film, gas and pattern as they are now."""
    from BalloonWorkbench.app.properties.film import read
    from BalloonWorkbench.app.properties.quantities import cubic_metres, metres, pascals
    from BalloonWorkbench.core.design.size_goal import Buoyancy, Scaling
    from BalloonWorkbench.core.units import to_grams, to_mm

    own = read(obj)
    inside, area, valve = _film_areas(obj, own)
    lightness = filling(obj).lightness(pascals(obj.ActivePressure))
    buoyancy = Buoyancy(lightness, own.areal_density, lambda seam: 0.5 * area, valve)
    width = metres(obj.InflatedWidth)
    size = max(width, metres(obj.InflatedHeight))
    scaling = Scaling(size, cubic_metres(obj.Volume), 0.5 * inside, 0.5 * (area - inside))
    lift, scale = scaling.lift_at(1.0, buoyancy), scaling.floating(buoyancy)
    figures = {
        "Weight": to_grams(scaling.weight_at(1.0, buoyancy)),
        "Lift": to_grams(lift),
        "Floats": lift > 0.0,
        "FloatsFrom": 0.0 if scale is None else to_mm(width * scale),
    }
    for name, value in figures.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)


def _film_areas(obj, own) -> tuple[float, float, float]:
    """Film inside the seams and all that is cut of it, of all panels [m2], and what a valve weighs [kg]."""
    from functools import partial

    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.making.weight import film_and_valve
    from BalloonWorkbench.core.pattern.make import make_pattern

    title, options = f"Weighing {obj.Label}", pattern_options(obj)
    if obj.FlatPanels:
        return _of_many_panels(obj, own, options, title)
    seam = part_shapes.stored(obj, "Seam")
    weigh = partial(film_and_valve, seam, own, options)
    known = film_and_valve.knows(seam, own, options) or make_pattern.knows(seam, own.seal_width, options)
    area, valve = weigh() if known else hooks.run_blocking(title, lambda progress: weigh())
    return 2.0 * seam.area, 2.0 * area, valve


def _of_many_panels(obj, own, options, title: str) -> tuple[float, float, float]:
    """The same of many panels; without their welds where the pattern, which says why, cannot be made."""
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.app.properties.quantities import number
    from BalloonWorkbench.app.shapes.bag_shapes import bag_from
    from BalloonWorkbench.core.bag_pattern.make import bag_patterns
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.making.trade_figures import making
    from BalloonWorkbench.core.units import MILLIMETRE

    inside = number(obj.FilmArea) * MILLIMETRE**2
    try:
        patterns = hooks.ask(title, bag_patterns, bag_from(obj.FlatPanels), own, options)
    except InputError:
        return inside, inside, 0.0
    strips = sum(piece.film_area for piece in patterns.pieces[patterns.caps :])
    return inside, patterns.film_area, making().valve_film * strips
