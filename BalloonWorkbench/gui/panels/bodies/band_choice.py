# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two panels or a side band: one choice, with a picture and the thickness of both."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from BalloonWorkbench.app.balloon import request
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.properties.property_table import properties_of
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.options.body import BandOptions
from BalloonWorkbench.core.units import from_mm, to_mm
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.bodies.band_sketch import BandComparison, Sketched, picture_of, usual_band
from BalloonWorkbench.gui.panels.widgets.fields import PropertyForm
from BalloonWorkbench.gui.panels.widgets.narrow import fit_heights
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate
from BalloonWorkbench.gui.view3d.film_display import look_of
from BalloonWorkbench.gui.window.user_units import length_text
from BalloonWorkbench.gui.wrapping import PictureButton

_WIDTH, _HEIGHT = 76, 64  # px, of a picture
_DIGITS = 2  # of the band that is put in when one is chosen
_CHOSEN = "QToolButton:checked { border: 2px solid #1b8ac9; border-radius: 4px; }"


class BandChoice(QtCore.QObject):
    """The rows of a form that belong to a balloon with an outline; `changed` follows the choice."""

    changed = QtCore.Signal()

    def __init__(self, form: PropertyForm, balloon):
        super().__init__(form.parent())
        self._obj, self._form = balloon, form
        self._worker: Worker | None = None
        self._sketched: BandComparison | None = None  # what the pictures show, or will
        self.plain = _button("TwoPanels", translate("Two panels"))
        self.banded = _button("SideBand", translate("Side band"))
        group = QtWidgets.QButtonGroup(self)
        self._row = QtWidgets.QWidget()
        row = QtWidgets.QHBoxLayout(self._row)
        row.setContentsMargins(0, 0, 0, 0)
        for button in (self.plain, self.banded):
            group.addButton(button)
            row.addWidget(button)
        form.addRow(self._row)
        for item in properties_of(BandOptions):
            form.add(item)
        self.plain.clicked.connect(self._take_plain)
        self.banded.clicked.connect(self._take_band)

    def refresh(self) -> None:
        """Show what is chosen, and both pictures where there is a drawing."""
        balloon = self._obj
        offered = "Hidden" not in balloon.getEditorMode("Band")
        self._row.setVisible(offered)
        banded = bool(balloon.Band or balloon.BodyThickness)
        (self.banded if banded else self.plain).setChecked(True)
        for item in properties_of(BandOptions):
            self._form.show_row(item.name, banded and offered)
        fit_heights()
        if offered and balloon.Outline is not None and status.is_ready(balloon.Outline):
            self._sketch()

    def release(self) -> None:
        """The panel closes."""
        self._stop()

    def _take_plain(self, _checked: bool = False) -> None:
        if self._obj.Band or self._obj.BodyThickness:
            self._obj.Band = self._obj.BodyThickness = 0.0
            self.changed.emit()

    def _take_band(self, _checked: bool = False) -> None:
        asked = self._asked()
        if not (self._obj.Band or self._obj.BodyThickness) and asked is not None:
            width = to_mm(asked.band)
            self._obj.Band = round(width, _DIGITS - 1 - math.floor(math.log10(width)))
            self.changed.emit()

    def _asked(self) -> BandComparison | None:
        """What the pictures are to show; None while the values make no sense."""
        from BalloonWorkbench.app.shapes import part_shapes

        try:
            settings = request(self._obj).settings
        except BalloonError:
            return None
        outline = part_shapes.stored(self._obj.Outline, "Loop")
        band = from_mm(self._obj.Band.Value) or usual_band(outline)
        return BandComparison(outline, settings.film, settings.pressure, band, settings.correct)

    def _sketch(self) -> None:
        asked = self._asked()
        if asked is None or asked.outline.welds or _is_same(self._sketched, asked):
            return
        self._stop()
        self._sketched = asked
        self._worker = Worker(asked, self)
        self._worker.ended.connect(self._show)
        self._worker.start()

    def _stop(self) -> None:
        if self._worker is not None:
            self._worker.abandon()
            self._worker = None

    def _show(self) -> None:
        worker, self._worker = self._worker, None
        if worker is None or worker.design is None:
            return  # the balloon itself will say why there is none
        colour = QtGui.QColor(look_of(self._obj).colour)
        for button, sketched, title in zip(
            (self.plain, self.banded), worker.design, (translate("Two panels"), translate("Side band"))
        ):
            _fill(button, sketched, title, colour)
        self._row.setMinimumHeight(self._row.sizeHint().height())  # Qt 6's form keeps the least it had before
        fit_heights()


def _button(name: str, title: str):
    button = PictureButton(title)
    button.setObjectName(name)
    button.setCheckable(True)
    button.setStyleSheet(_CHOSEN)
    button.setIconSize(QtCore.QSize(_WIDTH, _HEIGHT))
    return button


def _fill(button, sketched: Sketched, title: str, colour) -> None:
    button.setIcon(QtGui.QIcon(picture_of(sketched, _WIDTH, _HEIGHT, colour)))
    button.setText(f"{title}\n{translate('about {}').format(length_text(to_mm(sketched.thickness), 2))}")
    button.setToolTip(translate("About {} thick").format(length_text(to_mm(sketched.thickness), 2)))


def _is_same(one: BandComparison | None, other: BandComparison) -> bool:
    if one is None or replace(one, outline=other.outline) != other:
        return False
    loops, others = one.outline.loops, other.outline.loops
    return len(loops) == len(others) and all(map(np.array_equal, loops, others))
