# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making balloons in a document: for commands, for macros and for the command line."""

from __future__ import annotations

import os
from contextlib import ExitStack

from BalloonWorkbench.app import balloon, pattern
from BalloonWorkbench.app.bag import BagProxy, set_file, set_panels
from BalloonWorkbench.app.balloon import BalloonProxy
from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.document import arrange, panel_objects
from BalloonWorkbench.app.document.kinds import is_pattern
from BalloonWorkbench.app.document.parts import Parts, companions
from BalloonWorkbench.app.document.sources import insist_on_document
from BalloonWorkbench.app.gored_body import NATURAL_SHAPE, GoredBodyProxy, set_profile
from BalloonWorkbench.app.group import BAG, GORED_BODY, MEMBERS, OUTLINE, TARGET, make_group, name_group
from BalloonWorkbench.app.outline import OutlineProxy, set_drawing, shape_count
from BalloonWorkbench.app.pattern import PatternProxy
from BalloonWorkbench.app.properties import film, ready_bodies
from BalloonWorkbench.app.properties.property_table import write_options
from BalloonWorkbench.app.target import TargetProxy, set_body
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.simulation import InflationOptions
from BalloonWorkbench.core.units import number_text

#: What a balloon may be made from: the kind of the document object and its behaviour, by its name.
SOURCES = {
    OUTLINE: ("Part::Part2DObjectPython", OutlineProxy),
    GORED_BODY: ("Part::FeaturePython", GoredBodyProxy),
    BAG: ("Part::Part2DObjectPython", BagProxy),
    TARGET: ("Part::FeaturePython", TargetProxy),
}


def make(doc, label: str = "Film balloon", source: str = OUTLINE) -> Parts:
    """The three objects, linked and in a group of their own, still without a drawing; nothing is computed.

    source  what it is made from, of SOURCES
    """
    parts = _make_in(make_group(doc), source)
    name_group(parts.balloon.getParentGroup(), label)
    return parts


def _make_in(group, source: str = OUTLINE) -> Parts:
    doc = group.Document
    kind, behaviour = SOURCES[source]
    kinds, names = (kind, "Mesh::FeaturePython", "Part::Part2DObjectPython"), (source, *MEMBERS[1:])
    parts = Parts(*(doc.addObject(kind, name) for kind, name in zip(kinds, names, strict=True)))
    for obj, proxy in zip(parts, (behaviour, BalloonProxy, PatternProxy), strict=True):
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
    parts = make(doc, _title(path))
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
            panel_objects.remove_all(other.pattern)
            for obj in reversed(other):
                obj.Document.removeObject(obj.Name)
        else:
            _follow(parts, other)
    add_companions(parts)


def balloon_from_sketch(doc, sketch, elements=(), **options) -> Parts:
    """A balloon that follows a sketch, wire or face; elements such as ["Face6"] pick a part of it.

    Options and errors as for `balloon_from_picture`.
    """
    insist_on_document(doc, sketch)
    parts = make(doc, f"{sketch.Label} balloon")
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        parts.outline.Source = (sketch, list(elements))
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def balloon_from_profile(doc, source, elements=(), **options) -> Parts:
    """A balloon of gores from a profile: a sketch or wire, the path of a file, or None for the natural shape.

    elements  names of parts of a sketch or wire; none means the whole

    Options and errors as for `balloon_from_picture`.
    """
    is_file = isinstance(source, (str, os.PathLike))
    label = "Natural shape" if source is None else _title(source) if is_file else f"{source.Label} body"
    if is_file and not os.path.isfile(source):
        raise InputError(f"There is no file {source}: check the name and the folder.")
    if not is_file and source is not None:
        insist_on_document(doc, source)
    parts = make(doc, label, GORED_BODY)
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        if source is None:
            parts.outline.ProfileFrom = NATURAL_SHAPE
        elif is_file:
            set_profile(parts.outline, source)
        else:
            parts.outline.Source = (source, list(elements))
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def balloon_from_panels(doc, source, seams=(), **options) -> Parts:
    """A balloon of flat panels as they are.

    source  the path of a JSON file, the name of a ready body, or a list of sketches, wires and pairs of an
            object and the names of its flat faces
    seams   of sketches and faces: which edges are joined, as texts "Sketch.Edge1=Sketch001.Edge3"

    Options and errors as for `balloon_from_picture`.
    """
    is_text = isinstance(source, (str, os.PathLike))
    ready = ready_bodies.called(source) if isinstance(source, str) else None
    if is_text and not ready and not os.path.isfile(source):
        raise InputError(f"There is no file {source}, and no such ready body: check the name and the folder.")
    parts = make(doc, ready if ready else _title(source) if is_text else "Bag of panels", BAG)
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        if ready:
            parts.outline.Ready = ready
        elif is_text:
            set_file(parts.outline, source)
        else:
            for panel in source:
                insist_on_document(doc, panel[0] if isinstance(panel, tuple) else panel)
            set_panels(parts.outline, source)
            parts.outline.Seams = list(seams)
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def balloon_from_body(doc, source, **options) -> Parts:
    """A balloon that fills a closed body: a solid or a mesh of the document, or the path of a file.

    Options and errors as for `balloon_from_picture`.
    """
    is_file = isinstance(source, (str, os.PathLike))
    if is_file and not os.path.isfile(source):
        raise InputError(f"There is no file {source}: check the name and the folder.")
    if not is_file and not hasattr(source, "Label"):
        raise InputError(f"{source} is no body: give a solid, a mesh or the path of a file.")
    if not is_file:
        insist_on_document(doc, source)
    parts = make(doc, _title(source) if is_file else f"{source.Label} balloon", TARGET)
    with ExitStack() as unless_finished:
        unless_finished.callback(discard, parts)
        if is_file:
            set_body(parts.outline, source)
        else:
            parts.outline.Solid = source
        _finish(parts, options)
        unless_finished.pop_all()
    return parts


def _title(path) -> str:
    """What a file is called, without its ending."""
    return os.path.splitext(os.path.basename(path))[0]


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
    for pattern_obj in [obj for obj in (*others, parts.pattern) if is_pattern(obj)]:
        panel_objects.remove_all(pattern_obj)
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
