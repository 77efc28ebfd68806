# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs in the export panel: how wide a machine leaves them, and round which pieces. Kept for each machine."""

from __future__ import annotations

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.units import LENGTH_UNITS, number_text, parse_size, to_mm
from BalloonWorkbench.gui.panels.widgets.fields import ReturnKey
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.user_units import length_text, user_unit


class TabRow(QtWidgets.QWidget):
    """Two lengths that may be left empty; `changed` follows them, `refused` has the sentence about another
    text."""

    changed = QtCore.Signal()
    refused = QtCore.Signal(str)

    def __init__(self):
        super().__init__()
        self._machine = ""
        self.width_box, self.below_box = (QtWidgets.QLineEdit() for _ in range(2))
        form = NarrowForm(self)
        form.setContentsMargins(0, 0, 0, 0)
        for box, name, label, empty, tip in (
            (
                self.width_box,
                "TabWidth",
                translate("Tabs"),
                translate("None"),
                translate(
                    "Leave tabs so wide in the cuts, such as 0.4 mm, on straights, two or more on each"
                    " and one in 100 mm, so that pieces stay in the film. It is kept for this machine"
                ),
            ),
            (
                self.below_box,
                "TabsBelow",
                translate("Round pieces up to"),
                translate("Any size"),
                translate("Only pieces that are no larger than this either way get tabs, such as 50 mm"),
            ),
        ):
            box.setObjectName(name)
            box.setMinimumWidth(60)
            box.setPlaceholderText(empty)
            box.setToolTip(tip)
            form.addRow(label, box)
            box.editingFinished.connect(self._take)
            ReturnKey(box, self._take)

    @property
    def texts(self) -> tuple[str | None, str | None]:
        """Both lengths as the engine reads them; None where nothing was given."""
        if self.isHidden():
            return None, None
        width, below = (
            f"{number_text(each, 6)} mm" if each else None for each in preferences.tabs(self._machine)
        )
        return width, below if width else None

    def show_for(self, machine: str) -> None:
        """What is kept for a machine."""
        self._machine = machine
        for box, length in zip((self.width_box, self.below_box), preferences.tabs(machine)):
            box.setText(length_text(length) if length else "")
            box.setModified(False)

    def _take(self) -> None:
        """Keep what was typed."""
        boxes = self.width_box, self.below_box
        if not any(box.isModified() for box in boxes):
            return
        unit = user_unit("mm", 1.0)[1]
        unit = unit if unit in LENGTH_UNITS else "mm"
        for box in boxes:
            box.setModified(False)
        try:
            texts = [box.text().replace(",", ".").strip() for box in boxes]
            lengths = [to_mm(parse_size(text, unit)[0]) if text else 0.0 for text in texts]
        except BalloonError as error:
            self.refused.emit(str(error))
            return
        preferences.put_tabs(self._machine, *lengths)
        self.changed.emit()
