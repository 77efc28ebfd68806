# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making balloons in a document: for commands, for macros and for the command line."""

from __future__ import annotations

import os
from contextlib import ExitStack

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.balloon import BalloonProxy
from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.document import arrange
from BalloonWorkbench.app.document.parts import Parts, companions
from BalloonWorkbench.app.group import MEMBERS, make_group, name_group
from BalloonWorkbench.app.outline import OutlineProxy, set_drawing, shape_count
from BalloonWorkbench.app.pattern import PatternProxy
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.app.properties.property_table import write_options
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.simulation import InflationOptions
from BalloonWorkbench.core.units import number_text


def make(doc, label: str = "Film balloon") -> Parts:
    """The three objects, linked and in a group of their own, still without a drawing; nothing is computed."""
    parts = _make_in(make_group(doc))
    name_group(parts.balloon.getParentGroup(), label)
    return parts


def _make_in(group) -> Parts:
    doc = group.Document
    kinds = "Part::Part2DObjectPython", "Mesh::FeaturePython", "Part::Part2DObjectPython"
    parts = Parts(*(doc.addObject(kind, name) for kind, name in zip(kinds, MEMBERS, strict=True)))
    for obj, proxy in zip(parts, (OutlineProxy, BalloonProxy, PatternProxy), strict=True):
        proxy(obj)
        hooks.attach_view(obj)
        group.addObject(obj)
    parts.balloon.Outline = parts.outline
    parts.pattern.Balloon = parts.balloon
    for obj in (parts.outline, parts.pattern):
        arrange.place_when_ready(obj)
    return parts


def balloon_from_picture(doc, path, width=None, height=None, **options) -> Parts:
    """A balloon from a picture, SVG, DXF or JSON file.

    doc            document
    path           the file; a copy is kept in the document
    width, height  number of mm, quantity or text such as "300 mm"; pictures need one of them
    options        see `configure`

    A drawing with several shapes makes a balloon for each, see `companions`; the largest one is returned.
    Raises BalloonError when no balloon comes out; the document is then as before.
    """
    sizes = [_size(name, value) for name, value in (("width", width), ("height", height))]
    if not os.path.isfile(path):
        raise InputError(f"There is no file {path}: check the name and the folder.")
    parts = make(doc, os.path.splitext(os.path.basename(path))[0])
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        set_drawing(parts.outline, path)
        parts.outline.Width, parts.outline.Height = sizes
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def add_companions(parts: Parts) -> list[Parts]:
    """Balloons for the other shapes of a drawing, in the same group, with the values of the first one.

    They share its drawing: another width or file changes all of them. Nothing is computed. A drawing that
    cannot be read has no other shapes.
    """
    group, first = parts.balloon.getParentGroup(), parts.outline
    made = []
    present = {other.outline.Part for other in companions(parts)}
    for number in range(2, shape_count(first) + 1):
        if number in present:
            continue
        other = _make_in(group)
        for mine, its in zip(parts, other, strict=True):
            its.Label = f"{mine.Label} {number}"
        other.outline.Leader, other.outline.Part = first, number
        _follow(parts, other)
        made.append(other)
    return made


def match_companions(parts: Parts) -> None:
    """Bring the other balloons of a drawing in line with it: one for each shape, with the first one's values.

    Nothing is computed; a drawing that cannot be read changes nothing.
    """
    count = shape_count(parts.outline)
    for other in companions(parts):
        if 0 < count < other.outline.Part:
            for obj in reversed(other):
                obj.Document.removeObject(obj.Name)
        else:
            _follow(parts, other)
    add_companions(parts)


def balloon_from_sketch(doc, sketch, elements=(), **options) -> Parts:
    """A balloon that follows a sketch, wire or face; elements such as ["Face6"] pick a part of it.

    Options and errors as for `balloon_from_picture`.
    """
    parts = make(doc, f"{sketch.Label} balloon")
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        parts.outline.Source = (sketch, list(elements))
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def configure(
    parts: Parts, *, material=None, correct: bool = True, values: dict | None = None, **named
) -> None:
    """Set the values of a balloon; those not given keep their defaults.

    material  a name of the film library, or a core Film with values of your own
    correct   fit the pattern to the drawing, or inflate the drawing as it is
    values    others by name, as those after them: see app/properties/values.py

    Raises InputError for what a value cannot be.
    """
    from BalloonWorkbench.app.properties.values import assign

    if material is not None:
        film.choose(parts.balloon, material)
    write_options(parts.balloon, InflationOptions(correct=correct), InflationOptions, "correct")
    assign(parts, named | (values or {}))


def discard(parts: Parts) -> None:
    """Take the objects and their group out of the document."""
    group = parts.balloon.getParentGroup()
    others = [obj for other in reversed(companions(parts)) for obj in reversed(other)]
    for obj in (*others, *reversed(parts), group):
        obj.Document.removeObject(obj.Name)


def _finish(parts: Parts, options) -> None:
    configure(parts, **options)
    compute(parts, *add_companions(parts))


def compute(*balloons: Parts, pause=bool) -> None:
    """Compute new balloons of a drawing; InputError where there is none.

    pause is called between the steps of the work.
    """
    doc = balloons[0].balloon.Document
    doc.recompute()
    pause()
    for obj in (obj for parts in balloons for obj in parts):
        if not status.is_ready(obj):
            raise InputError(status.problem(obj))


def _size(name: str, value) -> float:
    """mm; 0 for None. FreeCAD would quietly turn a negative length into 0."""
    from BalloonWorkbench.app.properties.quantities import length

    size = 0.0 if value is None else length(value)
    if value is not None and not size > 0.0:
        raise InputError(f"The {name} is {number_text(size)} mm: give one above 0, for example 300 mm.")
    return size


def _follow(parts: Parts, other: Parts) -> None:
    """Give a balloon the wanted values of another one of the same drawing."""
    for source, target, properties in (
        (parts.balloon, other.balloon, balloon.PROPERTIES),
        (parts.pattern, other.pattern, pattern.PROPERTIES),
    ):
        for item in properties:
            if item.result or item.type == "Link":
                continue
            value = getattr(source, item.name)
            if getattr(target, item.name) != value:
                setattr(target, item.name, value)
