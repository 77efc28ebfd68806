# SPDX-License-Identifier: LGPL-2.1-or-later
"""What decides a balloon's size, and what it weighs and carries.

The Outline has the width that was drawn. A balloon with a goal is that drawing made larger or smaller about
its origin: the Outline stays as it is, the Balloon and its Pattern have the size that meets the goal.
"""

from __future__ import annotations

from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.properties.property_table import Property, show_in_editor
from BalloonWorkbench.core.recent import Recent

WIDTH, VOLUME, LIFT = "Width", "Volume", "Lift"
GASES = {"Helium": "helium", "Hydrogen": "hydrogen", "Warm air": "warm-air"}
CHOICES = {"SizeGoal": [WIDTH, VOLUME, LIFT], "Gas": list(GASES)}

PROPERTIES = (
    Property(
        "Enumeration",
        "SizeGoal",
        "Size",
        "What decides the size: the outline as it is, a volume to hold or a load to carry",
    ),
    Property("Volume", "GoalVolume", "Size", "Volume that decides the size"),
    Property(
        "Float", "GoalLift", "Size", "What it shall carry besides itself, in grams; 0 makes it float just so"
    ),
    Property("Enumeration", "Gas", "Filling", "What fills it when it shall float"),
    Property("Float", "GasTemperature", "Filling", "Of warm air, in degrees Celsius", 80.0),
    Property("Float", "AirTemperature", "Filling", "Around the balloon, in degrees Celsius", 20.0),
    Property("Distance", "Altitude", "Filling", "Height above the sea"),
)
RESULTS = (
    Property("Float", "Weight", "Result", "Film of both panels with weld and intake, in grams", result=True),
    Property(
        "Float", "Lift", "Result", "What it carries with its gas, in grams; below 0 it sinks", result=True
    ),
    Property("Bool", "Floats", "Result", "It carries itself", result=True),
    Property(
        "Length", "FloatsFrom", "Result", "Width from which it carries itself; 0 when never", result=True
    ),
)


_weights = Recent(8)


def follow(obj) -> None:
    """Offer only what has an effect."""
    show_in_editor(
        obj,
        GoalVolume="edit" if obj.SizeGoal == VOLUME else "hide",
        GoalLift="edit" if obj.SizeGoal == LIFT else "hide",
        # an older object that is just being completed has no gas yet
        GasTemperature="edit" if GASES.get(obj.Gas) == "warm-air" else "hide",
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


def filling(obj):
    """The gas and the air around it."""
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.film.filling import ZERO_CELSIUS, Filling, gas

    name = GASES[obj.Gas]
    return Filling(
        gas(name),
        obj.GasTemperature + ZERO_CELSIUS if name == "warm-air" else None,
        obj.AirTemperature + ZERO_CELSIUS,
        metres(obj.Altitude),
    )


def set_filling(obj, wanted) -> None:
    """Write a filling into the object's properties."""
    from BalloonWorkbench.core.film.filling import ZERO_CELSIUS
    from BalloonWorkbench.core.units import to_mm

    obj.Gas = next(title for title, name in GASES.items() if name == wanted.gas.name)
    if wanted.gas.name == "warm-air":
        obj.GasTemperature = wanted.temperature - ZERO_CELSIUS
    obj.AirTemperature = wanted.air_temperature - ZERO_CELSIUS
    obj.Altitude = to_mm(wanted.altitude)


def wanted_of(obj):
    """How the pattern of a balloon is made, as the core's `Wanted`; the usual way where it has none yet."""
    from BalloonWorkbench.app import pattern

    for other in obj.InList:
        if is_pattern(other) and other.Balloon == obj:
            return pattern.values(other)
    return pattern.usual_values()


def film_and_valve(seam, film, wanted) -> tuple[float, float]:
    """As the core's; those of the last seams are remembered."""
    from BalloonWorkbench.core.making import weight

    key = _weight_key(seam, film, wanted)
    if key not in _weights:
        _weights[key] = weight.film_and_valve(seam, film, wanted)
    return _weights[key]


def _weight_key(seam, film, wanted) -> tuple:
    from BalloonWorkbench.core.making.weight import weighing

    lines = tuple(line.tobytes() for line in (*seam.loops, *seam.welds))
    return lines, len(seam.spots), film.seal_width, weighing(wanted)


def prepare(seam, film, wanted) -> None:
    """Find in a thread what `show_lift` will ask for: the object keeps its seam in mm."""
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.units import from_mm, to_mm

    try:
        film_and_valve(seam.map(lambda line: from_mm(to_mm(line))), film, wanted)
    except InputError:  # `show_lift` will say what is wrong
        return


def show_lift(obj) -> None:
    """Weight and lift of the balloon that is shown, for film, gas and pattern as they are now."""
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.app.properties.film import read
    from BalloonWorkbench.app.properties.quantities import cubic_metres, metres, pascals
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.design.size_goal import Buoyancy, Scaling
    from BalloonWorkbench.core.units import to_grams, to_mm

    own, seam, wanted = read(obj), part_shapes.stored(obj, "Seam"), wanted_of(obj)
    if _weight_key(seam, own, wanted) in _weights:
        area, valve = film_and_valve(seam, own, wanted)
    else:
        area, valve = hooks.work(f"Weighing {obj.Label}", lambda progress: film_and_valve(seam, own, wanted))
    lightness = filling(obj).lightness(pascals(obj.ActivePressure))
    buoyancy = Buoyancy(lightness, own.areal_density, lambda seam: area, valve)
    width = metres(obj.InflatedWidth)
    size = max(width, metres(obj.InflatedHeight))
    scaling = Scaling(size, cubic_metres(obj.Volume), seam.area, area - seam.area)
    lift, scale = scaling.lift_at(1.0, buoyancy), scaling.floating(buoyancy)
    found = {
        "Weight": to_grams(scaling.weight_at(1.0, buoyancy)),
        "Lift": to_grams(lift),
        "Floats": lift > 0.0,
        "FloatsFrom": 0.0 if scale is None else to_mm(width * scale),
    }
    for name, value in found.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)
