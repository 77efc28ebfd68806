# SPDX-License-Identifier: LGPL-2.1-or-later
"""One iterate of a letter with a side band: its pattern is meshed, inflated and laid on the drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.bags.bag import Bag
from BalloonWorkbench.core.bags.mesh_bag import MeshedBag, mesh_bag
from BalloonWorkbench.core.bodies.banded import BACK, FRONT, band_pieces, band_places, banded_bag
from BalloonWorkbench.core.correction.seam_map import SeamMap, bridged
from BalloonWorkbench.core.correction.step import DRIFT, DRIFT_ROUND, OVERHANG, TIP
from BalloonWorkbench.core.design.compare import Misfit, laid_on, misfit
from BalloonWorkbench.core.design.correspondence import goals
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.visible_seam import visible_places
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.geometry.normals import corners, left_normals
from BalloonWorkbench.core.geometry.polyline import arc_lengths, gaps, point_at, point_weights
from BalloonWorkbench.core.geometry.splines import loop_splines, nearest_spline
from BalloonWorkbench.core.geometry.triangulation import interpolated
from BalloonWorkbench.core.geometry.vectors import cross
from BalloonWorkbench.core.mesh.reuse import stays_good
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.problem import NewtonSettings
from BalloonWorkbench.core.solver.start import dome
from BalloonWorkbench.core.types import Floats, Ints, Progress, no_progress

COLUMN = 9  # places across the band at which it is looked for where it reaches out farthest
KNOTS, CORNER_KNOTS = 4.0, 1.5  # mesh sizes between the knots of the pattern's moves; beside corners
_HAIR = 1e-6  # of a length, by which a place is inside of the mesh


@dataclass(frozen=True)
class BandSimulation:
    """How a pattern with a side band is simulated, and what its balloon is compared with.

    band    [m]; joints: for each loop the numbers of the points where its pieces meet
    newton  when the film is at rest; None: as usual
    """

    target: Outline
    film: Film
    pressure: float
    band: float
    joints: tuple[Ints, ...]
    backend: str | None = None
    model: Model | None = None
    newton: NewtonSettings | None = None
    progress: Progress = no_progress


@dataclass(frozen=True)
class BandIterate:
    """A pattern and what it inflates to, placed over the drawing; misfit: of silhouette and drawing."""

    seam_map: SeamMap
    meshed: MeshedBag
    inflation: Inflation
    silhouette: Outline
    misfit: Misfit

    @property
    def error(self) -> float:
        """Mean distance between drawing and silhouette [m]."""
        return self.misfit.residual.mean

    @property
    def thickness(self) -> float:
        """How high the balloon is, lying on its back [m]."""
        return float(np.ptp(self.inflation.positions[:, 2]))


def make_band_iterate(
    simulation: BandSimulation, seam_map: SeamMap, edge: float, last: BandIterate | None = None
) -> BandIterate:
    """Inflate the pattern of a seam map on a mesh of this edge length [m], anew or from the last balloon.

    last  whose mesh is moved, as long as that serves, and from whose balloon this one then sets out. Raises
    as mesh_bag and inflate do.
    """
    joints, band = simulation.joints, simulation.band
    bag = banded_bag(seam_map.outline, band, joints=joints)
    meshed = None if last is None else _moved(last.meshed, bag)
    if last is not None and meshed is not None:
        start = last.inflation.positions
    else:
        meshed = mesh_bag(bag, edge)
        start = _start(meshed, band_places(seam_map.pattern, joints, band))
    inflation = inflate(
        meshed.assembly,
        simulation.film,
        simulation.pressure,
        start=start,
        backend=simulation.backend,
        model=simulation.model,
        settings=simulation.newton,
        progress=simulation.progress,
    )
    placed = laid_on(inflation, silhouette(inflation), simulation.target)
    visible = silhouette(placed)
    return BandIterate(seam_map, meshed, placed, visible, misfit(simulation.target, visible))


def missing(iterate: BandIterate, joints: Sequence[Ints], edge: float, width: float) -> tuple[Floats, ...]:
    """For each loop of the drawing what the silhouette is short of at its points (n, 2) m, smooth.

    edge [m] of the mesh; width [m] over which differences are averaged along the drawing
    """
    size = max(iterate.silhouette.size)
    fields = []
    for loop, columns in zip(iterate.seam_map.drawing, band_columns(iterate, joints), strict=True):
        along = arc_lengths(loop)
        outward = -left_normals(loop)
        farthest = np.einsum("nkj,nj->nk", columns[:, :, :2], outward).argmax(axis=1)
        places = columns[np.arange(len(loop)), farthest, :2]
        places = visible_places(places, iterate.silhouette, OVERHANG * size)
        notches = _notches(loop, 0.5 * edge)
        reach = np.full(len(loop), min(DRIFT * edge, DRIFT_ROUND * float(along[-1])))
        goal = goals(loop, places, along[:-1], notches, along[notches], reach)
        smooth = smoothed(loop, goal - places, width)
        fields.append(smooth)
    drawing = iterate.seam_map.drawing
    fields = [bridged(loop, field, TIP * edge) for loop, field in zip(drawing, fields, strict=True)]
    return smooth_moves(drawing, fields, edge)


def smooth_moves(drawing: Sequence[Floats], moves: Sequence[Floats], edge: float) -> tuple[Floats, ...]:
    """Moves (n, 2) m of each loop of a drawing (n, 2) m without waves as short as those of crumpled film.

    edge [m] of the mesh. Film crumples along a curved rim, in waves that no pattern takes away. What is left
    is smooth between the corners of the drawing, and may have a kink at each.
    """
    smooth = []
    for loop, move in zip(drawing, moves, strict=True):
        sharp = corners(loop, reach=0.5 * edge)
        splines = loop_splines(loop, sharp, KNOTS * edge, CORNER_KNOTS * edge)
        smooth.append(nearest_spline(loop, splines, move))
    return tuple(smooth)


def band_columns(iterate: BandIterate, joints: Sequence[Ints]) -> list[Floats]:
    """For each loop of the drawing the band's positions (n, COLUMN, 3) m there, back to front."""
    meshed, loops = iterate.meshed, iterate.seam_map.drawing
    offsets, columns = meshed.assembly.offsets, [np.empty((len(loop), COLUMN, 3)) for loop in loops]
    for part in band_pieces(joints):
        along = part.along(len(loops[part.loop]))
        flat, panel = meshed.bag.panels[part.panel].outer, meshed.assembly.panels[part.panel]
        positions = iterate.inflation.positions[offsets[part.panel] : offsets[part.panel + 1]]
        width, height = flat.max(axis=0)
        x = np.clip(flat[: len(along), 0], _HAIR * width, (1.0 - _HAIR) * width)
        y = height * np.linspace(_HAIR, 1.0 - _HAIR, COLUMN)
        grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1)
        between = interpolated(panel.rest_positions, positions, grid.reshape(-1, 2))
        columns[part.loop][along] = between.reshape(len(along), COLUMN, 3)
    return columns


