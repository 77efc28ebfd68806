# SPDX-License-Identifier: LGPL-2.1-or-later
"""The safe pressure of a heart with a side band whose cleft is sharp: the same on each mesh, in balance."""

from __future__ import annotations

import numpy as np
import pytest

from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bodies.banded import band_joints, band_places, banded_bag
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.sampling import resample
from BalloonWorkbench.core.making.safety import safety
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.results.single_panels import single_panels
from BalloonWorkbench.core.results.strength import seam_forces
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.problem import NewtonSettings

PRESSURE, BAND, MYLAR = 1000.0, 0.04, film("mylar")


def sharp_heart() -> Outline:
    """Two lobes that meet in a cleft, above a tip."""
    angles = np.radians(np.linspace(-35.0, 150.0, 80))
    right = np.stack([0.07 + 0.08 * np.cos(angles), 0.05 + 0.08 * np.sin(angles)], axis=1)
    right = right[right[:, 0] > 1e-4]
    cleft, tip = np.array([[0.0, 0.05 + np.sqrt(0.08**2 - 0.07**2)]]), np.array([[0.0, -0.16]])
    return Outline(resample(np.concatenate([tip, right, cleft, right[::-1] * (-1.0, 1.0)]), 0.004))


def test_the_load_at_a_sharp_cleft_is_that_of_a_balance_on_each_mesh() -> None:
    """What pulls at the front's seam is the pressure on the area within it (divergence theorem)."""
    outline = sharp_heart()
    joints = band_joints(outline.loops)
    bag = banded_bag(outline, BAND, joints=joints)
    places = band_places(outline.loops, joints, BAND)
    safe = []
    for edge in (0.014, 0.01):
        usual = inflate_bag(bag, MYLAR, PRESSURE, places=places, mesh_size=edge).inflation
        # to the end: how far from it the usual solve stops hangs on rounding
        balloon = inflate(usual.assembly, MYLAR, PRESSURE, start=usual, settings=NewtonSettings(1e-9))
        front = single_panels(balloon)[0]
        ((vertices, _, forces),) = seam_forces(front, MYLAR)
        rim = front.positions[vertices]
        area = 0.5 * np.cross(rim, np.roll(rim, -1, axis=0)).sum(axis=0)
        assert np.linalg.norm(forces.sum(axis=0)) == pytest.approx(PRESSURE * np.linalg.norm(area), rel=0.01)
        found = safety(balloon, MYLAR)
        assert found.safe_pressure is not None
        safe.append(found.safe_pressure)
        # the cleft pulls in a point: what is told is that force shared over two seal widths, or more
        assert found.weld_load.value >= 0.99 * np.linalg.norm(forces, axis=1).max() / (2.0 * MYLAR.seal_width)
        assert found.weld_load.place[:2] == pytest.approx(outline.outer[len(outline.outer) // 2], abs=0.03)
    assert safe[0] == pytest.approx(safe[1], rel=0.03)
