# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliders for how a picture is traced: what is drawn on, a hole or a line, and how smooth."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP
from BalloonWorkbench.core.options.drawing import USUAL_TRACING, TracingOptions
from BalloonWorkbench.core.options.option import options_of
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated

_STEPS = 100
_REST = 150  # ms without a change, then the picture is traced
_WIDTH = 190  # px
_TITLES = {
    "threshold": QT_TRANSLATE_NOOP("BalloonWorkbench", "Threshold"),
    "line_width": QT_TRANSLATE_NOOP("BalloonWorkbench", "Lines up to"),
    "smallest_hole": QT_TRANSLATE_NOOP("BalloonWorkbench", "Holes from"),
    "smoothness": QT_TRANSLATE_NOOP("BalloonWorkbench", "Smoothness"),
}


class TracingSliders(QtWidgets.QWidget):
    """`asked` carries TracingOptions once a slider rests, and whether it has been let go."""

    asked = QtCore.Signal(object, bool)

    def __init__(self):
        super().__init__()
        self.setFixedWidth(_WIDTH)
        self._options = {option.name: option for option in options_of(TracingOptions)}
        self._sliders, self._labels = {}, {}
        self._values = USUAL_TRACING
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.setInterval(_REST)
        self._soon.timeout.connect(self._ask)
        column = QtWidgets.QVBoxLayout(self)
        for name in _TITLES:
            column.addWidget(self._label(name))
            column.addWidget(self._slider(name))
        usual = QtWidgets.QPushButton(translate("As at first"))
        usual.setObjectName("UsualTracing")
        usual.setToolTip(translate("The picture is traced as it is without a choice of yours"))
        usual.clicked.connect(lambda _checked=False: self._reset())
        column.addWidget(usual)
        column.addStretch(1)

    def show_values(self, values: TracingOptions) -> None:
        """Show how the picture is traced; a slider that is held stays."""
        if self._soon.isActive() or any(slider.isSliderDown() for slider in self._sliders.values()):
            return
        self._values = values
        for name, slider in self._sliders.items():
            blocked = slider.blockSignals(True)
            slider.setValue(self._position(name, getattr(values, name)))
            slider.blockSignals(blocked)
            self._show_text(name)

    def _label(self, name: str):
        self._labels[name] = WrappedLabel()
        return self._labels[name]

    def _slider(self, name: str):
        slider = self._sliders[name] = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        slider.setObjectName("".join(map(str.capitalize, name.split("_"))))
        slider.setAccessibleName(translate(_TITLES[name]))
        slider.setRange(0, _STEPS)
        slider.setToolTip(translated(self._options[name].text))
        slider.valueChanged.connect(lambda position, name=name: self._moved(name, position))
        slider.sliderReleased.connect(self._soon.start)
        return slider

    def _position(self, name: str, value: float) -> int:
        """Small values have more of the way than large ones."""
        return round(_STEPS * (value / self._options[name].most) ** 0.5)

    def _moved(self, name: str, position: int) -> None:
        value = round(self._options[name].most * (position / _STEPS) ** 2, 6)
        usual = getattr(USUAL_TRACING, name)
        value = usual if position == self._position(name, usual) else value
        self._values = replace(self._values, **{name: value})
        self._show_text(name)
        self._soon.start()

    def _show_text(self, name: str) -> None:
        value = getattr(self._values, name)
        share = number_text(100.0 * value, 3)
        if name == "smoothness":
            text = translate("{} px").format(number_text(value, 3))
        else:
            text = translate("automatic") if name == "threshold" and not value else f"{share} %"
        self._labels[name].setText(translate("{}: {}").format(translate(_TITLES[name]), text))

    def _reset(self) -> None:
        self._soon.stop()
        self.show_values(USUAL_TRACING)
        self.asked.emit(USUAL_TRACING, True)

    def _ask(self) -> None:
        held = any(slider.isSliderDown() for slider in self._sliders.values())
        self.asked.emit(self._values, not held)
