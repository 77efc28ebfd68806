# SPDX-License-Identifier: LGPL-2.1-or-later
"""The web page of a study: its table with small pictures, and charts of what its results depend on."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any
from urllib.parse import quote

from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.core.web_pages.charts import histogram_chart, scatter_chart
from BalloonWorkbench.core.web_pages.page import TABLE, Markup, data_uri, element, web_page
from BalloonWorkbench.core.web_pages.table import TableColumn, Value, sortable_table, values_table

#: Rows that a browser sorts without waiting, points of a chart that can be told apart, charts on a page.
MOST_ROWS, MOST_POINTS, MOST_CHARTS = 1000, 1000, 8

#: Kinds of columns.
PLAIN, CHOSEN, RESULT = "plain", "chosen", "result"

Row = Mapping[str, Any]


@dataclass(frozen=True)
class StudyColumn:
    """A column of the table.

    name    its key in the rows, as in table.csv
    kind    CHOSEN or RESULT: what charts are about; PLAIN for anything else
    number  what a value of it is as a number, by how it is written, for charts; None: the values are numbers
    unit    of these numbers, where the name has none
    """

    name: str
    kind: str = PLAIN
    number: Mapping[Any, float] | None = None
    unit: str = ""

    @property
    def title(self) -> str:
        """As people read it: max_tension_N_per_m is max tension N/m."""
        return self.name.replace("_per_", "/").replace("_", " ")

    @property
    def axis(self) -> str:
        """The title with the unit."""
        return f"{self.title} {self.unit}".strip()

    def number_of(self, row: Row) -> float:
        """The number in a row; nan where there is none."""
        value = row.get(self.name)
        if self.number is not None:
            return self.number.get(value, math.nan)
        plain = isinstance(value, (int, float)) and not isinstance(value, bool)
        return float(value) if plain and value is not None else math.nan


@dataclass(frozen=True)
class StudyPage:
    """What the page is about.

    rows      of the table: by column, and under `failure` the sentence of one that has no balloon, else ""
    shown     the columns whose charts are drawn first, by name
    pictures  small PNGs by the value of `key` in a row
    links     where more about a row is, relative to the page, by the same
    charts    more of them, made by charts.py
    count     how many rows there are, where these are only the first ones
    """

    title: str
    columns: Sequence[StudyColumn]
    rows: Sequence[Row]
    shown: Sequence[str] = ()
    pictures: Mapping[str, bytes] = field(default_factory=dict)
    links: Mapping[str, str] = field(default_factory=dict)
    charts: Sequence[Markup] = ()
    count: int | None = None
    key: str = "key"
    failure: str = "failure"


def study_page(subject: StudyPage, language: str = "en", say: Say = in_english) -> bytes:
    """The page's content; the same bytes for the same. language: of the texts, as in "de"."""
    failed = sum(bool(row.get(subject.failure)) for row in subject.rows)
    counts = say(f"Rows: {len(subject.rows)}, without a balloon: {failed}")
    if subject.count is not None and subject.count > len(subject.rows):
        counts = say(f"The first {len(subject.rows)} of {subject.count} rows, without a balloon: {failed}")
    columns = [each for each in subject.columns if any(_known(row.get(each.name)) for row in subject.rows)]
    common = [each for each in columns if _is_common(each, subject.rows)]
    varied = [each for each in columns if each not in common]
    cards = []
    charts = [*subject.charts, *_charts(subject, varied, say)]
    if charts:
        plots = element("div", *(element("div", chart) for chart in charts), class_="cards")
        cards.append(element("section", element("h2", say("Charts")), plots, class_="card wide"))
    cards.append(element("section", _table(subject, varied, say), class_="card wide"))
    if common and len(subject.rows) > 1:
        values = [(each.title, _written(subject.rows[0][each.name], say)) for each in common]
        cards.append(
            element("section", values_table(say("The same in all rows"), values), class_="card wide")
        )
    head = element("header", element("h1", subject.title), element("p", counts, class_="soft"))
    return web_page(subject.title, language, [head, element("main", *cards, class_="cards")], [TABLE])


