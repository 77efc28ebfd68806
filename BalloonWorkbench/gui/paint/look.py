# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a painting gives: the balloon with its place in the picture, the pattern, the numbers.

Both requests run in a worker. `Glance` is quick and coarse; `Study` is what the document will have.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from BalloonWorkbench.app import painting
from BalloonWorkbench.app.painting import Solved
from BalloonWorkbench.app.qt_picture import pixels
from BalloonWorkbench.core.design.draft import VERTICES, check_area, draft
from BalloonWorkbench.core.errors import BalloonError, Cancelled, ExportError, InputError
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.mesh.reuse import move_rim
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.loops import scale_to
from BalloonWorkbench.core.outline.picture import placed_drawing
from BalloonWorkbench.core.pattern.build import usual_pattern
from BalloonWorkbench.core.solver.inflate import MIRROR
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.qt import QtCore, QtGui, translate

TRACED = 256  # px along the side of the picture in which a glance looks for the shape
_MOST_SHAPES = 6  # at a glance


@dataclass(frozen=True)
class Skin:
    """Both panels of one balloon.

    positions  (n, 3) mm; normals (n, 3); triangles (m, 3)
    places     (n, 2) in the picture, 0 to 1, y up: what is painted there
    """

    positions: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray
    places: np.ndarray


@dataclass(frozen=True)
class Look:
    """One state of a painting.

    revision  of the painting
    loops     of the outlines (k, 2), in parts of the picture, y up
    contours  of the pattern: role and points (k, 2) mm
    size      width, height and thickness of the largest balloon, mm; volume in m3
    remarks   (severity, text, place in parts of the picture) about the largest one
    solved    what the document takes over; None for a glance. It belongs to `file`
    """

    revision: int
    skins: tuple[Skin, ...]
    loops: tuple[np.ndarray, ...]
    contours: tuple[tuple[str, np.ndarray], ...]
    size: tuple[float, float, float]
    volume: float
    remarks: tuple[tuple[str, str, tuple[float, float]], ...] = ()
    solved: Solved | None = None
    file: Path | None = None


@dataclass(frozen=True)
class _Frame:
    """From metres in the drawing to parts of the picture."""

    corner: np.ndarray
    scale: float

    def places(self, points) -> np.ndarray:
        return self.corner + np.asarray(points)[:, :2] * self.scale


@dataclass
class Glance:
    """The quick look at an image; width in mm."""

    image: object
    revision: int
    width: float
    settings: Settings

    def solve(self, progress) -> Look:
        """Raises BalloonError where no balloon can be seen yet."""
        drawing, frame = _seen(self.image, self.width)
        _go_on(progress)
        parts = drawing.parts[:_MOST_SHAPES]
        drafts = []
        for number, part in enumerate(parts):
            share = part.area / drawing.largest.area
            try:
                drafts.append(
                    draft(part, self.settings.film, self.settings.pressure, max(60, int(VERTICES * share)))
                )
            except BalloonError:
                if number == 0:
                    raise
            _go_on(progress)
        skins = [_skin(each.inflation, frame.places(each.inflation.panel.rest_positions)) for each in drafts]
        largest = drafts[0].inflation
        return Look(
            self.revision,
            tuple(skins),
            _loops(drawing, frame),
            _contours([each.pattern for each in drafts], self.settings),
            _size(largest),
            largest.volume,
        )


@dataclass
class Study:
    """The fitted balloons of an image, in the file that the document will have.

    sheet  values of the pattern
    """

    image: object
    revision: int
    width: float
    settings: Settings
    sheet: dict
    file: Path

    def solve(self, progress) -> Look:
        """Raises BalloonError where there is none, Cancelled when progress says stop."""
        if not self.image.save(str(self.file), "PNG"):
            raise ExportError(
                translate("The painting cannot be written to '{}': is the disk full?").format(self.file)
            )
        drawing, frame = _seen(self.image, self.width)
        check_area(drawing.largest)
        _go_on(progress)
        solved = painting.solve(self.file, self.width, self.settings, self.sheet, progress)
        inflations = [design.inflation for design in solved.designs]
        remarks = []
        for finding in solved.told[0]["advice"]:
            place = from_mm(np.array([finding["at_mm"]], dtype=float))
            remarks.append((finding["severity"], finding["text"], tuple(frame.places(place)[0].tolist())))
        return Look(
            self.revision,
            tuple(_skin(inflation, frame.places(_drawn(inflation))) for inflation in inflations),
            _loops(Drawing(tuple(request.source.outline for request in solved.requests)), frame),
            _contours([design.pattern for design in solved.designs], self.settings),
            _size(inflations[0]),
            inflations[0].volume,
            tuple(remarks),
            solved,
            self.file,
        )


@dataclass
class CutOut:
    """A picture without its background, to be painted on."""

    content: bytes

    def solve(self, progress) -> bytes:
        """The same picture as PNG, transparent where nothing is drawn. Raises BalloonError."""
        from BalloonWorkbench.core.outline.segment import segment

        rgba = pixels(QtGui.QImage.fromData(self.content))
        silhouette, _ = segment(rgba)
        rgba[..., 3] = np.minimum(np.maximum(rgba[..., 3], 255 * (silhouette > 0.5)), 255 * silhouette)
        height, width = silhouette.shape
        image = QtGui.QImage(rgba.tobytes(), width, height, 4 * width, QtGui.QImage.Format_RGBA8888)
        buffer = QtCore.QBuffer()
        buffer.open(QtCore.QIODevice.WriteOnly)
        image.save(buffer, "PNG")
        return bytes(buffer.data())


def _seen(image, width: float) -> tuple[Drawing, _Frame]:
    """The shapes in an image, at their size [m], and where they are in it."""
    small = image.scaled(TRACED, TRACED, QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation)
    drawing, corner = placed_drawing(pixels(small), step=0.0)
    across = drawing.size[0]
    sized = scale_to(drawing, from_mm(width), None)
    return sized, _Frame(corner / TRACED, across / TRACED / from_mm(width))


def _go_on(progress) -> None:
    if not progress(0.0, ""):
        raise Cancelled(translate("Stopped."))


def _skin(inflation, places) -> Skin:
    flat, faces = inflation.positions, inflation.panel.triangles
    below = flat * MIRROR if inflation.lower is None else inflation.lower
    return Skin(
        to_mm(np.concatenate([flat, below])),
        np.concatenate([inflation.directors, inflation.directors * MIRROR]),
        np.concatenate([faces, faces[:, ::-1] + len(flat)]),
        np.concatenate([places, places]),
    )


def _loops(drawing: Drawing, frame: _Frame) -> tuple[np.ndarray, ...]:
    return tuple(frame.places(loop) for part in drawing.parts for loop in part.loops)


def _contours(seams, settings: Settings):
    found = []
    for seam in seams:
        try:
            pattern = usual_pattern(seam, settings.film, settings.intake)
        except InputError:  # too thin for its weld, as long as it is drawn
            continue
        found += [(contour.role.value, to_mm(np.asarray(contour.points))) for contour in pattern.contours]
    return tuple(found)


def _drawn(inflation) -> np.ndarray:
    """Where in the drawing each vertex is painted: the seam on the outline, the film evenly between."""
    panel = inflation.panel
    moved = move_rim(
        panel,
        [inflation.positions[seam, :2] for seam in panel.seams],
        [inflation.positions[weld, :2] for weld in panel.welds],
    )
    return inflation.positions if moved is None else moved.rest_positions


def _size(inflation) -> tuple[float, float, float]:
    width, height, half = to_mm(np.ptp(inflation.positions, axis=0)).tolist()
    return width, height, 2.0 * half
