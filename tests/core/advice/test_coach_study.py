# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the coach says before the design, against the simulation; `make validation` does 240 shapes."""

from __future__ import annotations

from coach_study import compared, new_scores
from drawn_flaws import KINDS, flawed

SHAPES = 3 * len(KINDS)


def test_findings_hold_in_the_simulation() -> None:
    scores = new_scores()
    relative_volume = []
    for seed in range(SHAPES):
        advice, truth = compared(flawed(seed), scores, f"{seed} {KINDS[seed % len(KINDS)]}")
        relative_volume.append(advice.relative_volume / truth.relative_volume())
        assert abs(advice.map.thickness.max() / truth.thick.max() - 1.0) < 0.04, seed  # a ring: 0.032
    assert max(abs(ratio - 1.0) for ratio in relative_volume) < 0.02
    stray = [line for score in scores.values() for line in score.stray]
    right, wrong = (sum(getattr(score, name) for score in scores.values()) for name in ("right", "wrong"))
    found, missed = (sum(getattr(score, name) for score in scores.values()) for name in ("found", "missed"))
    assert right > 40
    assert right / (right + wrong) > 0.9, stray
    assert found / (found + missed) > 0.8, stray
    for rule, score in scores.items():
        assert score.precision > 0.75, (rule, score.stray)
