# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Pattern object shows and tells of many panels."""

from __future__ import annotations


def draw(bag, film, options, arcs: bool = True) -> tuple:
    """What is drawn of the patterns: a curve for each contour of their sheet; touches no document.

    arcs  lines and arcs in place of many short lines
    Raises what `bag_patterns` raises.
    """
    from BalloonWorkbench.core.arcs.curves import polyline
    from BalloonWorkbench.core.arcs.fit_arcs import fit_curve
    from BalloonWorkbench.core.bag_pattern.make import bag_patterns

    curve = fit_curve if arcs else polyline
    contours = bag_patterns(bag, film, options).sheet.contours
    return tuple(curve(contour.points, contour.closed) for contour in contours)


def show(obj, patterns, contours) -> None:
    """Write what there is to tell about patterns into the object; None: two equal panels.

    contours  that the wires of its shape show
    """
    obj.Pieces = [] if patterns is None else _pieces(patterns)
    obj.Seams = [] if patterns is None else [_seam(patterns, seam) for seam in patterns.seams if seam.made]
    obj.Order = [] if patterns is None else [_step(patterns, step) for step in patterns.order]
    obj.PanelNames = [] if patterns is None else list(patterns.piece_names)
    obj.PanelNumbers = [] if patterns is None else _numbers(patterns, contours)


def _numbers(patterns, contours) -> list[int]:
    """The number of the panel or piece that each contour is of, from 1; 0 for those of further balloons."""
    known = {
        (contour.role, contour.points.tobytes()): number
        for number, piece in enumerate((*patterns.patterns, *patterns.pieces), 1)
        for contour in piece.contours
    }
    return [known.get((contour.role, contour.points.tobytes()), 0) for contour in contours]


def _pieces(patterns) -> list[str]:
    """A line for each shape of panels: who has it, and how often it is cut."""
    lines = []
    for copies in patterns.copies:
        names = ", ".join(_name(patterns, number) for number in copies.panels)
        mirrored = sum(copies.mirrored)
        more = f", {mirrored} of them mirrored" if mirrored else ""
        lines.append(f"{len(copies.panels)} x {names}{more}" if len(copies.panels) > 1 else names)
    return lines


def _seam(patterns, seam) -> str:
    from BalloonWorkbench.core.units import length_text

    one, other = (_name(patterns, number) for number in seam.panels)
    lengths = dict.fromkeys(length_text(length) for length in (seam.length_a, seam.length_b))
    kind = "" if seam.flat else ", one edge must turn"
    return f"{seam.number}: {one} to {other}, {' and '.join(lengths)}{kind}"


def _step(patterns, step) -> str:
    one, other = (_name(patterns, number) for number in step.panels)
    return f"Seam {step.seam}: {one} to {other}{', with the opening' if step.opening else ''}"


def _name(patterns, number: int) -> str:
    return patterns.names[patterns.panels.index(number)]
