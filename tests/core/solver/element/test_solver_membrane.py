# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tension-field law by itself: what it is in each state, smooth between them, convex."""

import numpy as np
import pytest

from BalloonWorkbench.core.solver.element.membrane import principal_tensions, states, tension_field
from BalloonWorkbench.core.types import Floats

RATIOS = pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])


def strain(major: float, minor: float, angle: float = 0.0) -> Floats:
    """Green strain (1, 3) with these principal values, the larger one at this angle."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array(
        [[major * c * c + minor * s * s, major * s * s + minor * c * c, 2.0 * (major - minor) * c * s]]
    )


def random_strains(count: int, seed: int = 1) -> Floats:
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (count, 3))


@RATIOS
def test_taut_film_is_plane_stress(nu: float) -> None:
    """Hooke's law written out for a film pulled both ways."""
    response = tension_field(strain(0.02, 0.01), nu)
    s11, s22 = (0.02 + nu * 0.01) / (1.0 - nu**2), (0.01 + nu * 0.02) / (1.0 - nu**2)
    assert response.stress[0] == pytest.approx([s11, s22, 0.0])
    assert response.energy[0] == pytest.approx(0.5 * (0.02 * s11 + 0.01 * s22))


@RATIOS
@pytest.mark.parametrize("minor", [-0.0051, -0.02, -0.5])
def test_wrinkled_film_pulls_along_the_wrinkles_only(nu: float, minor: float) -> None:
    """Uniaxial stress E eps_1, without nu, however much the film is gathered across."""
    angle = 0.7
    response = tension_field(strain(0.01, minor, angle), nu)
    c, s = np.cos(angle), np.sin(angle)
    assert response.stress[0] == pytest.approx(0.01 * np.array([c * c, s * s, c * s]))
    assert response.energy[0] == pytest.approx(0.5 * 0.01**2)
    assert principal_tensions(strain(0.01, minor, angle), 3.0, nu)[0] == pytest.approx([0.03, 0.0])


@RATIOS
def test_slack_film_carries_nothing(nu: float) -> None:
    response = tension_field(strain(-0.001, -0.3, 0.4), nu)
    assert response.energy[0] == 0.0
    assert not response.stress.any()
    assert not response.tangent.any()


@RATIOS
def test_stress_is_never_compressive(nu: float) -> None:
    strains = random_strains(5000)
    s11, s22, s12 = tension_field(strains, nu).stress.T
    smaller = 0.5 * (s11 + s22) - np.hypot(0.5 * (s11 - s22), s12)
    assert smaller.min() > -1e-12
    tensions = principal_tensions(strains, 1.0, nu)
    assert tensions[:, 1] == pytest.approx(smaller, abs=1e-12)
    assert tensions[:, 0] == pytest.approx(s11 + s22 - smaller, abs=1e-12)


@RATIOS
def test_stress_and_tangent_are_derivatives(nu: float) -> None:
    strains = random_strains(2000, seed=2)
    step = 1e-6
    middle = tension_field(strains, nu)
    for column in range(3):
        change = np.zeros(3)
        change[column] = step
        ahead, behind = tension_field(strains + change, nu), tension_field(strains - change, nu)
        slope = (ahead.energy - behind.energy) / (2.0 * step)
        assert middle.stress[:, column] == pytest.approx(slope, abs=1e-5)
        curve = (ahead.stress - behind.stress) / (2.0 * step)
        # not where a state begins within the step, nor where E1 = E2
        same = np.array(
            [_state(strains, nu) == _state(moved, nu) for moved in (strains - change, strains + change)]
        )
        inside = same.all(axis=0) & (np.hypot(strains[:, 0] - strains[:, 1], strains[:, 2]) > 0.01)
        assert middle.tangent[inside, :, column] == pytest.approx(curve[inside], abs=1e-4)


