# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of a web page: names with values, and rows that are sorted where a column's head is pressed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.core.web_pages.page import Content, Markup, element

#: What stands in a cell; None for nothing.
Value = str | float | Markup | None


def values_table(title: str, rows: Sequence[tuple[str, Content]]) -> Markup:
    """Names and their values, with a title."""
    lines = [element("tr", element("th", name, scope="row"), element("td", value)) for name, value in rows]
    return Markup(element("h3", title) + element("table", element("tbody", *lines), class_="values"))


@dataclass(frozen=True)
class TableColumn:
    """A column: its head, and whether it has numbers."""

    title: Content
    numeric: bool = False
    sorts: bool = True


def sortable_table(caption: str, columns: Sequence[TableColumn], rows: Sequence[Sequence[Value]]) -> Markup:
    """Rows with a cell for each column; the script TABLE makes the heads sort them."""
    heads = [
        element(
            "th",
            element("button", column.title, type="button") if column.sorts else column.title,
            scope="col",
            class_="number" if column.numeric else None,
        )
        for column in columns
    ]
    lines = [
        element("tr", *(_cell(column, value) for column, value in zip(columns, row, strict=True)))
        for row in rows
    ]
    table = element(
        "table",
        element("caption", caption),
        element("thead", element("tr", *heads)),
        element("tbody", *lines),
    )
    return element("div", table, class_="scroll", tabindex=0, role="region", aria_label=caption)


def _cell(column: TableColumn, value: Value) -> Markup:
    if isinstance(value, str):
        return element("td", value)
    if value is None or not math.isfinite(value):
        return element("td")
    return element("td", number_text(value, 4), class_="number" if column.numeric else None)
