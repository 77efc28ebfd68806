# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances between film and body count both ways, over film that is bent between its vertices."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from divided import octants
from solids import ball, box

from BalloonWorkbench.core.film.library import film as film_named
from BalloonWorkbench.core.panels.surface import Surface
from BalloonWorkbench.core.target_design.curved_film import curved_film
from BalloonWorkbench.core.target_design.fit_target import begun
from BalloonWorkbench.core.target_design.off_target import (
    TargetSurface,
    both_ways,
    clearances,
    target_residual,
)
from BalloonWorkbench.core.targets.target import Target
from BalloonWorkbench.core.types import Floats, Ints, no_progress


def scaled(target: Target, scale: float) -> tuple[Floats, Ints]:
    return target.points * scale, target.triangles


def test_film_round_a_ball_is_as_far_as_it_is_larger() -> None:
    body = ball(count=12)
    off = target_residual(TargetSurface(body), *scaled(body, 1.1))
    assert [off.mean, off.p95, off.max] == pytest.approx([0.1] * 3, rel=0.02)
    assert clearances(TargetSurface(body), *scaled(body, 1.1)) == pytest.approx((0.1, 0.1), rel=0.02)
    assert clearances(TargetSurface(body), *scaled(body, 0.9)) == pytest.approx((-0.1, -0.1), rel=0.02)


def test_a_spike_that_the_film_leaves_out_counts() -> None:
    plain = ball(count=12)
    points = plain.points.copy()
    points[np.argmax(points[:, 2])] *= 1.5
    spiked = Target(points, plain.triangles)
    off = target_residual(TargetSurface(spiked), *scaled(plain, 1.0))
    assert off.max == pytest.approx(0.5, rel=0.02)
    assert clearances(TargetSurface(spiked), *scaled(plain, 1.0))[0] == pytest.approx(-0.5, rel=0.02)


def test_distances_of_the_body_from_the_film_follow_its_vertices() -> None:
    body, film = ball(count=8), ball((1.1, 0.8, 1.0), count=5)
    surface, rng = TargetSurface(body), np.random.default_rng(2)
    moves = rng.normal(size=(*film.points.shape, 2))
    own = np.repeat(np.arange(len(film.points), dtype=np.int32)[:, None], 2, axis=1)
    away = surface.film_away(film.points, film.triangles, own)
    assert away.off.distances.min() < -0.05 < 0.05 < away.off.distances.max()
    step = 1e-6
    for column, expected in zip(np.moveaxis(moves, 2, 0), away.follow(moves).T):
        ahead, back = (
            surface.film_away(film.points + sign * step * column, film.triangles, own).off.distances
            for sign in (1.0, -1.0)
        )
        found = (ahead - back) / (2.0 * step)
        # at an edge of the film a place may go on to the next triangle
        assert np.mean(np.abs(found - expected) < 1e-3) > 0.97


def test_what_is_brought_down_is_the_mean_of_both_ways() -> None:
    """The spike counts in the correction as it does in what is told."""
    plain = octants()
    points = plain.target.points.copy()
    points[np.argmax(points @ (1.0, 1.0, 1.0))] *= 1.6
    spiked = replace(plain, target=replace(plain.target, points=points))
    correction = begun(plain, film_named("mylar"), 1000.0, 0.25, None, None, no_progress)
    simulation = replace(correction.simulation, surface=TargetSurface(spiked.target))
    made = replace(correction, simulation=simulation).first()
    counted = made.weights**2 @ np.abs(made.distances)
    film = curved_film(made.positions, made.inflation.directors, made.surface)
    ways = both_ways(simulation.surface, *film)
    assert counted == pytest.approx(np.mean([way.mean for way in ways[:2]]), rel=0.1)
    assert np.abs(made.distances).max() == pytest.approx(ways[1].max, rel=0.05)


def test_a_body_that_comes_through_between_the_vertices_is_seen() -> None:
    """The vertices of a box are all outside of a ball that stands out of its faces."""
    body, film = ball((1.2, 1.2, 1.2), count=12), box((2.0, 2.0, 2.0), count=1)
    assert np.linalg.norm(film.points, axis=1).min() > 1.2
    least, most = clearances(TargetSurface(body), film.points, film.triangles)
    assert least == pytest.approx(-0.2, abs=0.01)
    assert most == pytest.approx(np.sqrt(3.0) - 1.2, abs=0.01)


def test_film_with_directors_is_round_between_its_vertices() -> None:
    """Of a ball with its normals the middles of the sides lie on the ball, to the fourth order."""
    body = ball(count=6)
    count = len(body.points)
    alone = np.arange(count, dtype=np.int32)
    surface = Surface(body.points[:, :2], body.triangles, alone, alone, np.zeros(1, dtype=bool), 1)
    points, triangles = curved_film(body.points, body.points, surface)
    assert len(triangles) == 4 * len(body.triangles)
    assert np.abs(np.linalg.norm(points, axis=1) - 1.0).max() < 1e-3
    flat = 0.5 * (body.points[body.triangles[:, 0]] + body.points[body.triangles[:, 1]])
    assert np.abs(np.linalg.norm(flat, axis=1) - 1.0).max() > 0.01
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all(), "closed"
