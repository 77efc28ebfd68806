# SPDX-License-Identifier: LGPL-2.1-or-later
"""From few panels to true to shape: the computed curve, a slider along it, the accuracy that is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from BalloonWorkbench.app import balloon as balloon_object
from BalloonWorkbench.app import target as target_object
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.making.welding import welding_time
from BalloonWorkbench.core.target_design.panel_curve import COUNTS, CurvePoint, curve_point, envelope
from BalloonWorkbench.core.types import part_of
from BalloonWorkbench.core.units import number_text, percent_text, to_mm
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.bodies.curve_plot import CurvePlot
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text
from BalloonWorkbench.gui.wrapping import PushButton

_MOST = 20.0  # %
_PERCENT = 0.01


@dataclass(frozen=True)
class _Curve:
    """What a worker is asked: the points of the curve of a body, one after the other."""

    target: Any
    film: Any
    pressure: float

    def known(self) -> list[CurvePoint]:
        """Those that are remembered."""
        return [self._point(count) for count in COUNTS if curve_point.knows(*self._asked(count))]

    def solve(self, progress):
        """All of them, in the worker's thread."""
        shares = [(number / len(COUNTS), (number + 1) / len(COUNTS)) for number in range(len(COUNTS))]
        return [
            curve_point(*self._asked(count), progress=part_of(progress, *share))
            for count, share in zip(COUNTS, shares)
        ]

    def _asked(self, count: int):
        return self.target, count, self.film, self.pressure

    def _point(self, count: int) -> CurvePoint:
        return curve_point(*self._asked(count))


