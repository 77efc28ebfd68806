# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be seen of a painting: the balloon with its place in the picture, the pattern, the numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from BalloonWorkbench.app.drawings.painting import SolvedPainting
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.nearest import nearest_on_line
from BalloonWorkbench.core.geometry.polyline import ring
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.validity import scale_to
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.make import make_pattern
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.solver.inflation import MIRROR
from BalloonWorkbench.core.tracing.picture import placed_drawing
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.paint.preview.advice_marks import Remark
from BalloonWorkbench.gui.qt import QtCore

_SAME = 0.5 / 256  # parts of the picture; outlines that differ by less are one
NEARLY = 3.0 / 256  # parts of the picture; finer than what a quick preview can show
TRACED = 256  # px along the side of the picture in which a quick preview looks for the shape


@dataclass(frozen=True)
class PreviewSurface:
    """Both panels of one balloon.

    positions  (n, 3) mm; normals (n, 3); triangles (m, 3)
    places     (n, 2) in the picture, 0 to 1, y up: what is painted there
    """

    positions: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray
    places: np.ndarray


@dataclass(frozen=True)
class PictureFrame:
    """From metres in the drawing to parts of the picture."""

    corner: np.ndarray
    scale: float

    def places(self, points) -> np.ndarray:
        return self.corner + np.asarray(points)[:, :2] * self.scale


@dataclass(frozen=True)
class PreviewState:
    """One state of a painting.

    revision  of the painting
    drawing   the outlines [m], and the frame of the picture around them
    contours  of the pattern: role and points (k, 2) mm
    size      width, height and thickness of the largest balloon, mm; volume in m3
    fitted    the balloon is the document's own, not that of a quick preview
    remarks   of the advice; none before the full design is over
    solved    what the document takes over, at the end of a full design. It belongs to `file`
    traced    the loops (k, 2) that were seen by a quick preview, in parts of the picture
    width     that was asked for, mm
    designs   the fitted balloons
    """

    revision: int
    skins: tuple[PreviewSurface, ...]
    drawing: Drawing
    frame: PictureFrame
    contours: tuple[tuple[str, np.ndarray], ...]
    size: tuple[float, float, float]
    volume: float
    fitted: bool = False
    remarks: tuple[Remark, ...] = ()
    solved: SolvedPainting | None = None
    file: Path | None = None
    traced: tuple[np.ndarray, ...] = ()
    width: float = 0.0
    designs: tuple[Design, ...] = ()

    @property
    def loops(self) -> tuple[np.ndarray, ...]:
        """Of the outlines (k, 2), in parts of the picture, y up."""
        return loops_in(self.drawing, self.frame)

    def is_of(self, traced: tuple[np.ndarray, ...], width: float, within: float = _SAME) -> bool:
        """Whether it is the state of a painting with these loops, seen by a quick preview, at a width in mm.

        within  parts of the picture that the loops may differ by
        """
        return (
            self.width == width
            and len(self.traced) == len(traced)
            and all(
                _near(mine, its, within) and _near(its, mine, within)
                for mine, its in zip(self.traced, traced)
            )
        )


def loops_in(drawing: Drawing, frame: PictureFrame) -> tuple[np.ndarray, ...]:
    """The loops of a drawing (k, 2), in parts of the picture, y up."""
    return tuple(frame.places(loop) for part in drawing.parts for loop in part.loops)


def _near(loop: np.ndarray, other: np.ndarray, within: float) -> bool:
    """Whether all points of a loop lie on another one, within parts of the picture."""
    return bool((nearest_on_line(ring(other), loop).distance < within).all())


def seen(image, width: float, drawn_as: str) -> tuple[Drawing, PictureFrame]:
    """The shapes in an image, so wide in mm [m], and where they are in it. BalloonError without any."""
    small = image.scaled(TRACED, TRACED, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation)
    drawing, corner = placed_drawing(pixels(small), 0.0, drawn_as)
    across = drawing.size[0]
    sized = scale_to(drawing, from_mm(width), None)
    return sized, PictureFrame(corner / TRACED, across / TRACED / from_mm(width))


def skin(inflation, places) -> PreviewSurface:
    """What is shown of a balloon; places (n, 2) of its vertices in the picture."""
    flat, faces = inflation.positions, inflation.panel.triangles
    below = flat * MIRROR if inflation.lower is None else inflation.lower
    return PreviewSurface(
        to_mm(np.concatenate([flat, below])),
        np.concatenate([inflation.directors, inflation.directors * MIRROR]),
        np.concatenate([faces, faces[:, ::-1] + len(flat)]),
        np.concatenate([places, places]),
    )


def contours(seams, settings: Settings, fair: bool = True) -> tuple[tuple[str, np.ndarray], ...]:
    """Role and points (k, 2) mm of what is cut and sealed; nothing for seams that have no room for it.

    fair: the whole pattern; else without what takes long or is small, see build_pattern
    """
    lines = []
    for seam in seams:
        pattern = _pattern(seam, settings, fair)
        if pattern is None:
            continue
        lines += [(contour.role.value, to_mm(np.asarray(contour.points))) for contour in pattern.contours]
    return tuple(lines)


def _pattern(seam, settings: Settings, fair: bool) -> Pattern | None:
    """The pattern as it is wanted, without an intake that has no room; None where a weld has none, either:
    it is too thin as long as it is drawn."""
    for options in (settings.pattern, replace(settings.pattern, intake=False)):
        try:
            if fair:
                return make_pattern(seam, settings.film.seal_width, options)
            return build_pattern(seam, settings.film.seal_width, options, fair)
        except InputError:
            continue
    return None


def drawn(inflation) -> np.ndarray:
    """Where in the drawing each vertex is painted: the seam on the outline, the film evenly between."""
    panel = inflation.panel
    moved = move_rim(
        panel,
        [inflation.positions[seam, :2] for seam in panel.loops],
        [inflation.positions[weld, :2] for weld in panel.welds],
    )
    return inflation.positions if moved is None else moved.rest_positions


def size(inflation) -> tuple[float, float, float]:
    """Width, height and thickness in mm."""
    width, height, half = to_mm(np.ptp(inflation.positions, axis=0)).tolist()
    return width, height, 2.0 * half
