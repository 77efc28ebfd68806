# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two discs of film sealed along the rim: the Mylar balloon.

The references are axisymmetric tension-field films (nu = 0.3) by quadrature, at k = E t / (p a); for large k
they tend to Paulsen's closed form ("What is the shape of a Mylar balloon?", Am. Math. Monthly 101, 1994).
"""

import pytest
from solver_cases import PRESSURE, inflated, needs_native, radii, silhouette_radii

#: k: volume, rim radius, thickness and tension at the pole for a = 1, p = 1
REFERENCE = {
    50: (1.25549, 0.76951, 0.94940, 0.904),
    100: (1.23836, 0.76643, 0.93635, 1.030),
    200: (1.22915, 0.76475, 0.92817, 1.178),
    500: (1.22315, 0.76364, 0.92181, 1.411),
    1000: (1.22098, 0.76323, 0.91899, 1.619),
    10000: (1.21882, 0.76282, 0.91510, 2.56),
}


@pytest.mark.parametrize("k", REFERENCE)
@needs_native
def test_disc_of_1500_vertices(k: int) -> None:
    volume, rim, thickness, _ = REFERENCE[k]
    disc = inflated("disc", k, "native")
    assert len(disc.positions) < 1550
    assert disc.report.stiffness_k == pytest.approx(k / 2.0, rel=1e-3)  # L is the diameter there
    assert disc.volume == pytest.approx(volume, rel=0.003)
    assert 2.0 * disc.positions[:, 2].max() == pytest.approx(thickness, rel=0.01)
    assert radii(disc, 0).mean() == pytest.approx(rim, rel=0.01)
    assert silhouette_radii(disc).mean() == pytest.approx(rim, rel=0.005)


@pytest.mark.parametrize("k", [50, 100, 200, 500, 1000])
@needs_native
def test_greatest_tension_is_that_of_the_pole(k: int) -> None:
    """What the film must bear. (At k = 10 000 single triangles are half as much again too tight.)"""
    assert inflated("disc", k, "native").tensions.max() / PRESSURE == pytest.approx(REFERENCE[k][3], rel=0.03)


@needs_native
def test_sealed_band_evens_the_rim() -> None:
    """The band takes a little volume and most of the scallops."""
    volume, rim, thickness, _ = REFERENCE[500]
    disc = inflated("disc", 500, "native", seal_width=0.02)
    assert disc.volume == pytest.approx(volume, rel=0.004)
    assert 2.0 * disc.positions[:, 2].max() == pytest.approx(thickness, rel=0.01)
    assert radii(disc, 0).mean() == pytest.approx(rim, rel=0.003)
    assert radii(disc, 0) == pytest.approx(rim, rel=0.012)
    assert silhouette_radii(disc).mean() == pytest.approx(rim, rel=0.003)


@needs_native
def test_error_falls_with_the_mesh() -> None:
    coarse, fine = (inflated("disc", 500, "native", vertices=count).volume for count in (400, 1500))
    exact = REFERENCE[500][0]
    assert abs(coarse / exact - 1.0) < 0.01
    assert abs(fine - exact) < 0.5 * abs(coarse - exact)
