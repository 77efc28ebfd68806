# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of every triangle as files: read back by other means than they were written."""

from __future__ import annotations

import base64
import io
from xml.etree import ElementTree

import numpy as np
import pytest
from solver_cases import PRESSURE, film, panel

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.results.film_state import film_state
from BalloonWorkbench.core.results.result_files import frame_files, results, results_bytes
from BalloonWorkbench.core.solver.dynamics.animation import inflate_in_time
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.model import Model

TYPES = {"Float32": "<f4", "Int32": "<i4", "UInt8": "u1"}


def arrays(data: bytes) -> dict[str, np.ndarray]:
    """All arrays of a VTK file by name."""
    found = {}
    for item in ElementTree.fromstring(data).iter("DataArray"):
        raw = base64.b64decode(item.text or "")
        assert int.from_bytes(raw[:4], "little") == len(raw) - 4
        values = np.frombuffer(raw[4:], dtype=TYPES[item.attrib["type"]])
        width = int(item.attrib["NumberOfComponents"])
        found[item.attrib["Name"]] = values.reshape(-1, width) if width > 1 else values
    return found


@pytest.fixture(scope="module")
def disc():
    return inflate(panel("disc", 400), film(500), PRESSURE)


def test_vtk_file_holds_the_balloon_in_millimetres(disc) -> None:
    data = results_bytes(disc, film(500), "vtu")
    found = arrays(data)
    piece = next(ElementTree.fromstring(data).iter("Piece"))
    vertices, faces = len(disc.positions), len(disc.panel.triangles)
    assert piece.attrib == {"NumberOfPoints": str(2 * vertices), "NumberOfCells": str(2 * faces)}
    triangles = found["connectivity"].reshape(-1, 3)
    np.testing.assert_array_equal(found["offsets"], np.arange(3, 6 * faces + 1, 3))
    assert set(found["types"]) == {5}
    corners = found["Points"].astype(float)[triangles]
    enclosed = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
    assert enclosed * 1e-9 == pytest.approx(disc.volume, rel=0.02)  # outward, closed
    assert found["thickness_mm"].max() == pytest.approx(np.ptp(found["Points"][:, 2]), rel=1e-6)
    np.testing.assert_allclose(found["flat_mm"][:vertices, :2], 1e3 * disc.panel.rest_positions, rtol=1e-6)


def test_tensions_balance_the_pressure(disc) -> None:
    """Cut in half at x = 0, the film's tension across the cut carries the pressure on its cross-section."""
    found = results(disc, film(500))
    corners = found.positions[found.triangles] * 1e-3
    rest = found.of_vertices["flat_mm"][found.triangles, :2] * 1e-3
    x = corners[:, :, 0] - corners[:, :, 0].mean()
    cut = (x.min(axis=1) < 0.0) & (x.max(axis=1) > 0.0)
    force = area = 0.0
    for index in np.flatnonzero(cut):
        ends, flat_ends = [], []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            if x[index, a] * x[index, b] < 0.0:
                share = x[index, a] / (x[index, a] - x[index, b])
                ends.append(corners[index, a] + share * (corners[index, b] - corners[index, a]))
                flat_ends.append(rest[index, a] + share * (rest[index, b] - rest[index, a]))
        along = flat_ends[1] - flat_ends[0]
        # force across a flat line: F S N, with F the deformation and S the stress in the flat film
        edges = np.linalg.inv(
            np.column_stack([rest[index, 1] - rest[index, 0], rest[index, 2] - rest[index, 0]])
        )
        gradient = (
            np.column_stack([corners[index, 1] - corners[index, 0], corners[index, 2] - corners[index, 0]])
            @ edges
        )
        direction = found.of_triangles["tension_direction"][index]
        axis = np.linalg.lstsq(gradient, direction, rcond=None)[0]
        axis /= max(np.linalg.norm(axis), 1e-300)
        across = np.array([-axis[1], axis[0]])
        normal = np.array([along[1], -along[0]])
        stress = found.of_triangles["tension_N_per_m"][index] * np.outer(axis, axis)
        stress += found.of_triangles["tension_across_N_per_m"][index] * np.outer(across, across)
        force += abs((gradient @ stress @ normal)[0])
        area += 0.5 * abs(ends[1][1] - ends[0][1]) * abs(ends[0][2] + ends[1][2])
    assert force == pytest.approx(PRESSURE * area, rel=0.03)


def test_numpy_file_holds_the_same(disc) -> None:
    data = results_bytes(disc, film(500), "npz")
    assert data == results_bytes(disc, film(500), "npz")
    state = film_state(disc, film(500))
    with np.load(io.BytesIO(data)) as found:
        faces = len(disc.panel.triangles)
        np.testing.assert_array_equal(found["state"][:faces], state.state)
        np.testing.assert_array_equal(found["state"][faces:], state.state)
        np.testing.assert_allclose(found["positions_mm"][: len(disc.positions)], 1e3 * disc.positions)
        below = found["tension_direction"][faces:]
        np.testing.assert_array_equal(below, state.direction * (1.0, 1.0, -1.0))
        assert set(found.files) - {"positions_mm"} == set(arrays(results_bytes(disc, film(500), "vtu"))) - {
            "Points", "connectivity", "offsets", "types",
        } | {"triangles"}  # fmt: skip


def test_lower_panel_has_results_of_its_own() -> None:
    both = inflate(panel("square", 300), film(500), PRESSURE, model=Model(two_panels=True))
    found = results(both, film(500))
    assert both.lower is not None
    np.testing.assert_allclose(found.positions[len(both.positions) :], 1e3 * both.lower)
    faces = len(both.panel.triangles)
    tensions = found.of_triangles["tension_N_per_m"]
    np.testing.assert_allclose(tensions[faces:].mean(), tensions[:faces].mean(), rtol=0.01)
    assert not np.array_equal(tensions[faces:], tensions[:faces])


def test_frames_are_a_series_in_time() -> None:
    balloon, strip = inflate_in_time(panel("disc", 150), film(300), PRESSURE, frames=12)
    files = frame_files(balloon, strip, film(300))
    sets = list(ElementTree.fromstring(files.pop("inflation.pvd")).iter("DataSet"))
    assert [item.attrib["file"] for item in sets] == sorted(files)
    times = [float(item.attrib["timestep"]) for item in sets]
    np.testing.assert_allclose(times, [frame.time for frame in strip], rtol=1e-8)
    heights = [np.ptp(arrays(files[name])["Points"][:, 2]) for name in sorted(files)]
    assert heights[0] < 0.01 * heights[-1]
    assert heights[-1] == pytest.approx(2e3 * balloon.positions[:, 2].max(), rel=1e-6)


def test_frames_show_both_panels() -> None:
    balloon, strip = inflate_in_time(
        panel("disc", 150), film(300), PRESSURE, frames=2, model=Model(two_panels=True)
    )
    assert strip[0].lower is not None
    assert strip[0].positions.shape == strip[0].lower.shape == balloon.positions.shape
    assert balloon.lower is strip[-1].lower


def test_other_formats_are_refused(disc) -> None:
    with pytest.raises(InputError, match="vtu or npz"):
        results_bytes(disc, film(500), "stl")
