# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mirror symmetry of an outline: its axis, and the outline made exactly symmetric.

A reflection is its own inverse: the distance from the mirrored outline to the outline is the same both ways,
so one way gives the two-way mean distance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from BalloonWorkbench.core.errors import InputError, OutlineError
from BalloonWorkbench.core.geometry.areas import parts
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.geometry.polyline import (
    centroid,
    edge_vectors,
    oriented,
)
from BalloonWorkbench.core.geometry.sampling import evenly
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check
from BalloonWorkbench.core.packages import shapely
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import percent_text

AUTO, OFF, FORCE = "auto", "off", "force"
CHOICES = (AUTO, OFF, FORCE)

#: Mean distance between the halves, of the larger dimension, up to which a picture is meant to be symmetric.
DRAWN = 3e-3
#: ... up to which a drawing is symmetric as it is: curves become polylines no better than this.
EXACT = 1e-4
#: An axis nearer to the vertical is taken as long as it is no worse than this.
_AS_GOOD = 1e-3

_SAMPLES = 240
_ANGLES = 90
_MOST_AXES = 6
_STEPS = 8
_NO_CHANGE = 0.99  # of the error: a step that leaves more than this is the last
_SLIVER = 1e-6  # of the outline's area
_SAME_POINT = 2e-6  # of its size: a point nearer to the axis is on it


@dataclass(frozen=True)
class Mirror:
    """An axis.

    point  (2,) m on it
    angle  counter-clockwise from +x, above 0 and up to pi [rad]
    error  mean distance between the outline and its mirror image, of the larger dimension
    """

    point: Floats
    angle: float
    error: float

    def reflect(self, points: Floats) -> Floats:
        """Mirror images of points (n, 2)."""
        frame = self.frame
        local = (points - self.point) @ frame
        return self.point + (local * (-1.0, 1.0)) @ frame.T

    @property
    def frame(self) -> Floats:
        """Unit vectors (2, 2) in columns: across the axis, to its right, and along it."""
        cos, sin = np.cos(self.angle), np.sin(self.angle)
        return np.array([[sin, cos], [-cos, sin]])


def find_mirror(outline: Outline) -> Mirror:
    """The axis about which the outline is most nearly symmetric, however far that is from symmetric.

    The nearest to the vertical of those that are about as good.
    """
    size = max(outline.size)
    spacing = outline.perimeter / _SAMPLES
    samples = np.concatenate([evenly(loop, spacing) for loop in outline.loops])
    centre = centroid(outline.loops)
    angles = np.pi * np.arange(1, _ANGLES + 1) / _ANGLES
    rough = np.array([_rough_error(samples, Mirror(centre, angle, 0.0)) for angle in angles])
    valley = (rough <= np.roll(rough, 1)) & (rough <= np.roll(rough, -1))
    upright = np.abs(angles - 0.5 * np.pi) < 1e-6
    candidates = np.flatnonzero((valley | upright) & (rough < 1.5 * rough.min() + 0.01 * size))
    candidates = candidates[np.lexsort((rough[candidates], ~upright[candidates]))][:_MOST_AXES]
    mirrors = [_settled(outline, samples, Mirror(centre, float(angles[k]), 0.0), size) for k in candidates]
    best = min(mirror.error for mirror in mirrors)
    good = [mirror for mirror in mirrors if mirror.error <= (best + _AS_GOOD if best > EXACT else EXACT)]
    return min(good, key=lambda mirror: (round(abs(mirror.angle - 0.5 * np.pi), 3), mirror.error))


def exact_mirror(outline: Outline) -> Mirror | None:
    """The axis of an outline that is symmetric as it is, else None."""
    mirror = find_mirror(outline)
    return mirror if mirror.error <= EXACT else None


def symmetric(outline: Outline, choice: str, *, drawn: bool) -> Outline:
    """The outline as the user wants its symmetry: AUTO, OFF or FORCE.

    drawn  it comes from a picture. AUTO makes only such an outline symmetric, when it nearly is: lines that
           were constructed stay where they are. A note tells what was done.
    Raises InputError for another choice, and for a drawing with welds inside.
    """
    if choice not in CHOICES:
        raise InputError(f'There is no symmetry "{choice}": choose one of {", ".join(CHOICES)}.')
    if choice == OFF or (choice == AUTO and not drawn):
        return outline
    if outline.welds or outline.spots:
        raise InputError("A drawing with welds inside is not made symmetric: draw it so, and turn this off.")
    mirror = find_mirror(outline)
    if choice == AUTO and mirror.error > DRAWN:
        return outline
    notes = outline.notes
    if mirror.error > _AS_GOOD:
        off = f"{percent_text(mirror.error)} of its size"
        notes += (f"The drawing was made symmetric: its halves were {off} apart, the left one was kept.",)
    return replace(mirrored(outline, mirror), notes=notes)


