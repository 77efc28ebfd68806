# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the line below the flat pieces tells."""

from __future__ import annotations

import math

from BalloonWorkbench.core.arrangement.arrangement import LaidPieces
from BalloonWorkbench.core.geometry.polyline import length
from BalloonWorkbench.core.units import number_text, to_mm
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text


def edge_text(laid: LaidPieces, number: int, partner: int | None) -> str:
    """An edge, and the one that it is sealed to."""
    own, seam = _named(laid, number), laid.pieces.edges[number].seam
    if partner is not None:
        return translate("Seam {}: {}; {}").format(seam, own, _named(laid, partner))
    return translate("Open edge: {}").format(own) if seam else translate("Weld: {}").format(own)


def piece_text(laid: LaidPieces, number: int, grain: float | None) -> str:
    """A piece and how it lies."""
    place = laid.places[number]
    texts = [translated(laid.pieces.pieces[number].name)]
    if place.angle:
        texts.append(translate("turned by {}\N{DEGREE SIGN}").format(_degrees(place.angle)))
    if place.mirrored:
        texts.append(translate("mirrored: its other side is up, with its print and sealing side"))
    if grain is not None:
        texts.append(translate("grain at {}\N{DEGREE SIGN}").format(_degrees(place.grain(grain))))
    return ", ".join(texts)


def measure_text(places) -> str:
    """The distance of two places (2,) m."""
    across, up = to_mm(abs(places[1] - places[0])).tolist()
    texts = map(length_text, (math.hypot(across, up), across, up))
    return translate("Distance {}, across {}, up {}").format(*texts)


def changes_text(laid: LaidPieces) -> str:
    """What has become of an arrangement whose pieces are others now; empty where all are there."""
    texts = []
    if laid.gone:
        texts.append(translate("No longer in the pattern, with their places: {}.").format(_listed(laid.gone)))
    if laid.new:
        texts.append(translate("New, laid beside the others: {}.").format(_listed(laid.new)))
    return " ".join(texts)


def _named(laid: LaidPieces, number: int) -> str:
    edge = laid.pieces.edges[number]
    return f"{translated(laid.pieces.pieces[edge.piece].name)}, {length_text(to_mm(length(edge.line)))}"


def _degrees(angle: float) -> str:
    return number_text(round(math.degrees(angle), 1))


def _listed(names) -> str:
    shown = ", ".join(map(translated, names[:_MOST]))
    return f"{shown}, \N{HORIZONTAL ELLIPSIS}" if len(names) > _MOST else shown


_MOST = 8  # names in a sentence
