# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study of tolerances: a balloon as it is meant, and as it comes out of the workshop; a row each."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.write import write_files
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import SAMPLE_OF_TOLERANCES
from BalloonWorkbench.core.studies.plan import planned
from BalloonWorkbench.core.studies.results import results_of
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.tolerances.samples import SAMPLES, SEED, Sample, Tolerances, read_tolerances
from BalloonWorkbench.core.tolerances.spread import ErrorSource
from BalloonWorkbench.core.tolerances.summary import MEASURES, mean_error_column, summary
from BalloonWorkbench.core.units import number_text

TOLERANCES, COUNT, SEEDED = "tolerances", "samples", "seed"
FILE = "tolerances.json"
_NAME, _ALONE = "sample", "alone"


def tolerance_study(data: Mapping[str, Any], fixed: Mapping[str, Any], folder: Path) -> Study:
    """The study that {"fixed": {...}, "tolerances": {...}, "samples": 200, "seed": 1} declares."""
    several = next((name for name, value in fixed.items() if isinstance(value, (list, dict))), None)
    if several is not None:
        raise InputError(f"A study of tolerances is about one balloon: give {several} a single value.")
    tolerances = read_tolerances(data[TOLERANCES], data.get(COUNT, SAMPLES), data.get(SEEDED, SEED))
    rows = [{**fixed, **_row_of(sample)} for sample in tolerances.samples()]
    own = (_NAME, _ALONE, *(_column(source, tolerances) for source in tolerances.spreads))
    shared = {TOLERANCES: data[TOLERANCES], SEEDED: tolerances.seed}
    return Study((*fixed, *own), rows, folder=folder, task=SAMPLE_OF_TOLERANCES, own=own, shared=shared)


def sample_of(request: Mapping[str, Any]) -> tuple[Sample, Tolerances]:
    """The sample that a row asks for, and the tolerances that it is one of."""
    tolerances = read_tolerances(request[TOLERANCES], seed=request[SEEDED])
    return _sample(request, tolerances), tolerances


def _sample(row: Mapping[str, Any], tolerances: Tolerances) -> Sample:
    strayed = {source: row.get(_column(source, tolerances)) for source in tolerances.spreads}
    return Sample(
        str(row[_NAME]),
        {
            source: float(value)
            for source, value in strayed.items()
            if value is not None and not _varies(source, tolerances)
        },
        {
            source: int(value)
            for source, value in strayed.items()
            if value is not None and _varies(source, tolerances)
        },
        next((source for source in ErrorSource if source.key == row.get(_ALONE)), None),
    )


def _row_of(sample: Sample) -> dict[str, Any]:
    """A sample as cells of a row: deviations in SI units or as shares, numbers of fields of errors."""
    return {
        _NAME: sample.name,
        _ALONE: None if sample.alone is None else sample.alone.key,
        **{f"{source.key}_off": value for source, value in sample.deviations.items()},
        **{f"{source.key}_field": number for source, number in sample.fields.items()},
    }


def _varies(source: ErrorSource, tolerances: Tolerances) -> bool:
    return tolerances.spreads[source].along is not None


def _column(source: ErrorSource, tolerances: Tolerances) -> str:
    return f"{source.key}_{'field' if _varies(source, tolerances) else 'off'}"


def tolerance_summary(study: Study, folder: StudyFolder) -> dict[str, Any]:
    """What the rows that are there say in all; see `summary`."""
    tolerances = read_tolerances(study.shared[TOLERANCES], seed=study.shared[SEEDED])
    rows: list[tuple[Sample, Mapping[str, Any] | None]] = []
    for row in planned(study):
        if row.job is None or not folder.has(row.key):
            continue
        report = folder.report(row.key)
        rows.append((_sample(row.values, tolerances), None if report is None else _flat(report)))
    return {TOLERANCES: study.shared[TOLERANCES], SEEDED: tolerances.seed, **summary(rows)}


def _flat(report: Mapping[str, Any]) -> dict[str, Any]:
    errors = report.get("seam_error_mm", {})
    means = {mean_error_column(source): errors.get(source.key) for source in ErrorSource}
    return results_of(report) | means


def write_summary(folder: StudyFolder, data: Mapping[str, Any]) -> tuple[Path, list[str]]:
    """Write what `tolerance_summary` says to tolerances.json; its path, and lines for people. ExportError."""
    text = json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    write_files(folder.place, {FILE: text.encode()})
    return folder.place / FILE, summary_lines(data)


def summary_lines(data: Mapping[str, Any]) -> list[str]:
    """The summary as sentences."""
    count, failed, moving = data["samples"], data["failed"], data["not_at_rest"]
    lines = [f"Samples: {count}, of these failed: {failed}, not at rest: {moving}"]
    for key, one in data["measures"].items():
        low, middle, high = (number_text(each["value"], 4) for each in one["quantiles"])
        bars = _spans(one["tornado"])
        what = f"; most by {', '.join(bars)}" if bars else ""
        lines.append(f"{MEASURES[key]} ({_unit(key)}): 5 % {low}, 50 % {middle}, 95 % {high}{what}")
    safe = data["safe_pressure"]
    return lines if safe is None else [*lines, safe["text"]]


def _spans(bars: Sequence[Mapping[str, Any]]) -> list[str]:
    """The longest three bars of a tornado chart, as far as they can be seen beside the first."""
    longest = abs(bars[0]["high"] - bars[0]["low"]) if bars else 0.0
    return [
        f"{bar['source']} ({number_text(bar['low'], 4)} to {number_text(bar['high'], 4)})"
        for bar in bars[:3]
        if longest > 0.0 and abs(bar["high"] - bar["low"]) > 0.05 * longest
    ]


def _unit(key: str) -> str:
    return {"m3": "m³", "g": "g", "mm": "mm", "Pa": "Pa"}[key.rpartition("_")[2]]
