# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of the correction, when it ends, and what it does where a step leads to no mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.correction import fit as correction
from BalloonWorkbench.core.correction.fit import MOST_HALVINGS, PROOF_MESHES, Method, fit
from BalloonWorkbench.core.correction.iterate import Iterate, make_iterate
from BalloonWorkbench.core.correction.mixing import AndersonMixing, UpdateRule
from BalloonWorkbench.core.correction.seam_map import SeamMap
from BalloonWorkbench.core.correction.stages import (
    AT_REST,
    BROAD,
    FINE,
    LIMITS,
    NEAR,
    History,
    finished,
    first_stage,
    hands_over,
)
from BalloonWorkbench.core.correction.step import Scales, next_seam_map
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import MeshError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.types import Floats


def star(mesh_size: float = 0.03, **method: Any) -> Design:
    return fit(NAMED["star"], film("mylar"), 2000.0, mesh_size=mesh_size, method=Method(**method))


# Stages


@pytest.mark.parametrize("holes", [False, True])
@pytest.mark.parametrize("coarse", [False, True])
def test_stages_go_from_coarse_and_broad_to_fine_and_at_rest(holes: bool, coarse: bool) -> None:
    stage, stages = first_stage(holes, coarse), []
    while stage is not None:
        stages.append(stage)
        stage = stage.following
    assert [stage.coarsening for stage in stages] == ([1.8] if coarse else []) + [1.0, 1.0]
    assert [stage.smoothing for stage in stages] == [BROAD] * (len(stages) - 1) + [1.0]
    assert stages[-1] == (AT_REST if holes else FINE)


GOOD = History(iterates=4, newton_steps=30, error=4e-4, best_error=4e-4)


@pytest.mark.parametrize(
    ("change", "over"),
    [
        ({}, True),
        ({"best_error": 6e-4}, False),  # more is gained
        ({"best_error": 6e-4, "stalled": 1}, True),  # nothing was gained, and it is good
        ({"best_error": 2e-3, "stalled": 3}, False),
        ({"best_error": 2e-3, "stalled": 4}, True),
        ({"best_error": 2e-3, "iterates": LIMITS.iterates}, True),
        ({"best_error": 2e-3, "newton_steps": LIMITS.newton_steps}, True),
        ({"weld_error": 4e-3}, False),
    ],
)
def test_the_end_is_where_nothing_more_is_gained(change: dict[str, Any], over: bool) -> None:
    history = History(**{**vars(GOOD), **change})
    assert finished(FINE, history) == finished(AT_REST, history) == over


def test_a_coarse_mesh_is_never_good_enough() -> None:
    assert not finished(first_stage(holes=False, coarse=True), GOOD)


@pytest.mark.parametrize(
    ("error", "stalled", "over"), [(0.9 * NEAR, 0, True), (1.1 * NEAR, 0, False), (1.1 * NEAR, 1, True)]
)
def test_a_stage_hands_over_when_the_drawing_is_near(error: float, stalled: int, over: bool) -> None:
    history = History(error=error, stalled=stalled)
    assert hands_over(first_stage(holes=False, coarse=False), history) == over
    assert not hands_over(FINE, history)


