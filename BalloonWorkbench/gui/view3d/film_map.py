# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon's results as colours on its film: the nodes of the 3D view and their legend."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_bag, is_outline
from BalloonWorkbench.app.engine import bag_result, film_result, maker
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.results import colour_map
from BalloonWorkbench.core.results.film_state import FilmState, State, film_state
from BalloonWorkbench.core.results.off_target import off_target
from BalloonWorkbench.core.results.result_files import Results, results
from BalloonWorkbench.core.units import number_text, percent_text, to_mm
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.view3d.legend import TOP, Legend, label_node
from BalloonWorkbench.gui.view3d.legend_row import OFF, legend_node, title
from BalloonWorkbench.gui.view3d.skin import SkinNodes, skin_from
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import lengths_text, pressure_text, user_unit

CHOICES = [OFF, *colour_map.KINDS]
_TITLES = {
    colour_map.TENSION: QT_TRANSLATE_NOOP("BalloonWorkbench", "Membrane tension"),
    colour_map.WRINKLES: QT_TRANSLATE_NOOP("BalloonWorkbench", "Width hidden in wrinkles"),
    colour_map.STATE: QT_TRANSLATE_NOOP("BalloonWorkbench", "Where the film wrinkles"),
    colour_map.THICKNESS: QT_TRANSLATE_NOOP("BalloonWorkbench", "Thickness of the balloon"),
    colour_map.STRAIN: QT_TRANSLATE_NOOP("BalloonWorkbench", "Largest strain"),
    colour_map.RESIDUAL: QT_TRANSLATE_NOOP("BalloonWorkbench", "Silhouette off the drawing"),
    colour_map.DISTANCE: QT_TRANSLATE_NOOP("BalloonWorkbench", "Distance from profile, drawing or body"),
}
#: Those of the film itself, which its flat panels have as well.
FLAT_CHOICES = [colour_map.TENSION, colour_map.WRINKLES, colour_map.STATE, colour_map.STRAIN]
_COLOURS = 256  # of the scale, as a texture
_LINE = 5.0  # px, of the silhouette
_GREY = (0.72, 0.74, 0.77)


@dataclass(frozen=True)
class FilmColours:
    """A result as colours, its legend, and what is written at its largest value."""

    map: colour_map.ColourMap
    legend: Legend
    largest: str


def choice_title(choice: str) -> str:
    """What people read for one of CHOICES."""
    return translate(_TITLES[choice]) if choice in _TITLES else translated(choice)


def choices_of(obj) -> list[str]:
    """Those of CHOICES that say something of a balloon object."""
    if not film_result.is_known(obj):
        return CHOICES
    kinds = colour_map.kinds_of(film_result.stored(obj)[0], compared=_is_compared(obj))
    return [choice for choice in CHOICES if choice == OFF or choice in kinds]


def map_nodes(obj, kind: str) -> list:
    """Nodes that show one kind of result of a balloon object; none where there is no such result.

    What the film can bear is told where it is known. Raises BalloonError.
    """
    from pivy import coin

    if not film_result.is_known(obj):
        return []
    inflation, film = film_result.stored(obj)
    if kind not in colour_map.kinds_of(inflation, compared=_is_compared(obj)):
        return []  # it says nothing of many panels, or of two
    if kind == colour_map.DISTANCE:
        return _distance_nodes(obj)
    skin, film_results = skin_from(inflation, film), results(inflation, film)
    missing = _missing(obj, film_results, kind)
    if missing:
        legend = Legend(_title(obj, kind, ""), notes=(missing,), warnings=warnings_of(obj))
        return [_film(SkinNodes(skin), [_matt(coin, _GREY)]), legend_node(obj, legend, TOP)]
    if kind == colour_map.RESIDUAL:
        return _residual_nodes(obj, inflation, skin)
    is_tension = kind == colour_map.TENSION
    safe = maker.safety_of(obj) if is_tension and maker.is_safety_known(obj) else None
    shown = _film_colours(obj, inflation, film, film_results, kind, safe)
    if is_tension and safe is None:
        waiting = (*shown.legend.notes, translate("safe to: is being worked out"))
        legend = replace(shown.legend, notes=waiting)
        return [_film(SkinNodes(skin, shown.map.shares), _scale_nodes()), legend_node(obj, legend, TOP)]
    nodes = [
        _film(SkinNodes(skin, shown.map.shares), _scale_nodes()),
        legend_node(obj, shown.legend, TOP),
    ]
    if shown.map.place is not None:
        nodes.append(label_node(shown.map.place, shown.largest))
    return nodes