def _notches(loop: Floats, reach: float) -> Ints:
    """Indices of the corners of a loop at which the film, on its left, has a notch."""
    sharp = corners(loop, reach=reach)
    along = arc_lengths(loop)
    here = along[sharp]
    back = loop[sharp] - point_at(loop, along, here - reach)
    ahead = point_at(loop, along, here + reach) - loop[sharp]
    return sharp[cross(back, ahead) < 0.0].astype(np.int32)


def smoothed(loop: Floats, values: Floats, width: float) -> Floats:
    """Values (n, d) at the points of a closed loop (n, 2), averaged with a Gaussian of this width."""
    along = arc_lengths(loop)
    weight = np.exp(-0.5 * (gaps(along[:-1, None], along[:-1], float(along[-1])) / width) ** 2)
    weight *= point_weights(loop)
    return np.asarray(weight @ values / weight.sum(axis=1)[:, None])


def _moved(meshed: MeshedBag, bag: Bag) -> MeshedBag | None:
    """The mesh for panels that have moved; None where it has to be made anew."""
    moved = meshed.with_bag(bag)
    pairs = zip(meshed.original, moved.assembly.panels, strict=True)
    return moved if all(stays_good(before, after) for before, after in pairs) else None


def _start(meshed: MeshedBag, points: Sequence[Floats]) -> Floats:
    """Places (n, 3) to set out from: the band upright, front and back as domes over their rims."""
    places, offsets = meshed.places(list(points)), meshed.assembly.offsets
    for number, up in ((FRONT, 1.0), (BACK, -1.0)):
        places[offsets[number] : offsets[number + 1], 2] += up * dome(meshed.assembly.panels[number])[:, 2]
    return places