def evened(drawing: Drawing, choice: str, *, drawn: bool) -> Drawing:
    """The drawing with each of its shapes as in `symmetric`."""
    return replace(drawing, parts=tuple(symmetric(part, choice, drawn=drawn) for part in drawing.parts))


def mirrored(outline: Outline, mirror: Mirror) -> Outline:
    """The part on the left of the axis and its mirror image, as one outline that is exactly symmetric.

    Loops that meet the axis begin there. OutlineError where nothing in one piece remains.
    """
    package = shapely()
    area = package.Polygon(*_rings(outline, mirror))
    if not area.is_valid:
        raise OutlineError("The outline crosses or touches itself and cannot be mirrored; part the lines.")
    far = 4.0 * sum(outline.size)
    left = area.intersection(package.box(-far, -far, 0.0, far))
    whole = left.union(package.transform(left, lambda points: points * (-1.0, 1.0)))
    bodies = parts(whole)
    if not bodies or bodies[0].area < 0.05 * area.area:
        raise OutlineError("The outline cannot be mirrored about its axis: draw it symmetric, or leave that.")
    body = bodies[0]
    holes = [hole for hole in body.interiors if package.Polygon(hole).area > _SLIVER * body.area]
    rings = [np.asarray(ring.coords, dtype=np.float64)[:-1] for ring in (body.exterior, *holes)]
    near = _SAME_POINT * max(outline.size)
    loops = [_from_axis(ring, near, 1 if number == 0 else -1) for number, ring in enumerate(rings)]
    back = [mirror.point + loop @ mirror.frame.T for loop in loops]
    return check(replace(outline, outer=back[0], holes=tuple(back[1:])))


def _rings(outline: Outline, mirror: Mirror) -> tuple[Floats, list[Floats]]:
    """The loops with the axis as the y axis."""
    outer, *holes = ((loop - mirror.point) @ mirror.frame for loop in outline.loops)
    return outer, holes


def _from_axis(loop: Floats, near: float, sign: int) -> Floats:
    """The loop with an area of this sign, begun at the lowest of its points on the y axis, if it has any."""
    loop = loop[(loop[:, 0] == 0.0) | (np.abs(loop[:, 0]) > near)]
    loop = oriented(loop, sign > 0)
    on_axis = np.flatnonzero(loop[:, 0] == 0.0)
    return np.roll(loop, -int(on_axis[np.argmin(loop[on_axis, 1])]), axis=0) if len(on_axis) else loop


def _rough_error(samples: Floats, mirror: Mirror) -> float:
    """Mean distance from every third sample's image to the nearest sample [m]."""
    x, y = (mirror.reflect(samples[::3])[:, axis, None] - samples[:, axis] for axis in (0, 1))
    return float(np.sqrt((x * x + y * y).min(axis=1)).mean())


def _settled(outline: Outline, samples: Floats, mirror: Mirror, size: float) -> Mirror:
    """The axis turned and moved until the images lie nearest to the outline: Gauss-Newton, line to point."""
    best = replace(mirror, error=np.inf)
    for step in range(_STEPS + 1):
        images = mirror.reflect(samples)
        nearest, normals = _nearest(outline, images)
        away = images - nearest
        error = float(np.linalg.norm(away, axis=1).mean()) / size
        last = step == _STEPS or error > _NO_CHANGE * best.error or error < 1e-12
        if error < best.error:
            best = replace(mirror, error=error)
        if last:
            break
        # turning the axis turns the image by twice the angle; moving it moves the image twice as far
        arm = images - mirror.point
        turn = 2.0 * (normals[:, 1] * arm[:, 0] - normals[:, 0] * arm[:, 1]) / size
        shift = 2.0 * normals @ mirror.frame[:, 0]
        system = np.stack([turn, shift], axis=1)
        normal = system.T @ system + 1e-6 * len(samples) * np.eye(2)  # a disc has no angle of its own
        change = -np.linalg.solve(normal, system.T @ np.einsum("ij,ij->i", normals, away))
        angle = np.pi - np.mod(np.pi - (mirror.angle + change[0] / size), np.pi)
        mirror = Mirror(mirror.point + change[1] * mirror.frame[:, 0], float(angle), 0.0)
    return best


def _nearest(outline: Outline, points: Floats) -> tuple[Floats, Floats]:
    """Nearest places (k, 2) of the outline to points (k, 2), and its unit normals (k, 2) there."""
    edge, share, _ = nearest_on_loops(outline.loops, points)
    ahead = np.concatenate([edge_vectors(loop) for loop in outline.loops])[edge]
    return np.concatenate(outline.loops)[edge] + share[:, None] * ahead, -perpendicular(unit(ahead))
