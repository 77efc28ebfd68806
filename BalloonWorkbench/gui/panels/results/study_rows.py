# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a study in its narrow panel: what is varied and what came of it, a row a balloon."""

from __future__ import annotations

import re
from collections.abc import Sequence

from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate

_LOWEST = 150  # px
_DIGITS = 4  # of a number
_LONG = re.compile(r"\d+\.\d{4,}")  # a number with more


class StudyRows(QtWidgets.QTableWidget):
    """Shows rows; one is chosen as a whole."""

    def __init__(self):
        super().__init__()
        self.setObjectName("StudyRows")
        self.setMinimumHeight(_LOWEST)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self.horizontalHeader().setStretchLastSection(True)
        self.horizontalHeader().setTextElideMode(QtCore.Qt.ElideRight)
        self.setToolTip(translate("Double-click a row to see its balloon"))

    def show_rows(
        self,
        inputs: Sequence[str],
        results: Sequence[str],
        rows: dict[int, Sequence],
        failures: dict[int, str],
    ) -> None:
        """Show rows by their numbers, with the values of inputs and results, whose headings are given."""
        self.setColumnCount(len(inputs) + len(results))
        self.setHorizontalHeaderLabels([*inputs, *results])
        for column, heading in enumerate((*inputs, *results)):
            self.horizontalHeaderItem(column).setToolTip(heading)
        self.setRowCount(len(rows))
        self.setVerticalHeaderLabels(list(map(str, rows)))
        for place, (number, values) in enumerate(rows.items()):
            for column, value in enumerate(values):
                item = QtWidgets.QTableWidgetItem(_text(value))
                item.setToolTip(failures.get(number, ""))
                self.setItem(place, column, item)
        self._hide_equal(len(inputs))

    def _hide_equal(self, inputs: int) -> None:
        """Inputs that are the same in all rows take no room, unless all are."""
        texts = [
            {self.item(row, column).text() for row in range(self.rowCount())} for column in range(inputs)
        ]
        vary = [len(each) > 1 for each in texts]
        for column, varies in enumerate(vary):
            self.setColumnHidden(column, any(vary) and not varies)


def _text(value) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return translate("yes") if value else translate("no")
    if isinstance(value, (int, float)):
        return number_text(value, _DIGITS)
    return _LONG.sub(lambda digits: number_text(float(digits[0]), _DIGITS), str(value))
