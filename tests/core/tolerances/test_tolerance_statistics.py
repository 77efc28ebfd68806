# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantiles, bounds to rely on and what matters most, against formulas, SciPy and linear models."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy import stats

from BalloonWorkbench.core.tolerances.samples import Sample, read_tolerances
from BalloonWorkbench.core.tolerances.spread import ErrorSource
from BalloonWorkbench.core.tolerances.statistics import (
    LEAST_SAMPLES,
    QUANTILES,
    quantile,
    rank_correlation,
    sure_minimum,
)
from BalloonWorkbench.core.tolerances.summary import MEASURES, mean_error_column, summary, tornado

RANDOM = np.random.default_rng(1)


def test_a_quantile_lies_in_its_interval_as_often_as_it_says() -> None:
    """Of 600 studies with 200 samples of a known distribution."""
    truth = [stats.expon.ppf(share) for share in QUANTILES]
    hits = np.zeros(len(QUANTILES))
    for values in RANDOM.exponential(size=(600, 200)):
        for k, share in enumerate(QUANTILES):
            one = quantile(values, share)
            hits[k] += one.low <= truth[k] <= one.high
    assert (hits / 600.0 > 0.93).all()
    assert (hits / 600.0 < 0.99).all()


def test_intervals_are_those_of_the_binomial_distribution() -> None:
    ordered = np.arange(1.0, 201.0)
    one = quantile(ordered[::-1], 0.05)
    assert one.low == stats.binom.ppf(0.025, 200, 0.05)
    assert one.high == stats.binom.ppf(0.975, 200, 0.05) + 1


def test_few_samples_leave_an_end_open() -> None:
    one = quantile(np.arange(20.0), 0.05)
    assert one.low is None
    assert one.high is not None
    assert quantile(np.array([1.0]), 0.5).low is None


def test_the_sure_minimum_needs_59_samples() -> None:
    """Wilks, Determination of sample sizes for setting tolerance limits, Ann. Math. Stat. 12, 1941."""
    assert LEAST_SAMPLES == 59
    assert sure_minimum(np.arange(58.0)) is None
    assert sure_minimum(np.arange(59.0)) == 0.0


def test_the_sure_minimum_is_below_the_quantile_as_often_as_it_says() -> None:
    truth = stats.norm.ppf(0.05)
    safe = [sure_minimum(values) <= truth for values in RANDOM.standard_normal((600, 100))]
    assert 0.93 < np.mean(safe) < 0.995


def test_balloons_that_could_not_be_made_count_as_the_worst() -> None:
    values = np.arange(200.0)
    assert sure_minimum(values, 4) < sure_minimum(values)
    assert sure_minimum(values, 20) is None


def test_rank_correlation_is_spearmans() -> None:
    one, other = RANDOM.integers(0, 9, 40).astype(float), RANDOM.standard_normal(40)
    assert rank_correlation(one, other) == pytest.approx(stats.spearmanr(one, other).statistic)
    assert rank_correlation(one, np.ones(40)) == 0.0
    assert rank_correlation(np.exp(other), other) == pytest.approx(1.0)


SPREADS = read_tolerances(
    {
        "cut": {"normal": "0.2mm"},
        "thickness": {"uniform": "10%"},
        "modulus": {"normal": "5%"},
        "pressure": {"normal": "100Pa"},
    },
    100,
)


def row(sample: Sample) -> dict[str, Any]:
    """A balloon that follows its errors in proportion."""
    off = sample.deviations
    cut = 0.1 * np.sin(sample.fields[ErrorSource.CUT]) if sample.fields else 0.0
    volume = 1.0 + off.get(ErrorSource.THICKNESS, 0.0) - 0.2 * off.get(ErrorSource.MODULUS, 0.0) + cut
    return {
        **dict.fromkeys(MEASURES, 5.0),
        "volume_m3": volume,
        "safe_pressure_Pa": 3000.0 + off.get(ErrorSource.PRESSURE, 0.0),
        "pressure_Pa": 2900.0,
        "converged": True,
        mean_error_column(ErrorSource.CUT): cut,
    }


def rows() -> list[tuple[Sample, Mapping[str, Any] | None]]:
    return [(sample, row(sample)) for sample in SPREADS.samples()]


def test_the_tornado_begins_with_what_matters_most() -> None:
    bars = tornado(rows(), "volume_m3")
    assert [bar.source for bar in bars] == ["cut", "thickness", "modulus", "pressure"]
    of = {bar.source: bar for bar in bars}
    assert (of["thickness"].low, of["thickness"].high) == pytest.approx((0.91, 1.09))
    assert of["modulus"].high - of["modulus"].low == pytest.approx(-0.2 * 2 * 1.645 * 0.05, rel=1e-3)
    assert of["pressure"].span == 0.0


def test_the_summary_tells_quantiles_correlations_and_a_bound() -> None:
    data = summary(rows())
    assert (data["samples"], data["failed"], data["not_at_rest"]) == (100, 0, 0)
    volume = data["measures"]["volume_m3"]
    assert volume["nominal"] == 1.0
    assert volume["rank_correlation"]["thickness"] > 0.5 > abs(volume["rank_correlation"]["pressure"])
    low, middle, high = volume["quantiles"]
    assert low["value"] < middle["from"] < middle["value"] < middle["to"] < high["value"]
    safe = data["safe_pressure"]
    assert safe["surely_Pa"] < 3000.0 - 1.645 * 100.0
    assert "100 samples" in safe["text"]
    assert safe["above"] == sum(
        each.deviations[ErrorSource.PRESSURE] < -100 for each, _ in rows() if each.name.isdigit()
    )


def test_failed_balloons_and_those_not_at_rest_lower_what_is_sure() -> None:
    every = rows()
    worse = [(sample, None if sample.name == "3" else each) for sample, each in every]
    for sample, each in worse:
        if sample.name == "4" and each is not None:
            each["converged"] = False  # type: ignore[index]
    data = summary(worse)
    assert (data["failed"], data["not_at_rest"]) == (1, 1)
    assert data["safe_pressure"]["surely_Pa"] is None


def test_a_summary_of_few_or_no_samples_says_so() -> None:
    few = summary(rows()[:10])
    assert "nobody can say" in few["safe_pressure"]["text"]
    assert few["measures"]["volume_m3"]["tornado"] == []
    assert summary([])["measures"] == {}
    assert summary([(Sample("1"), None)])["safe_pressure"] is None


def test_the_order_of_rows_does_not_matter() -> None:
    every = rows()
    assert tornado(every, "volume_m3") == tornado(every[::-1], "volume_m3")
