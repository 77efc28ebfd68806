# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along a polyline at which arcs may begin and end."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.geometry.vectors import norm, wrapped
from BalloonWorkbench.core.types import Floats


@dataclass(frozen=True)
class Samples:
    """Samples along a polyline: points (k, 2), way along [m], integral of the heading [m rad]."""

    points: Floats
    along: Floats
    swept: Floats


def sample(
    points: Floats, spacing: float, tolerance: float, first: float | None = None, last: float | None = None
) -> Samples:
    """Samples of a polyline (n, 2) within which arcs may begin and end.

    They are its vertices, at least the middles of its edges, none farther from the next than the spacing [m],
    and some so near to each vertex that an arc between them rounds it off within the tolerance [m]. first and
    last are the headings wanted at the ends [rad], where the polyline turns to them.
    """
    edges = np.diff(points, axis=0)
    lengths = norm(edges)
    heading = np.unwrap(np.arctan2(edges[:, 1], edges[:, 0]))
    counts = np.clip(2 * np.ceil(0.5 * lengths / spacing).astype(int), 2, 16)
    ends = np.append(0.0, np.cumsum(lengths))
    even = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(ends[:-1], ends[1:], counts)]
    turns = np.diff(np.concatenate([[_or(first, heading[0])], heading, [_or(last, heading[-1])]]))
    rounding = 3.0 * tolerance / np.maximum(np.abs(wrapped(turns)), 1e-9)
    sides = (-1.0, -0.6, -0.3, 0.3, 0.6, 1.0)
    around = np.minimum(np.append(lengths, np.inf), np.append(np.inf, lengths))
    room = 0.5 * np.minimum(around, spacing)
    bent = rounding < 3.0 * room
    near = [(ends + side * np.minimum(rounding, room))[bent] for side in sides]
    along = np.concatenate([*even, ends[-1:], *near])
    along = np.unique(along[(along >= 0.0) & (along <= ends[-1])])
    along = along[np.append(True, np.diff(along) > 1e-9)]
    edge = np.clip(np.searchsorted(ends, along[:-1] + 1e-10, side="right") - 1, 0, len(edges) - 1)
    share = (along[:-1] - ends[edge]) / lengths[edge]
    swept = np.append(0.0, np.cumsum(heading[edge] * np.diff(along)))
    return Samples(np.concatenate([points[edge] + share[:, None] * edges[edge], points[-1:]]), along, swept)


def _or(heading: float | None, otherwise: float) -> float:
    return otherwise if heading is None else heading