def _state(strains: Floats, nu: float) -> Floats:
    mean = 0.5 * (strains[:, 0] + strains[:, 1])
    radius = np.hypot(0.5 * (strains[:, 0] - strains[:, 1]), 0.5 * strains[:, 2])
    taut, wrinkled = states(mean + radius, mean - radius, nu)
    return 2 * taut + wrinkled


@RATIOS
@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0])
def test_smooth_where_wrinkles_begin_and_end(nu: float, angle: float) -> None:
    """Energy and stress run on across the borders of the states."""
    tiny = 1e-9
    borders = [((0.01, -nu * 0.01), (0.0, tiny)), ((0.0, -0.02), (tiny, 0.0)), ((0.0, 0.0), (tiny, tiny))]
    for (major, minor), (more, across) in borders:
        above = tension_field(strain(major + more, minor + across, angle), nu)
        below = tension_field(strain(major - more, minor - across, angle), nu)
        assert above.energy[0] == pytest.approx(below.energy[0], abs=10.0 * tiny)
        assert above.stress[0] == pytest.approx(below.stress[0], abs=10.0 * tiny)


@RATIOS
def test_convex(nu: float) -> None:
    """No chord lies below the energy; no tangent has a negative eigenvalue."""
    one, two = random_strains(5000, seed=3), random_strains(5000, seed=4)
    ends = 0.5 * (tension_field(one, nu).energy + tension_field(two, nu).energy)
    assert (tension_field(0.5 * (one + two), nu).energy <= ends + 1e-12).all()
    assert np.linalg.eigvalsh(tension_field(one, nu).tangent).min() > -1e-12


@RATIOS
def test_relaxed_energy_is_the_least_over_wrinkles(nu: float) -> None:
    """Pipkin's relaxation, by brute force: wrinkles may gather the film in any direction for nothing."""
    plane_stress = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]]) / (1.0 - nu**2)
    angles, amounts = np.meshgrid(np.linspace(0.0, np.pi, 181), np.linspace(0.0, 3.0, 1501), indexing="ij")
    c, s = np.cos(angles.ravel()), np.sin(angles.ravel())
    gathered = amounts.ravel()[:, None] * np.column_stack([c * c, s * s, 2.0 * c * s])
    strains = random_strains(20, seed=6)
    taut = strains[tension_field(strains, nu).energy > 0.0]
    assert len(taut) > 10
    for one in taut:
        trial = one + gathered
        least = 0.5 * np.einsum("ij,jk,ik->i", trial, plane_stress, trial).min()
        assert tension_field(one[None], nu).energy[0] == pytest.approx(least, abs=2e-4)


def test_wrinkled_beam_section() -> None:
    """Stein & Hedgepeth 1961: a stretched strip bent in its plane, its moment over the curvature."""
    y = np.linspace(-0.5, 0.5, 20001)
    for kappa_hat in (0.4, 1.0, 2.0, 9.0):  # E t h^2 kappa / (2 P)
        curvature = 1.0
        force = curvature / (2.0 * kappa_hat)
        taut = kappa_hat <= 1.0
        middle = force if taut else np.sqrt(2.0 * force * curvature) - 0.5 * curvature
        stretch = middle + curvature * y
        # stress-free across: -nu eps_1 where taut, anything below where wrinkled
        strains = np.column_stack([stretch, -0.3 * np.abs(stretch), np.zeros_like(y)])
        stress = tension_field(strains, 0.3).stress[:, 0]
        assert _integral(stress, y) == pytest.approx(force, rel=1e-4)
        moment = 2.0 * _integral(stress * y, y) / force
        assert moment == pytest.approx(
            kappa_hat / 3.0 if taut else 1.0 - 2.0 / (3.0 * np.sqrt(kappa_hat)), rel=1e-3
        )
        slack = np.mean(stress == 0.0)
        assert slack == pytest.approx(0.0 if taut else 1.5 * moment - 0.5, abs=1e-3)


def _integral(values: Floats, at: Floats) -> float:
    return float(0.5 * (values[1:] + values[:-1]) @ np.diff(at))