def film_colours(obj, kind: str) -> FilmColours:
    """One of FLAT_CHOICES of a balloon that has a result, with its legend but for what it can bear, which
    takes long to work out. Raises BalloonError."""
    inflation, film = film_result.stored(obj)
    return _film_colours(obj, inflation, film, results(inflation, film), kind, None)


def _film_colours(obj, inflation, film, film_results: Results, kind: str, safe) -> FilmColours:
    drawn_map = colour_map.film_map(film_results, kind)
    if safe is not None:  # single triangles say more of the mesh than of the film
        drawn_map = replace(drawn_map, largest=safe.load.value, place=to_mm(safe.load.place))
    factor, unit = user_unit(drawn_map.unit, drawn_map.top)
    legend = Legend(
        _title(obj, kind, unit),
        () if kind == colour_map.STATE else _ticks(drawn_map.top * factor),
        _states(film_state(inflation, film)) if kind == colour_map.STATE else (),
        _notes(safe, drawn_map, factor, unit),
        warnings_of(obj),
    )
    name = f"{translated(safe.weakest)} " if safe is not None and safe.weakest else ""
    return FilmColours(drawn_map, legend, f"{name}{number_text(drawn_map.largest * factor)} {unit}")


def _missing(obj, film_results: Results, kind: str) -> str:
    """Why this kind of result is not known of this balloon; empty where it is."""
    if kind == colour_map.RESIDUAL and not is_outline(obj.Outline):
        return translate("no drawing to compare with")
    if kind == colour_map.THICKNESS and "thickness_mm" not in film_results.of_vertices:
        return translate("known of two equal panels alone")
    return ""


def _film(skin: SkinNodes, before):
    from pivy import coin

    node, rim, shape = coin.SoSeparator(), coin.SoSeparator(), coin.SoSeparator()
    light, colour = coin.SoLightModel(), coin.SoBaseColor()
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    colour.rgb.setValue(0.15, 0.15, 0.18)
    for child in (*before, skin.film):
        shape.addChild(child)
    for child in (light, colour, skin.seam):
        rim.addChild(child)
    node.addChild(shape)
    node.addChild(rim)
    return node


def _matt(coin, colour=(1.0, 1.0, 1.0)):
    """A material that keeps the colours of a scale: little shade, no shine."""
    material = coin.SoMaterial()
    material.ambientColor.setValue(*colour)
    material.diffuseColor.setValue(*(0.75 * part for part in colour))
    material.emissiveColor.setValue(*(0.25 * part for part in colour))
    material.specularColor.setValue(0.0, 0.0, 0.0)
    return material


def _scale_nodes() -> list:
    from pivy import coin

    texture = coin.SoTexture2()
    row = colour_map.colours(np.linspace(0.0, 1.0, _COLOURS))
    texture.image.setValue(coin.SbVec2s(_COLOURS, 1), 3, row.tobytes())
    texture.wrapS.setValue(coin.SoTexture2.CLAMP)
    texture.wrapT.setValue(coin.SoTexture2.CLAMP)
    return [_matt(coin), texture]


