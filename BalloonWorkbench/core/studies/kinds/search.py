# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for the best balloon among those with one choice of what is listed.

What may have any value between two ends goes through COBYLA (Powell, A direct search optimization method that
models the objective and constraint functions by linear interpolation, 1994): it takes no derivatives, which
the noise of meshes would spoil, keeps to limits, and asks for the same balloons each time. It finds the best
around where it began; of several valleys optuna's tree-structured Parzen estimators (Bergstra et al., 2011)
find the deepest more often, with more balloons.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.packages import without_scipy
from BalloonWorkbench.core.studies.kinds.goal import OPTUNA, Goal
from BalloonWorkbench.core.studies.study import Row
from BalloonWorkbench.core.types import Floats

#: Steps of the search, in parts of each range: the first one, and the last. Values are taken on a finer grid.
_FIRST, _LAST, _GRID = 0.25, 0.001, 10_000
MOST_TRIALS = 40
#: The search keeps so far within each limit, as it ends a little on either side of where it aims.
_INSIDE = 2e-3
#: Of a balloon that could not be made: outside of each limit by all of it.
_FAILED = 1.0


@dataclass(frozen=True)
class Trial:
    """A balloon that was tried.

    values   as they are written, of what may be chosen; shares: how far along each range
    results  None where it failed
    """

    values: Row
    results: Mapping[str, Any] | None
    shares: tuple[float, ...] = ()


#: Works out a balloon from its values by column; None where that failed.
Evaluate = Callable[[Row], Mapping[str, Any] | None]


def search(goal: Goal, choice: Row, evaluate: Evaluate) -> list[Trial]:
    """The balloons that were tried for one choice, in their order, each once.

    Raises what evaluate raises, and MissingPackageError.
    """
    tried: dict[tuple[int, ...], Trial] = {}

    def results_at(shares: Floats) -> Mapping[str, Any]:
        at = tuple(round(float(share) * _GRID) for share in np.clip(shares, 0.0, 1.0))
        if at not in tried:
            between = zip(goal.ranges.items(), at, strict=True)
            values = {**choice, **{name: axis.at(step / _GRID) for (name, axis), step in between}}
            tried[at] = Trial(values, evaluate(values), tuple(step / _GRID for step in at))
        return tried[at].results or {}

    if goal.search == OPTUNA and goal.ranges:
        _sample(goal, results_at)
        return list(tried.values())
    start = np.full(len(goal.ranges), 0.5)
    first = goal.cost(results_at(start))
    if len(start):
        _minimize(goal, results_at, start, abs(first) if 0.0 < abs(first) < math.inf else 1.0)
    return list(tried.values())


def _sample(goal: Goal, results_at: Callable[[Floats], Mapping[str, Any]]) -> None:
    """The same samples each time, as many as the other search may take. Raises MissingPackageError."""
    try:
        optuna: Any = importlib.import_module("optuna")
    except ImportError as error:
        raise MissingPackageError(
            "The search with optuna needs its package: install it with pip install optuna, or leave out"
            ' "search".'
        ) from error

    def cost(trial: Any) -> float:
        results = results_at(np.array([trial.suggest_float(name, 0.0, 1.0) for name in goal.ranges]))
        for limit in goal.limits:
            lack = limit.lack(results)
            trial.set_constraint(limit.text, lack + _INSIDE if math.isfinite(lack) else _FAILED)
        value = goal.cost(results)
        if not math.isfinite(value):
            raise optuna.TrialPruned
        return value

    optuna.logging.set_verbosity(optuna.logging.CRITICAL)  # a search that is stopped is no failure
    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=0))
    study.optimize(cost, n_trials=MOST_TRIALS)


def _minimize(
    goal: Goal, results_at: Callable[[Floats], Mapping[str, Any]], start: Floats, scale: float
) -> None:
    try:
        from scipy.optimize import minimize
    except ImportError as error:
        raise without_scipy(
            "The search for a goal needs scipy: install it with pip install scipy."
        ) from error

    def cost(shares: Floats) -> float:
        value = goal.cost(results_at(shares)) / scale
        return value if math.isfinite(value) else 10.0

    def room(shares: Floats) -> Floats:
        results = results_at(shares)
        lacks = [limit.lack(results) + _INSIDE for limit in goal.limits]
        limits = [-lack if math.isfinite(lack) else -_FAILED for lack in lacks]
        return np.concatenate([limits, shares, 1.0 - shares])

    minimize(
        cost,
        start,
        method="COBYLA",
        constraints=[{"type": "ineq", "fun": room}],
        options={"rhobeg": _FIRST, "tol": _LAST, "maxiter": MOST_TRIALS},
    )


def best(goal: Goal, trials: list[Trial]) -> Trial | None:
    """The best balloon within the limits, or the one nearest to them; None where none could be made."""
    made = [trial for trial in trials if trial.results is not None and goal.cost(trial.results) < math.inf]
    return min(made, key=lambda trial: _rank(goal, trial.results or {}), default=None)


def _rank(goal: Goal, results: Mapping[str, Any]) -> tuple[float, float]:
    return goal.lack(results), goal.cost(results)
