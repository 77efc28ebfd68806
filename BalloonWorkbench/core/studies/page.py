# SPDX-License-Identifier: LGPL-2.1-or-later
"""The web page of a study, study.html: its table, small pictures that were kept, charts; needs no network."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.write import write_files
from BalloonWorkbench.core.options.option import Kind
from BalloonWorkbench.core.studies.columns import columns
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import PICTURE
from BalloonWorkbench.core.studies.results import RESULTS
from BalloonWorkbench.core.studies.study import Study
from BalloonWorkbench.core.studies.table import FAILURE, KEY, TableRow, headings, table_rows
from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import to_grams, to_mm
from BalloonWorkbench.core.web_pages.charts import Bar, tornado_chart
from BalloonWorkbench.core.web_pages.page import Markup
from BalloonWorkbench.core.web_pages.study_page import (
    CHOSEN,
    PLAIN,
    RESULT,
    StudyColumn,
    StudyPage,
    study_page,
)

PAGE = "study.html"
#: Rows that a page looks at, and pictures on it, whatever the study has.
_MOST_READ, _MOST_PICTURES = 20_000, 300
#: Results whose charts come first.
_SHOWN = ("volume_m3", "safe_pressure_Pa", "lift_g", "error_mean_mm", "max_tension_N_per_m", "weight_g")
#: What a small picture may weigh [bytes]: others have put their own there.
_LARGEST = 100_000
#: Units of numbers in charts, by kind, and what makes them of SI units.
_UNITS: dict[Kind, tuple[str, Callable[[float], float]]] = {
    Kind.LENGTH: ("mm", to_mm),
    Kind.HEIGHT: ("mm", to_mm),
    Kind.PRESSURE: ("Pa", float),
    Kind.VOLUME: ("m3", float),
    Kind.MASS: ("g", to_grams),
    Kind.TEMPERATURE: ("K", float),
    Kind.ANGLE: ("°", lambda angle: float(np.degrees(angle))),
}


def write_page(
    study: Study,
    folder: StudyFolder,
    title: str,
    failures: Mapping[str, str] | None = None,
    language: str = "en",
    say: Say = in_english,
    tolerances: Mapping[str, Any] | None = None,
) -> Path:
    """Write study.html into the folder of a study, over a former one; returns its path. Raises ExportError.

    title, language: of the page; failures: as for `table_rows`; tolerances: what `tolerance_summary` says,
    for charts of what matters most
    """
    rows = [*islice(table_rows(study, folder, failures), _MOST_READ)]
    options = [name for name in study.columns if name not in study.own]
    results = {result.name for result in RESULTS if result.kind is float}
    made = [
        _column(name, rows, name in results, chosen=name in options)
        for name in headings(study)
        if name != KEY
    ]
    pictures: dict[str, bytes] = {}
    for row in rows:
        if len(pictures) < _MOST_PICTURES and not row[FAILURE]:
            pictures |= _picture(folder, row[KEY])
    charts = [] if tolerances is None else tornado_charts(tolerances, say)
    subject = StudyPage(title, made, rows, _SHOWN, pictures, charts=charts, count=len(study.rows))
    write_files(folder.place, {PAGE: study_page(subject, language, say)})
    return folder.place / PAGE


def tornado_charts(data: Mapping[str, Any], say: Say = in_english) -> list[Markup]:
    """A chart of each measure of a tolerance study: what each source of errors makes of it by itself."""
    return [
        tornado_chart(
            say(f"{say(measure['title'])}: what changes it most"),
            key.replace("_", " "),
            measure["nominal"],
            [Bar(say(bar["title"]), bar["low"], bar["high"]) for bar in measure["tornado"]],
        )
        for key, measure in data["measures"].items()
        if measure["tornado"] and measure["nominal"] is not None
    ]


def _column(name: str, rows: list[TableRow], result: bool, *, chosen: bool) -> StudyColumn:
    if not chosen:
        return StudyColumn(name, RESULT if result else PLAIN)
    column = columns()[name]
    kind = column.option.kind if column.option is not None else Kind.TEXT
    unit, scaled = _UNITS.get(kind, ("", float))
    numbers = {value: _number(name, value) for value in {row[name] for row in rows}}
    known = {value: scaled(number) for value, number in numbers.items() if number is not None}
    return StudyColumn(name, CHOSEN, known, unit)


def _number(name: str, value: Any) -> float | None:
    """A value in SI units, the usual one where none is written; None for what is no number."""
    column = columns()[name]
    try:
        number = column.number(value)
    except InputError:  # the row tells it
        return None
    usual = column.option.default if column.is_number and column.option is not None else None
    return float(usual) if number is None and isinstance(usual, (int, float)) else number


def _picture(folder: StudyFolder, key: str) -> dict[str, bytes]:
    try:
        path = folder.of(key) / PICTURE
        return {key: path.read_bytes()} if path.stat().st_size <= _LARGEST else {}
    except OSError:
        return {}