def _residual_nodes(obj, inflation, skin) -> list:
    """Grey film with its silhouette coloured by the distance from the drawing."""
    from pivy import coin

    deviations = colour_map.distances(inflation, film_result.drawing(obj))
    top = max(deviations.largest[2], 1e-9)
    front, style, light = coin.SoAnnotation(), coin.SoDrawStyle(), coin.SoLightModel()
    style.lineWidth.setValue(_LINE)
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    binding = coin.SoMaterialBinding()
    binding.value.setValue(coin.SoMaterialBinding.PER_VERTEX)
    for child in (style, light, binding):
        front.addChild(child)
    for loop, distance in zip(deviations.loops, deviations.distances):
        rgb = colour_map.colours(np.append(distance, distance[:1]) / top) / 255.0
        points, colours, line = coin.SoCoordinate3(), coin.SoMaterial(), coin.SoLineSet()
        corners = [(x, y, 0.0) for x, y in to_mm(ring(loop)).tolist()]
        points.point.setValues(0, len(corners), corners)
        colours.diffuseColor.setValues(0, len(corners), rgb.tolist())
        line.numVertices.setValue(len(corners))
        for child in (colours, points, line):
            front.addChild(child)
    factor, unit = user_unit("mm", top)
    notes = (translate("in the mean {}").format(*lengths_text(obj.ResidualMean.Value)),)
    legend = Legend(
        _title(obj, colour_map.RESIDUAL, unit), _ticks(top * factor), notes=notes, warnings=warnings_of(obj)
    )
    place, _, largest = deviations.largest
    label = label_node((*to_mm(place), 0.0), lengths_text(largest)[0])
    return [_film(SkinNodes(skin), [_matt(coin, _GREY)]), front, legend_node(obj, legend, TOP), label]


def _is_compared(obj) -> bool:
    """Its many panels were made for a profile or a drawing."""
    return bag_result.has_many_panels(obj) and not is_bag(obj.Outline)


def _distance_nodes(obj) -> list:
    """The film by its distance from the profile or the drawing, and what that is in all."""
    design, film = bag_result.stored(obj)
    film_results = results(design.inflation, film, off_target(design))
    drawn_map = colour_map.distance_map(film_results, design.residual)
    factor, unit = user_unit(drawn_map.unit, drawn_map.top)
    notes: tuple[str, ...] = ()
    if design.residual is not None:
        error = design.residual
        texts = lengths_text(*(to_mm(part) for part in (error.mean, error.p95, error.max)))
        shares = (percent_text(part / design.size) for part in (error.mean, error.p95, error.max))
        lines = (
            translate("in the mean {} ({})"),
            translate("95 % below {} ({})"),
            translate("at most {} ({})"),
        )
        notes = tuple(line.format(*both) for line, *both in zip(lines, texts, shares))
    legend = Legend(
        _title(obj, colour_map.DISTANCE, unit),
        _ticks(drawn_map.top * factor),
        notes=notes,
        warnings=warnings_of(obj),
    )
    skin = SkinNodes(skin_from(design.inflation, film), drawn_map.shares)
    return [_film(skin, _scale_nodes()), legend_node(obj, legend, TOP)]


def _title(obj, kind: str, unit: str) -> str:
    text = translate(_TITLES[kind])
    return title(obj, f"{text} [{unit}]" if unit else text)


def _ticks(top: float) -> tuple[tuple[float, str], ...]:
    return tuple((value / top, number_text(value, 4)) for value in colour_map.ticks(top))


def _states(film: FilmState) -> tuple:
    """The colours of the states, and how much of the film is in each."""
    names = {
        State.SLACK: translate("loose: {}"),
        State.WRINKLED: translate("wrinkled: {}"),
        State.TAUT: translate("tight: {}"),
    }
    rgb = colour_map.colours(np.array([0.0, 0.5, 1.0])).tolist()
    return tuple(
        (tuple(rgb[state]), names[state].format(percent_text(share)))
        for state, share in film.shares().items()
    )


def _notes(safe, drawn_map, factor: float, unit: str) -> tuple[str, ...]:
    notes = []
    if drawn_map.largest > 1.05 * drawn_map.top and (
        safe is not None or drawn_map.kind != colour_map.TENSION
    ):
        notes.append(translate("at most {} {}").format(number_text(drawn_map.largest * factor), unit))
    if safe is not None:
        if safe.safe_pressure is None:
            notes.append(translate("strength of the film not known"))
        else:
            notes.append(
                translate("safe to {}, margin {}").format(
                    pressure_text(safe.safe_pressure), number_text(safe.margin)
                )
            )
    return tuple(notes)


def warnings_of(obj) -> tuple[str, ...]:
    """What a legend says when its balloon is not up to date."""
    if status.is_ready(obj):
        return ()
    return (translate("stale: belongs to earlier values"),)
