# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of a balloon object: a material of the library, or the user's own numbers."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import Property, show_in_editor

CUSTOM = "Custom"
UNKNOWN = "Unknown"
#: How panels are joined, by the core's names; what may be done with a laser, by the core's values.
_JOININGS = {
    "": UNKNOWN,
    "heat": "Heat",
    "high-frequency": "High frequency",
    "glue": "Glue",
    "tape": "Tape",
}
_LASER = {None: UNKNOWN, True: "May be cut", False: "Never"}
CHOICES = {"Joining": list(_JOININGS.values()), "Laser": list(_LASER.values())}

PROPERTIES = (
    Property(
        "Enumeration", "Film", "Film", "What the balloon is made of; Custom lets you give your own values"
    ),
    Property("Pressure", "YoungModulus", "Film", "Young's modulus of the film"),
    Property(
        "FloatConstraint", "PoissonRatio", "Film", "Poisson's ratio of the film", (0.3, 0.0, 0.49, 0.01)
    ),
    Property(
        "Pressure",
        "YoungModulusAcross",
        "Film",
        "Young's modulus across the grain; 0 means no grain",
    ),
    Property("Angle", "GrainAngle", "Film", "Direction of the grain, from the x axis of the drawing"),
    Property("Length", "Thickness", "Film", "Thickness of the film"),
    Property("Float", "ArealDensity", "Film", "Weight of the film in kg per square metre"),
    Property("Length", "SealWidth", "Film", "Width of the weld that this film needs"),
    Property("Enumeration", "Joining", "Film", "How two panels of this film are joined"),
    Property("Bool", "OneSided", "Film", "Only one side of this film can be joined so", False),
    Property("Enumeration", "Laser", "Film", "Whether a laser may cut this film"),
    Property(
        "String",
        "SealingSide",
        "Film",
        "Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known",
    ),
    Property(
        "Pressure", "Strength", "Film", "Tension over the section at which the film tears; 0: not known"
    ),
    Property(
        "String", "Material", "Film", "FreeCAD's material card that the values were taken from", result=True
    ),
)
#: What a film gives to the object.
VALUES = tuple(item.name for item in PROPERTIES if item.name not in ("Film", "Material"))


def names() -> list[str]:
    """The films that are known here, then Custom."""
    return [*known_films(), CUSTOM]


def known_films() -> dict:
    """Those of the library, then the user's own, by name.

    Own ones are files like the library's, in the folder BalloonWorkbench/films of FreeCAD's user data.
    """
    from BalloonWorkbench.core.film.library import films

    return {**films(), **{name: film for name, film in _own_films().items() if name not in films()}}


def own_folder():
    """Where the user's films are."""
    from pathlib import Path

    import FreeCAD as App

    return Path(App.getUserAppDataDir()) / "BalloonWorkbench" / "films"


def _own_films() -> dict:
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.files.data_file import data_files
    from BalloonWorkbench.core.film.library import read_film

    found = {}
    for path in data_files(own_folder):
        try:
            found[path.stem] = read_film(path)
        except InputError as error:
            hooks.report(error)
    return found


def offer(obj) -> None:
    """Offer films that became known since the object was made; its values stay."""
    entries, chosen = names(), obj.Film
    if chosen not in entries:
        entries.insert(-1, chosen)
    if obj.getEnumerationsOfProperty("Film") != entries:
        values = {name: getattr(obj, name) for name in VALUES}
        obj.Film = entries
        obj.Film = chosen
        for name, value in values.items():
            if getattr(obj, name) != value:
                setattr(obj, name, value)


def set_choices(obj) -> None:
    """Offer the library's materials in a new object."""
    from BalloonWorkbench.core.film.library import DEFAULT_FILM

    obj.Film = names()
    obj.Film = DEFAULT_FILM


def choose(obj, material) -> None:
    """Take a material by its name in the library, or a Film with its values; InputError for unknown names."""
    from BalloonWorkbench.core.film.library import film

    if isinstance(material, str):
        obj.Film = material if material in known_films() else film(material).name
    elif known_films().get(material.name) == material:
        obj.Film = material.name
    else:
        obj.Film = CUSTOM
        write(obj, material)


def follow_choice(obj) -> None:
    """Copy the chosen material's values into the object and protect them; Custom leaves them to the user."""
    if any(name not in obj.PropertiesList for name in VALUES):
        return  # the object is being made
    known = known_films().get(obj.Film)
    if known is not None:
        write(obj, known)
        obj.Material = ""
    protect(obj)


def complete(obj) -> None:
    """Tell how the film of an older object is joined."""
    known = known_films().get(obj.Film)
    if known is not None and (obj.Joining, obj.Laser) == (UNKNOWN, UNKNOWN):
        _write_joining(obj, known)


def protect(obj) -> None:
    """Make the values editable for Custom only."""
    show_in_editor(obj, **dict.fromkeys(VALUES, "edit" if obj.Film == CUSTOM else "show"))


def write(obj, film) -> None:
    """The film's values, into the object's properties."""
    from math import degrees

    from BalloonWorkbench.app.properties.quantities import kilopascals
    from BalloonWorkbench.core.units import to_mm

    obj.YoungModulus = kilopascals(film.young_modulus)
    obj.PoissonRatio = film.poisson_ratio
    obj.YoungModulusAcross = kilopascals(film.young_modulus_across or 0.0)
    obj.GrainAngle = degrees(film.grain_angle)
    obj.Thickness = to_mm(film.thickness)
    obj.ArealDensity = film.areal_density
    obj.SealWidth = to_mm(film.seal_width)
    obj.Strength = kilopascals(film.max_stress or 0.0)
    obj.SealingSide = film.sealing_side or ""
    _write_joining(obj, film)


def _write_joining(obj, film) -> None:
    obj.Joining, obj.OneSided, obj.Laser = _JOININGS[film.joining], film.one_side, _LASER[film.laser]


def take_joining(obj, joining: str, one_side: bool, laser: bool | None) -> None:
    """What a card says of these, by the core's names; what is not known there is unknown."""
    obj.Joining, obj.OneSided, obj.Laser = _JOININGS.get(joining, UNKNOWN), one_side, _LASER[laser]


#: What a film of the library has beyond the properties that a user may change.
_OF_KNOWN = ("name", "max_stress", "title", "look", "grain")
_OF_KNOWN += ("sealing_side", "joining", "one_side", "some_grades", "laser")


def read(obj):
    """The object's film: its own numbers, the name and strength of the material they came from.

    Raises InputError for numbers that no film can have.
    """
    from dataclasses import replace

    from BalloonWorkbench.app.properties.quantities import metres, pascals, radians
    from BalloonWorkbench.core.film.library import custom_film, with_grain

    own = custom_film(
        pascals(obj.YoungModulus), obj.PoissonRatio, metres(obj.Thickness), obj.ArealDensity or None
    )
    strength = pascals(obj.Strength) or None
    own = replace(
        own,
        seal_width=metres(obj.SealWidth),
        max_stress=strength,
        sealing_side=obj.SealingSide.strip() or None,
        joining=next(name for name, title in _JOININGS.items() if title == obj.Joining),
        one_side=obj.OneSided,
        laser=next(value for value, title in _LASER.items() if title == obj.Laser),
    )
    if obj.Material:
        own = replace(own, title=obj.Material)
    across = pascals(obj.YoungModulusAcross)
    if across:
        own = with_grain(own, across, radians(obj.GrainAngle))
    known = known_films().get(obj.Film)
    if known is None:
        return own
    return replace(
        own,
        **{name: getattr(known, name) for name in _OF_KNOWN},
    )