@pytest.mark.parametrize("smoothing", [1.0, 2.0])
def test_a_method_may_smooth_alike_throughout(smoothing: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """In mesh sizes of the stage, whatever stage that is."""
    smoothed = []

    def recorded(current: Iterate, rule: UpdateRule, scales: Scales) -> SeamMap:
        smoothed.append(scales.smoothing / scales.edge)
        return next_seam_map(current, rule, scales)

    monkeypatch.setattr(correction, "next_seam_map", recorded)
    star(smoothing=smoothing, broad=1.0)
    assert len(smoothed) > 1
    np.testing.assert_allclose(smoothed, smoothing)


# The update rule


class Recorded:
    """A rule that never moves the pattern."""

    def __init__(self, gain: float) -> None:
        self.asked: list[tuple[Iterate, Floats]] = []
        RULES.append(self)

    def step(self, current: Iterate, correction: Floats) -> Floats:
        self.asked.append((current, correction))
        return np.zeros_like(correction)


RULES: list[Recorded] = []


def test_another_update_rule_takes_the_place_of_mixing() -> None:
    """One that never moves the pattern ends with the first pattern, after so many iterates without gain."""
    RULES.clear()
    design = star(update_rule=Recorded)
    asked = [one for rule in RULES for one in rule.asked]
    assert asked
    for current, wanted in asked:
        assert wanted.shape == np.concatenate(current.seam_map.pattern).shape
        np.testing.assert_array_equal(current.seam_map.outline.outer, design.pattern.outer)
    assert design.passes < LIMITS.iterates
    assert design.residual.mean > 2.0 * star().residual.mean


def linear(mixing: AndersonMixing, steps: int) -> float:
    """What is left of x = b after steps on the correction A (b - x), A with values from 0.2 to 1.4."""
    matrix, goal = np.diag([0.2, 0.5, 1.4]), np.array([1.0, -2.0, 3.0])
    point = np.zeros(3)
    for _ in range(steps):
        point = point + mixing.mixed(point, matrix @ (goal - point))
    return float(np.linalg.norm(point - goal))


def test_memory_pays() -> None:
    """The plain fixed point leaves 0.8^8 = 0.17 of the slowest part, a memory nearly nothing."""
    assert linear(AndersonMixing(1.0, depth=0), 8) == pytest.approx(0.8**8, rel=0.02)
    assert linear(AndersonMixing(1.0), 8) < 1e-3


# Patterns without a mesh


def failing(monkeypatch: pytest.MonkeyPatch, fails: range, place: tuple[float, float] | None) -> list[Floats]:
    """Let so many of the tries to make an iterate fail; the patterns that were tried."""
    tried: list[Floats] = []

    def tries(simulation: Any, seam_map: Any, *given: Any, **options: Any) -> Iterate:
        tried.append(seam_map.pattern[0])
        if len(tried) - 1 in fails:
            raise MeshError("too thin", place)
        return make_iterate(simulation, seam_map, *given, **options)

    monkeypatch.setattr(correction, "make_iterate", tries)
    return tried


@pytest.mark.parametrize("place", [None, (0.0, 0.12)])
def test_half_of_a_step_without_a_mesh_is_taken_back(
    monkeypatch: pytest.MonkeyPatch, place: tuple[float, float] | None
) -> None:
    tried = failing(monkeypatch, range(1, 2), place)
    design = star(symmetric=False)
    before, wide, half = tried[:3]
    back = np.linalg.norm(half - before, axis=1), np.linalg.norm(wide - before, axis=1)
    if place is None:
        np.testing.assert_allclose(back[0], 0.5 * back[1], atol=1e-12)
    else:
        assert 0.0 < np.linalg.norm(half - wide, axis=1).max() <= 0.5 * back[1].max() + 1e-12
    assert design.reached


def test_what_was_reached_is_kept_where_no_step_has_a_mesh(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = failing(monkeypatch, range(2, 1000), None)
    design = star(symmetric=False)
    assert len(tried) == 2 + MOST_HALVINGS + 1 + len(PROOF_MESHES[0])
    assert design.passes == 2
    assert any(design.pattern.outer.tobytes() == pattern.tobytes() for pattern in tried[:2])


@pytest.mark.parametrize(("place", "tries"), [(None, 1), ((0.0, 0.12), MOST_HALVINGS + 1)])
def test_a_drawing_without_a_mesh_is_refused(
    monkeypatch: pytest.MonkeyPatch, place: tuple[float, float] | None, tries: int
) -> None:
    """Where the thin place is known, the first pattern goes back to the drawing there before."""
    tried = failing(monkeypatch, range(1000), place)
    with pytest.raises(MeshError, match="too thin"):
        star(symmetric=False)
    assert len(tried) == tries


def test_a_coarse_mesh_that_fails_gives_way_to_the_fine_one(monkeypatch: pytest.MonkeyPatch) -> None:
    plain = star(mesh_size=0.0075)
    tried = failing(monkeypatch, range(1), (0.0, 0.12))
    design = star(mesh_size=0.0075)
    assert len(tried) > 1
    assert design.reached
    assert design.meshes == plain.meshes - 1  # the coarse one
