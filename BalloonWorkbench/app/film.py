# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of a balloon object: a material of the library, or the user's own numbers."""

from __future__ import annotations

from BalloonWorkbench.app.properties import Property, show_in_editor

CUSTOM = "Custom"

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
)
_VALUES = tuple(item.name for item in PROPERTIES if item.name != "Film")


def names() -> list[str]:
    """The materials of the library, then Custom."""
    from BalloonWorkbench.core.film.library import films

    return [*films(), CUSTOM]


def set_choices(obj) -> None:
    """Offer the library's materials in a new object."""
    from BalloonWorkbench.core.film.library import DEFAULT_FILM

    obj.Film = names()
    obj.Film = DEFAULT_FILM


def choose(obj, material) -> None:
    """Take a material by its name in the library, or a Film with its values; InputError for unknown names."""
    from BalloonWorkbench.core.film.library import film, films

    if isinstance(material, str):
        obj.Film = film(material).name
    elif films().get(material.name) == material:
        obj.Film = material.name
    else:
        obj.Film = CUSTOM
        write(obj, material)


def follow_choice(obj) -> None:
    """Copy the chosen material's values into the object and protect them; Custom leaves them to the user."""
    if any(name not in obj.PropertiesList for name in _VALUES):
        return  # the object is being made
    if obj.Film != CUSTOM:
        from BalloonWorkbench.core.film.library import film

        write(obj, film(obj.Film))
    protect(obj)


def protect(obj) -> None:
    """Make the values editable for Custom only."""
    show_in_editor(obj, **dict.fromkeys(_VALUES, "edit" if obj.Film == CUSTOM else "show"))


def write(obj, film) -> None:
    """The film's values, into the object's properties."""
    from math import degrees

    from BalloonWorkbench.app.quantities import kilopascals
    from BalloonWorkbench.core.units import to_mm

    obj.YoungModulus = kilopascals(film.young_modulus)
    obj.PoissonRatio = film.poisson_ratio
    obj.YoungModulusAcross = kilopascals(film.young_modulus_across or 0.0)
    obj.GrainAngle = degrees(film.grain_angle)
    obj.Thickness = to_mm(film.thickness)
    obj.ArealDensity = film.areal_density
    obj.SealWidth = to_mm(film.seal_width)


def read(obj):
    """The object's film: its own numbers, the name and strength of the material they came from.

    Raises InputError for numbers that no film can have.
    """
    from dataclasses import replace

    from BalloonWorkbench.app.quantities import metres, pascals, radians
    from BalloonWorkbench.core.film.library import custom_film, films, with_grain

    own = custom_film(
        pascals(obj.YoungModulus), obj.PoissonRatio, metres(obj.Thickness), obj.ArealDensity or None
    )
    own = replace(own, seal_width=metres(obj.SealWidth))
    across = pascals(obj.YoungModulusAcross)
    if across:
        own = with_grain(own, across, radians(obj.GrainAngle))
    known = films().get(obj.Film)
    return (
        own
        if known is None
        else replace(own, name=known.name, max_stress=known.max_stress, title=known.title)
    )
