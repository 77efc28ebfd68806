# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making balloons in a document: for commands, for macros and for the command line."""

from __future__ import annotations

import os
from contextlib import ExitStack
from typing import NamedTuple

import FreeCAD as App

from BalloonWorkbench.app import film, hooks, status
from BalloonWorkbench.app.balloon import BACKENDS, FIT, INFLATE, BalloonProxy
from BalloonWorkbench.app.outline import OutlineProxy, set_drawing
from BalloonWorkbench.app.pattern import PatternProxy
from BalloonWorkbench.core.errors import InputError


class Parts(NamedTuple):
    """The three objects of one balloon."""

    outline: object
    balloon: object
    pattern: object


def make(doc, label: str = "Balloon") -> Parts:
    """The three objects, linked and in a group of their own, still without a drawing; nothing is computed."""
    group = doc.addObject("App::DocumentObjectGroup", "BalloonGroup")
    group.Label = label
    parts = Parts(
        doc.addObject("Part::Part2DObjectPython", "Outline"),
        doc.addObject("Mesh::FeaturePython", "Balloon"),
        doc.addObject("Part::Part2DObjectPython", "Pattern"),
    )
    for obj, proxy in zip(parts, (OutlineProxy, BalloonProxy, PatternProxy), strict=True):
        proxy(obj)
        hooks.dress(obj)
        group.addObject(obj)
    parts.balloon.Outline = parts.outline
    parts.pattern.Balloon = parts.balloon
    return parts


def balloon_from_picture(doc, path, width=None, height=None, **options) -> Parts:
    """A balloon from a picture, SVG, DXF or JSON file.

    doc            document
    path           the file; a copy is kept in the document
    width, height  number of mm, quantity or text such as "300 mm"; pictures need one of them
    options        see `configure`

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
    parts: Parts,
    *,
    material=None,
    pressure=None,
    mesh_size=None,
    correct: bool = True,
    backend: str | None = None,
    intake: bool = True,
) -> None:
    """Set the values of a balloon; those not given keep their defaults.

    material   a name of the film library, or a core Film with values of your own
    pressure   kPa, quantity or text such as "20 mbar"
    mesh_size  mm, quantity or text
    correct    fit the pattern to the drawing, or inflate the drawing as it is
    backend    "native", "numpy" or None for the best there is

    Raises InputError for an unknown material or backend and for text that is no quantity.
    """
    from BalloonWorkbench.app import quantities

    obj = parts.balloon
    if material is not None:
        film.choose(obj, material)
    if pressure is not None:
        obj.Pressure = quantities.pressure(pressure)
    if mesh_size is not None:
        obj.MeshSize = quantities.length(mesh_size)
    obj.Mode = FIT if correct else INFLATE
    choices = [name for name, known in BACKENDS.items() if known == backend]
    if not choices:
        raise InputError(f'There is no backend "{backend}": choose "native" or "numpy", or leave it out.')
    obj.Backend = choices[0]
    parts.pattern.Intake = intake


def discard(parts: Parts) -> None:
    """Take the objects and their group out of the document."""
    group = parts.balloon.getParentGroup()
    for obj in (*reversed(parts), group):
        obj.Document.removeObject(obj.Name)


def place_beside(parts: Parts) -> None:
    """Lay the pattern to the right of the drawing, in its plane."""
    gap = 0.1 * parts.pattern.PatternWidth.Value
    shift = _own_extent(parts.outline).XMax + gap - _own_extent(parts.pattern).XMin
    parts.pattern.Placement = parts.outline.Placement * App.Placement(App.Vector(shift, 0, 0), App.Rotation())


def _own_extent(obj):
    """Bounding box in the object's own coordinates."""
    shape = obj.Shape.copy()
    shape.Placement = App.Placement()
    return shape.BoundBox


def _finish(parts: Parts, options) -> None:
    configure(parts, **options)
    compute(parts)


def compute(parts: Parts) -> None:
    """Compute a new balloon and lay its pattern beside it; InputError with the reason when there is none."""
    parts.balloon.Document.recompute()
    for obj in parts:
        if not status.is_ready(obj):
            raise InputError(status.problem(obj))
    place_beside(parts)
    parts.balloon.Document.recompute()


def _size(name: str, value) -> float:
    """mm; 0 for None. FreeCAD would quietly turn a negative length into 0."""
    from BalloonWorkbench.app.quantities import length

    size = 0.0 if value is None else length(value)
    if value is not None and not size > 0.0:
        raise InputError(f"The {name} is {size:g} mm: give one above 0, for example 300 mm.")
    return size
