# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of a seam that vary smoothly along it: a stationary random field on a closed line.

A cutter's head and a sealing bar wander slowly, so places near each other have nearly the same error. The
field is a Fourier series round the line with independent normal coefficients (Shinozuka and Deodatis,
Simulation of stochastic processes by spectral representation, Appl. Mech. Rev. 44, 1991, 191-204); its
correlation is exp(-d^2/2l^2) at a distance d along the line, wrapped round it.
"""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.geometry.polyline import edge_vectors
from BalloonWorkbench.core.geometry.vectors import perpendicular, unit
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import length_text

MOST_WAVES = 400  # round one line
_NEGLIGIBLE = 4.0  # standard deviations of a wave number, beyond which nothing is left
#: A corner moves out along its bisector at most so many times as far as its sides.
MOST_MITRE = 2.0


def wave_weights(around: float, correlation: float) -> Floats:
    """Share of the variance (k,) that each number of waves round a line has, from none upwards; in all 1.

    around       length of the line [m]
    correlation  length l along it, over which errors stay alike [m]
    Raises InputError for errors that vary so fast that no mesh shows them.
    """
    per_wave = 2.0 * np.pi * correlation / around
    count = int(np.ceil(_NEGLIGIBLE / per_wave))
    if count > MOST_WAVES:
        least = _NEGLIGIBLE * around / (2.0 * np.pi * MOST_WAVES)
        raise InputError(
            f"Errors that stay alike over {length_text(correlation)} alone are too fine for a seam of"
            f" {length_text(around)}: give at least {length_text(1.01 * least, 2)} as 'along'."
        )
    weights = np.exp(-0.5 * (per_wave * np.arange(count + 1)) ** 2)
    weights[1:] *= 2.0  # forth and back
    return np.asarray(weights / weights.sum())


def field(at: Floats, around: float, correlation: float, seed: tuple[int, ...]) -> Floats:
    """A normal field of mean 0 and variance 1 at lengths (n,) along a closed line: (n,).

    seed  names the field: the same gives the same one. Raises as `wave_weights` does.
    """
    weights = wave_weights(around, correlation)
    cosines, sines = np.random.default_rng(seed).standard_normal((len(weights), 2)).T * np.sqrt(weights)
    angles = np.outer(2.0 * np.pi * at / around, np.arange(len(weights)))
    return np.asarray(np.cos(angles) @ cosines + np.sin(angles) @ sines)


def offset(loop: Floats, errors: Floats) -> Floats:
    """A closed loop (n, 2) whose sides have moved to their right by errors (n,) [m], away from the film.

    At a corner the sides meet again: it moves along its bisector, by MOST_MITRE at most.
    """
    after = unit(perpendicular(edge_vectors(loop)))
    before = np.roll(after, 1, axis=0)
    bisector = unit(before + after)
    lean = np.einsum("ij,ij->i", bisector, after)
    longer = 1.0 / np.maximum(lean, 1.0 / MOST_MITRE)
    return np.asarray(loop - (errors * longer)[:, None] * bisector)