class PanelCurveBox(QtWidgets.QWidget):
    """Chooses the number of panels of a Target object; `edited` is called when it has."""

    def __init__(self, target, balloon, edited):
        super().__init__()
        self._obj, self._balloon, self._edited = target, balloon, edited
        self._worker: Worker | None = None
        self._points: tuple[CurvePoint, ...] = ()
        self._body: tuple[Any, Any] | None = None  # as it was read, once the curve was asked for
        self._waiting = False  # for an accuracy that was asked for
        self.look = PushButton(translate("Few panels or true to shape?"))
        self.plot, self.slider = CurvePlot(), QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.chosen_text, self.within = WrappedLabel(), QtWidgets.QDoubleSpinBox()
        self._soon = QtCore.QTimer(self)
        self._soon.setInterval(200)
        self._build()

    def _build(self) -> None:
        self.look.setObjectName("PanelCurve")
        self.look.setToolTip(translate("Work out how near balloons of 6 to 60 panels come to the body"))
        self.slider.setObjectName("PanelSlider")
        self.slider.setAccessibleName(translate("Number of panels"))
        self.slider.setPageStep(1)
        self.slider.setTickPosition(QtWidgets.QSlider.TicksBelow)
        self.chosen_text.setObjectName("PanelCurveTold")
        self.within.setObjectName("MeanDistance")
        self.within.setAccessibleName(translate("Mean distance from the body"))
        self.within.setToolTip(
            translate("How far the balloon may be from the body on average, of the body's diagonal")
        )
        self.within.setPrefix(translate("at most "))
        self.within.setSuffix(" %")
        self.within.setDecimals(2)
        self.within.setSingleStep(0.05)
        self.within.setRange(0.0, _MOST)
        self.within.setSpecialValueText(translate("any accuracy"))
        self.within.setKeyboardTracking(False)
        ends = QtWidgets.QHBoxLayout()
        for text in (translate("few panels"), translate("true to shape")):
            ends.addWidget(WrappedLabel(text))
        ends.itemAt(1).widget().setAlignment(QtCore.Qt.AlignRight)
        self._curve = QtWidgets.QWidget()
        inside = QtWidgets.QVBoxLayout(self._curve)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.addWidget(self.plot)
        inside.addWidget(self.slider)
        inside.addLayout(ends)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.look, self._curve, self.chosen_text, self.within):
            column.addWidget(widget)
        self.look.clicked.connect(self.start_or_stop)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderReleased.connect(self._take)
        self.within.valueChanged.connect(self._ask)
        self._soon.timeout.connect(self._show_known)

    def refresh(self) -> None:
        """Show what is known of the body as it is."""
        self.setVisible(bool(self._obj.TargetPoints))
        self._curve.setVisible(bool(self._points))
        if self._obj.TargetPoints and self._worker is None and self._body is not None:
            self._show_known()

    def release(self) -> None:
        """The panel closes."""
        self._soon.stop()
        if self._worker is not None:
            self._worker.abandon()
            self._worker = None

    def start_or_stop(self, _checked: bool = False) -> None:
        """Work the curve out beside the window, or stop that: what is known stays."""
        if self._worker is not None:
            self._worker.stop()
            return
        asked = self._curve_of()
        if asked is None:
            return
        worker = self._worker = Worker(asked, self, translate("Few panels or true to shape"))
        worker.ended.connect(self._ended)
        worker.start()
        self._soon.start()
        self.look.setText(translate("Stop"))

    def _curve_of(self) -> _Curve | None:
        """The curve of the body, its film and its pressure as they are."""
        try:
            settings = balloon_object.request(self._balloon).settings
            if self._body is None or self._body[0] != self._source():
                self._body = self._source(), target_object.body(self._obj)
        except BalloonError as error:
            self.chosen_text.setText(translated(str(error)))
            return None
        return _Curve(self._body[1], settings.film, settings.pressure)

    def _source(self) -> tuple[Any, ...]:
        """What the body is read from: reading a large file takes a while."""
        obj = self._obj
        shape = getattr(obj.Solid, "Shape", None)
        version = shape.hashCode() if shape is not None else getattr(obj.Solid, "Mesh", None)
        own = obj.BodyFile, obj.Width.Value, obj.Height.Value
        return obj.Solid, version if shape is not None or version is None else version.Area, own

    def _ended(self) -> None:
        worker, self._worker = self._worker, None
        self._soon.stop()
        self.look.setText(translate("Few panels or true to shape?"))
        self._show_known()
        if worker.error is not None and worker.fault():
            self.chosen_text.setText(translated(str(worker.error)))
        elif self._waiting and worker.design is not None:
            self._choose_for_accuracy()
        worker.deleteLater()

    def _show_known(self) -> None:
        asked = self._curve_of() if self._worker is None else self._worker.request
        self._points = () if asked is None else envelope(asked.known())
        self._curve.setVisible(bool(self._points))
        blocked = self.slider.blockSignals(True)
        self.slider.setRange(0, max(len(self._points) - 1, 0))
        counts = [point.panels for point in self._points]
        if self._obj.PanelCount in counts:
            self.slider.setValue(counts.index(self._obj.PanelCount))
        self.slider.blockSignals(blocked)
        self._show_chosen(self._obj.PanelCount)

    def _show_chosen(self, panels: int) -> None:
        self.plot.show_points(
            [(point.panels, point.error) for point in self._points], panels, _PERCENT * self.within.value()
        )
        point = next((each for each in self._points if each.panels == panels), None)
        self.chosen_text.setVisible(point is not None)
        if point is not None:
            hours = welding_time(point.seam_length, point.seams).hours
            self.chosen_text.setText(
                translate("{} panels: about {} off, {} of seams, {} h of welding").format(
                    point.panels,
                    percent_text(point.error),
                    length_text(to_mm(point.seam_length), 3),
                    number_text(hours, 2),
                )
            )

    def _slid(self, place: int) -> None:
        self._show_chosen(self._points[place].panels)
        if not self.slider.isSliderDown():
            self._take()

    def _take(self) -> None:
        self._set(self._points[self.slider.value()].panels)

    def _set(self, panels: int) -> None:
        if self._obj.Panels != panels:
            self._obj.Panels = panels
            self._edited()

    def _ask(self, percent: float) -> None:
        """So near: the fewest panels of the curve that come there, when that is known."""
        self._waiting = percent > 0.0
        if self._waiting and len(self._points) and self._worker is None and self._all_known():
            self._choose_for_accuracy()
        elif self._waiting and self._worker is None:
            self.start_or_stop()

    def _all_known(self) -> bool:
        asked = self._curve_of()
        return asked is not None and len(asked.known()) == len(COUNTS)

    def _choose_for_accuracy(self) -> None:
        self._waiting = False
        asked = _PERCENT * self.within.value()
        near = [point for point in self._points if point.error <= asked]
        if near:
            self._set(min(point.panels for point in near))
            self._show_known()
        elif self._points:
            best = min(self._points, key=lambda point: point.error)
            self._set(best.panels)
            self._show_known()
            self.chosen_text.setText(
                translate("No number of panels up to {} comes so near. {} panels: about {} off").format(
                    max(COUNTS), best.panels, percent_text(best.error)
                )
            )
