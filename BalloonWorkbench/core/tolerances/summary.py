# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the samples of a tolerance study say in all: quantiles, what matters most, what may be relied on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from BalloonWorkbench.core.tolerances.samples import HIGH, LOW, Sample
from BalloonWorkbench.core.tolerances.spread import ErrorSource
from BalloonWorkbench.core.tolerances.statistics import (
    CONFIDENCE,
    LEAST_SAMPLES,
    QUANTILES,
    quantile,
    rank_correlation,
    sure_minimum,
)
from BalloonWorkbench.core.types import Floats
from BalloonWorkbench.core.units import pressure_text

#: What is measured of each balloon: columns of a table, with what people read.
MEASURES = {
    "volume_m3": "Volume",
    "thickness_mm": "Thickness",
    "lift_g": "Lift",
    "weight_g": "Weight",
    "error_mean_mm": "Silhouette error, mean",
    "error_max_mm": "Silhouette error, largest",
    "pressure_Pa": "Pressure",
    "safe_pressure_Pa": "Safe pressure",
}
SAFE, INSIDE = "safe_pressure_Pa", "pressure_Pa"


@dataclass(frozen=True)
class Influence:
    """A bar of a tornado chart: what a source by itself, between its 5 and 95 % points, makes of a measure.

    low, high  the measure at these points; of errors along a seam their quantiles over fields of errors
    """

    source: str
    title: str
    low: float
    high: float

    @property
    def span(self) -> float:
        """How much it matters."""
        return abs(self.high - self.low)


def mean_error_column(source: ErrorSource) -> str:
    """Where a row has the mean error along a seam [mm]."""
    return f"{source.key}_mean_mm"


def summary(rows: Sequence[tuple[Sample, Mapping[str, Any] | None]]) -> dict[str, Any]:
    """All that the rows of a study say, as plain data; they may be those that are finished so far.

    rows  samples with the MEASURES of their balloons, whether these "converged", and the mean errors of seams
          in millimetres by `mean_error_column`; None for a balloon that could not be made
    """
    proper = [(sample, row) for sample, row in rows if sample.alone is None and sample.name != "nominal"]
    good = [(sample, row) for sample, row in proper if row is not None]
    nominal = next((row for sample, row in rows if sample.name == "nominal"), None) or {}
    known = [key for key in MEASURES if any(row.get(key) is not None for _, row in good)]
    sources = [source for source in ErrorSource if any(_strays(sample, source) for sample, _ in rows)]
    return {
        "samples": len(proper),
        "failed": len(proper) - len(good),
        "not_at_rest": sum(not row["converged"] for _, row in good),
        "confidence": CONFIDENCE,
        "measures": {
            key: {
                "title": MEASURES[key],
                "nominal": nominal.get(key),
                "quantiles": _quantiles(_values(good, key)),
                "tornado": [
                    {"source": bar.source, "title": bar.title, "low": bar.low, "high": bar.high}
                    for bar in tornado(rows, key)
                ],
                "rank_correlation": {source.key: _correlation(good, source, key) for source in sources},
            }
            for key in known
        },
        "safe_pressure": _safe(proper, good),
    }


def tornado(rows: Sequence[tuple[Sample, Mapping[str, Any] | None]], key: str) -> list[Influence]:
    """The bars of one measure, the longest first."""
    bars = []
    for source in ErrorSource:
        alone = [(sample, row) for sample, row in rows if sample.alone is source and row is not None]
        alone.sort(key=lambda each: each[0].deviations.get(source, 0.0))
        values = _values(alone, key)
        if not len(values):
            continue
        if alone[0][0].fields:
            low, high = (float(np.quantile(values, share)) for share in (LOW, HIGH))
        elif len(values) == 2:
            low, high = map(float, values)
        else:
            continue
        bars.append(Influence(source.key, source.title, low, high))
    return sorted(bars, key=lambda bar: -bar.span)


def _strays(sample: Sample, source: ErrorSource) -> bool:
    return source in sample.deviations or source in sample.fields


def _values(rows: Sequence[tuple[Sample, Mapping[str, Any]]], key: str) -> Floats:
    return np.array([row[key] for _, row in rows if row.get(key) is not None], dtype=np.float64)


def _quantiles(values: Floats) -> list[dict[str, Any]]:
    each = [quantile(values, share) for share in QUANTILES]
    return [{"share": one.share, "value": one.value, "from": one.low, "to": one.high} for one in each]


def _correlation(rows: Sequence[tuple[Sample, Mapping[str, Any]]], source: ErrorSource, key: str) -> float:
    """Of a source's deviation, of errors along a seam their mean, with a measure."""
    pairs = [
        (sample.deviations.get(source, row.get(mean_error_column(source))), row.get(key))
        for sample, row in rows
        if row.get(key) is not None and _strays(sample, source)
    ]
    one, other = np.array(pairs, dtype=np.float64).reshape(-1, 2).T
    return rank_correlation(one, other)


def _safe(
    proper: Sequence[tuple[Sample, Mapping[str, Any] | None]],
    good: Sequence[tuple[Sample, Mapping[str, Any]]],
) -> dict[str, Any] | None:
    """The safe pressure to rely on; one that was not made or is not at rest counts as one that bursts."""
    settled = [(sample, row) for sample, row in good if row["converged"]]
    values = _values(settled, SAFE)
    if not len(values):
        return None
    surely = sure_minimum(values, len(proper) - len(values))
    above = sum(row[INSIDE] > row[SAFE] for _, row in settled if row.get(SAFE) is not None)
    return {
        "surely_Pa": surely,
        "above": int(above),
        "text": " ".join([_sure_text(surely, len(proper)), *_above_text(int(above), len(proper))]),
    }


def _sure_text(surely: float | None, count: int) -> str:
    if surely is not None:
        return (
            f"At least 95 of 100 balloons bear {pressure_text(surely)} with their margin, by {count} samples"
            " and with a confidence of 95 %."
        )
    if count < LEAST_SAMPLES:
        return (
            f"With so few samples, {count}, nobody can say which pressure 95 of 100 balloons bear: take"
            f" {LEAST_SAMPLES} or more."
        )
    return "Too many samples could not be made to say which pressure 95 of 100 balloons bear."


def _above_text(above: int, count: int) -> list[str]:
    if not above:
        return []
    return [f"In {above} of {count} samples the pressure is above the safe one: fill it less."]