def _known(value: Any) -> bool:
    return value is not None and value != ""


def _is_common(column: StudyColumn, rows: Sequence[Row]) -> bool:
    """The same value in all rows, of more than one."""
    return len(rows) > 1 and len({repr(row.get(column.name)) for row in rows}) == 1


def _charts(subject: StudyPage, columns: Sequence[StudyColumn], say: Say) -> list[Markup]:
    """Each result over each number that was chosen; where none was, how often each result occurs."""
    made = [row for row in subject.rows if not row.get(subject.failure)]
    rows = made[:: max(1, -(-len(made) // MOST_POINTS))]
    numbers = {
        each.name: values
        for each in columns
        if sum(map(math.isfinite, values := [each.number_of(row) for row in rows])) > 1
    }
    chosen = [each for each in columns if each.name in numbers and each.kind == CHOSEN]
    results = [each for each in columns if each.name in numbers and each.kind == RESULT]
    order = {name: place for place, name in enumerate(subject.shown)}
    results.sort(key=lambda each: order.get(each.name, len(order)))
    if not chosen:
        return [
            histogram_chart(each.title, (each.title, numbers[each.name]), say("balloons"))
            for each in results[:MOST_CHARTS]
        ]
    names = [_name(subject, row) for row in rows]
    pairs = [*product(results, chosen)][:MOST_CHARTS]
    return [
        scatter_chart(
            say(f"{up.title} over {across.title}"),
            (across.axis, numbers[across.name]),
            (up.title, numbers[up.name]),
            names,
        )
        for up, across in pairs
    ]


def _name(subject: StudyPage, row: Row) -> str:
    """What a row is called: its first value, and its number."""
    first = subject.columns[0].name if subject.columns else subject.key
    return str(row.get(first, ""))


def _table(subject: StudyPage, columns: Sequence[StudyColumn], say: Say) -> Markup:
    rows = subject.rows[:MOST_ROWS]
    caption = say("Press a head to sort by it.")
    if len(rows) < len(subject.rows):
        caption = f"{say(f'The first {len(rows)} rows; the others are in table.csv.')} {caption}"
    pictured = any(row.get(subject.key) in subject.pictures for row in rows)
    heads = [TableColumn(each.title, numeric=_is_numeric(each, rows)) for each in columns]
    if pictured:
        heads.insert(0, TableColumn(say("Balloon"), sorts=False))
    lines: list[list[Value]] = []
    for row in rows:
        cells = [_cell(subject, each, row, say) for each in columns]
        lines.append([_picture(subject, row, say), *cells] if pictured else cells)
    return sortable_table(caption, heads, lines)


def _is_numeric(column: StudyColumn, rows: Sequence[Row]) -> bool:
    return any(math.isfinite(column.number_of(row)) for row in rows)


def _cell(subject: StudyPage, column: StudyColumn, row: Row, say: Say) -> Value:
    value = row.get(column.name)
    if column.name == subject.failure and value:
        return element("span", str(value), class_="failed")
    link = subject.links.get(row.get(subject.key, "")) if column is subject.columns[0] else None
    if link is not None:
        return element("a", _written(value, say), href=quote(link))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return _written(value, say) if _known(value) else None
    return float(value)


def _picture(subject: StudyPage, row: Row, say: Say) -> Value:
    png = subject.pictures.get(row.get(subject.key, ""))
    if png is None:
        return None
    alt = say(f"Balloon of row {_name(subject, row)}")
    return element("img", src=data_uri("image/png", png), alt=alt, loading="lazy")


def _written(value: Any, say: Say) -> str:
    if isinstance(value, bool):
        return say("yes" if value else "no")
    return number_text(value, 4) if isinstance(value, (int, float)) else str(value)
