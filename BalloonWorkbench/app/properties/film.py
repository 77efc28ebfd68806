# SPDX-License-Identifier: LGPL-2.1-or-later
"""The film of a balloon object: a material of the library, or the user's own numbers."""

from __future__ import annotations

from BalloonWorkbench.app.properties.property_table import (
    options_from,
    properties_of,
    result,
    show_in_editor,
    write_options,
)
from BalloonWorkbench.core.options.film import DEFAULT_FILM, UNKNOWN, FilmOptions, MaterialOptions
from BalloonWorkbench.core.options.option import option_of

CUSTOM = "Custom"
PROPERTIES = (
    *(item._replace(entries=None) for item in properties_of(MaterialOptions)),  # see `offer`
    *properties_of(FilmOptions),
    result("String", "Material", "FreeCAD's material card that the values were taken from", group="Film"),
)
#: How its panels are joined, and whether a laser may cut it.
_JOINING = ("joining", "one_side", "laser")
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

    own = {}
    for path in data_files(own_folder):
        try:
            own[path.stem] = read_film(path)
        except InputError as error:
            hooks.report(error)
    return own


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
        write_options(obj, known, FilmOptions, *_JOINING)


def protect(obj) -> None:
    """Make the values editable for Custom only."""
    show_in_editor(obj, **dict.fromkeys(VALUES, "edit" if obj.Film == CUSTOM else "show"))


def write(obj, film) -> None:
    """The film's values, into the object's properties."""
    write_options(obj, film, FilmOptions)


def take_joining(obj, joining: str, one_side: bool, laser: bool | None) -> None:
    """What a card says of these, by the core's names; what is not known there is unknown."""
    known = option_of(FilmOptions, "joining").titles
    said = FilmOptions(joining=joining if joining in known else "", one_side=one_side, laser=laser)
    write_options(obj, said, FilmOptions, *_JOINING)


#: What a film of the library has beyond the properties that a user may change.
_OF_KNOWN = ("name", "max_stress", "title", "look", "grain", "weld_rigidity_source")
_OF_KNOWN += ("sealing_side", "joining", "one_side", "some_grades", "laser", "start_values")


def read(obj):
    """The object's film: its own numbers, the name and strength of the material they came from.

    Raises InputError for numbers that no film can have.
    """
    from dataclasses import replace

    from BalloonWorkbench.core.film.library import custom_film, with_grain, with_weld

    values = dict(vars(options_from(obj, FilmOptions)))
    elastic = (values.pop(name) or 0.0 for name in ("young_modulus", "poisson_ratio", "thickness"))
    own = custom_film(*elastic, values.pop("areal_density"))
    across, angle = values.pop("young_modulus_across"), values.pop("grain_angle")
    own = with_weld(own, values.pop("weld_rigidity") or 0.0)
    own = replace(own, **values)
    if obj.Material:
        own = replace(own, title=obj.Material)
    if across:
        own = with_grain(own, across, angle)
    known = known_films().get(obj.Film)
    if known is None:
        return own
    return replace(
        own,
        **{name: getattr(known, name) for name in _OF_KNOWN},
    )
