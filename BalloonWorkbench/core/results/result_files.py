# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the simulation found in every triangle and vertex, as a file for ParaView or for NumPy.

Of two equal panels the vertices and triangles of the upper one, then those of the lower one in the same
order; else of all panels in their order. So the vertices of a seam are there twice.

| of each vertex | |
|---|---|
| flat_mm | where it lies in the flat panel; many panels lie side by side |
| thickness_mm | of a balloon of two equal panels there |
| distance_mm | of many panels from what they were made for, as off_target gives it |

| of each triangle | |
|---|---|
| tension_N_per_m, tension_across_N_per_m | larger and smaller principal membrane tension |
| tension_direction | unit vector along the larger one, which is along the wrinkles; zero where slack |
| strain, strain_least | larger and smaller principal Green strain |
| state | 0 slack, 1 wrinkled, 2 taut |
| wrinkle_intensity | part of the width that the wrinkles hide |
| panel | number of its panel, where there are many, from 0 |
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.results.film_state import film_state, thickness
from BalloonWorkbench.core.results.vtu import pvd_bytes, vtu_bytes
from BalloonWorkbench.core.solver.dynamics.animation import Frame
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.types import Floats, Ints
from BalloonWorkbench.core.units import to_mm

FORMATS = ("vtu", "npz")

_MIRROR = np.array([1.0, 1.0, -1.0])


@dataclass(frozen=True)
class Results:
    """positions (n, 3) mm, triangles (m, 3), values (n or m, ...) by the names above."""

    positions: Floats
    triangles: Ints
    of_vertices: dict[str, NDArray[Any]]
    of_triangles: dict[str, NDArray[Any]]


def results(inflation: Inflation, film: Film, distances: Floats | None = None) -> Results:
    """Results of a balloon made of this film; distances: of the vertices (n,) m, as off_target gives them."""
    if not inflation.assembly.mirror:
        return _of_panels(inflation, film, distances)
    panel = inflation.panel
    count = len(inflation.positions)
    upper = _of_triangles(inflation, film)
    if inflation.lower is None:
        below = inflation.positions * _MIRROR
        lower = {**upper, "tension_direction": upper["tension_direction"] * _MIRROR}
    else:
        below = inflation.lower
        lower = _of_triangles(replace(inflation, positions=below), film)
    flat = np.column_stack([panel.rest_positions, np.zeros(count)])
    return Results(
        to_mm(np.concatenate([inflation.positions, below])),
        np.concatenate([panel.triangles, panel.triangles[:, ::-1] + count]).astype(np.int32),
        {
            "flat_mm": to_mm(np.concatenate([flat, flat])),
            "thickness_mm": to_mm(np.tile(thickness(inflation), 2)),
        },
        {name: np.concatenate([values, lower[name]]) for name, values in upper.items()},
    )


def _of_panels(inflation: Inflation, film: Film, distances: Floats | None) -> Results:
    assembly = inflation.assembly
    rest = assembly.surface.rest_positions
    number = np.repeat(
        np.arange(len(assembly.panels), dtype=np.int32), [len(panel.triangles) for panel in assembly.panels]
    )
    of_vertices = {"flat_mm": to_mm(np.column_stack([rest, np.zeros(len(rest))]))}
    if distances is not None:
        of_vertices["distance_mm"] = to_mm(distances)
    return Results(
        to_mm(inflation.positions),
        assembly.surface.triangles,
        of_vertices,
        {**_of_triangles(inflation, film), "panel": number},
    )


def results_bytes(inflation: Inflation, film: Film, kind: str, distances: Floats | None = None) -> bytes:
    """A file of the `results` of a balloon, "vtu" or "npz"; InputError for another format."""
    computed = results(inflation, film, distances)
    if kind == "vtu":
        return vtu_bytes(computed.positions, computed.triangles, computed.of_vertices, computed.of_triangles)
    if kind != "npz":
        raise InputError(f"Results cannot be written as '{kind}'. Choose {' or '.join(FORMATS)}.")
    stream = io.BytesIO()
    arrays: dict[str, Any] = {"positions_mm": computed.positions, "triangles": computed.triangles}
    arrays.update(computed.of_vertices)
    arrays.update(computed.of_triangles)
    np.savez(stream, **arrays)
    return stream.getvalue()


def frame_files(
    inflation: Inflation, frames: Sequence[Frame], film: Film, stem: str = "inflation"
) -> dict[str, bytes]:
    """Files of a balloon's inflation by name: <stem>.pvd, and one VTK file of results for each frame."""
    digits = len(str(len(frames)))
    names = [f"{stem}-{number:0{digits}d}.vtu" for number in range(1, len(frames) + 1)]
    files = {f"{stem}.pvd": pvd_bytes([frame.time for frame in frames], names)}
    for name, frame in zip(names, frames, strict=True):
        then = replace(inflation, positions=frame.positions, lower=frame.lower)
        files[name] = results_bytes(then, film, "vtu")
    return files


def _of_triangles(inflation: Inflation, film: Film) -> dict[str, NDArray[Any]]:
    state = film_state(inflation, film)
    return {
        "tension_N_per_m": state.tensions[:, 0],
        "tension_across_N_per_m": state.tensions[:, 1],
        "tension_direction": state.direction,
        "strain": state.strains[:, 0],
        "strain_least": state.strains[:, 1],
        "state": state.state,
        "wrinkle_intensity": state.intensity,
    }
