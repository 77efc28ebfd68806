# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel that tells: progress while it works, measures afterwards, messages."""

from __future__ import annotations

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app import bag, gored_body, target
from BalloonWorkbench.app.balloon import VOLUME
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.kinds import is_bag, is_gored_body, is_target
from BalloonWorkbench.app.properties.quantities import cubic_millimetres, pascals
from BalloonWorkbench.core.units import from_grams, mass_text, percent_text, to_mm
from BalloonWorkbench.gui.accessible import sign_button
from BalloonWorkbench.gui.panels.balloon.body_rows import BodyRows, quick_rows
from BalloonWorkbench.gui.panels.making.maker_rows import MakerRows, value_label
from BalloonWorkbench.gui.panels.widgets.fields import Fields
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm, WrappedLabel
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import (
    NOTHING,
    length_text,
    lengths_text,
    pressure_text,
    size_text,
    volume_text,
)
from BalloonWorkbench.gui.wrapping import PushButton

_ICON = 16
#: Commands for a finished balloon, with their icons.
_NEXT = (
    ("ColourMap", "colour_map"),
    ("Animate", "animate"),
    ("Advice", "advice"),
    ("Nest", "nest"),
    ("ExportPattern", "export_pattern"),
)


class ResultBox(QtWidgets.QWidget):
    """A button that starts the work (`wanted`), one that stops it (`stopped`), and what comes of it.

    `asked_for` carries the name of a command that looks closer at the balloon.
    """

    requested = QtCore.Signal()
    stopped = QtCore.Signal()
    live_changed = QtCore.Signal()
    asked_for = QtCore.Signal(str)

    def __init__(self, balloon):
        super().__init__()
        self.setObjectName("Result")
        self.setWindowTitle(translate("Result"))
        self.setWindowIcon(drawn_icon("pattern"))
        self._apply = PushButton(translate("Apply"))
        self._apply.setObjectName("Apply")
        self._apply.setToolTip(translate("Inflate with these values and show the balloon"))
        self._apply.clicked.connect(lambda _checked=False: self.requested.emit())
        self._fields = Fields(balloon, self)
        self._fields.changed.connect(lambda _name: self.live_changed.emit())
        self._bar = QtWidgets.QProgressBar()
        self._bar.setObjectName("Progress")
        self._bar.setRange(0, 1000)
        self._step = QtWidgets.QLabel()
        self._stop = PushButton(translate("Stop"))
        self._stop.setObjectName("Stop")
        self._stop.setToolTip(translate("Stop and keep the last result"))
        self._stop.clicked.connect(lambda _checked=False: self.stopped.emit())
        self._working = QtWidgets.QWidget()
        working = QtWidgets.QGridLayout(self._working)
        working.setContentsMargins(0, 0, 0, 0)
        working.addWidget(self._bar, 0, 0)
        working.addWidget(self._stop, 0, 1)
        working.addWidget(self._step, 1, 0, 1, 2)
        self._sign = QtWidgets.QLabel()
        self._sign.setAlignment(QtCore.Qt.AlignTop)
        self._message = WrappedLabel()
        self._message.setObjectName("Message")
        self._message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        message_row = QtWidgets.QHBoxLayout()
        message_row.addWidget(self._sign)
        message_row.addWidget(self._message, 1)
        self._measures = NarrowForm()
        self._maker, self._body = MakerRows(self._measures, short=True), BodyRows(self._measures)
        column = QtWidgets.QVBoxLayout(self)
        start = QtWidgets.QHBoxLayout()
        start.addWidget(self._apply, 1)
        start.addWidget(self._fields.check("Live", translate("Live")))
        column.addLayout(start)
        column.addWidget(self._working)
        column.addLayout(message_row)
        column.addLayout(self._measures)
        column.addLayout(self._next_steps())
        self.finish()

    def _next_steps(self):
        """Buttons for what may be done with a finished balloon."""
        row = QtWidgets.QHBoxLayout()
        row.addStretch(1)
        self._steps = []
        for command, name in _NEXT:
            button = sign_button("", translate("OK, then {}").format(_menu_text(command)))
            button.setObjectName(f"Go{command}")
            button.setIcon(drawn_icon(name))
            button.clicked.connect(lambda _checked=False, chosen=command: self.asked_for.emit(chosen))
            row.addWidget(button)
            self._steps.append(button)
        return row

    def release(self) -> None:
        """The panel closes."""
        self._maker.release()
        self._body.release()
        self._fields.release()

    def start(self) -> None:
        """The work begins."""
        self._bar.setValue(0)
        self._step.setText("")
        self._apply.hide()
        self._working.show()
        self.show_message("")

    def show_progress(self, fraction: float, text: str) -> None:
        self._bar.setValue(round(1000 * fraction))
        self._step.setText(translated(text))

    def finish(self) -> None:
        """The work is over."""
        self._working.hide()
        self._apply.show()

    def show_message(self, text: str, warning: bool = False) -> None:
        """One or two sentences; a warning has a sign beside it."""
        style = QtWidgets.QStyle
        kind = style.SP_MessageBoxWarning if warning else style.SP_MessageBoxInformation
        self._sign.setPixmap(self.style().standardIcon(kind).pixmap(_ICON, _ICON))
        self._sign.setVisible(bool(text))
        self._message.setText(translated(text))
        self._message.setVisible(bool(text))

    def message(self) -> str:
        """The text that is shown."""
        return self._message.text()

    def show_draft(self, inflation) -> None:
        """About what the balloon will measure; an Inflation of the core."""
        self._measures.clear()
        width, height, half = to_mm(np.ptp(inflation.positions, axis=0)).tolist()
        for name, text in (
            (translate("Size"), size_text(width, height)),
            (translate("Thickness"), length_text(2.0 * half)),
            (translate("Volume"), volume_text(cubic_millimetres(inflation.volume))),
        ):
            self._measures.addRow(name, value_label(translate("about {}").format(text)))

    def show_result(self, parts) -> None:
        """The measures of the balloon, and what its objects have to say."""
        self._measures.clear()
        self._body.leave()
        outline, balloon, pattern = parts
        self._fields.refresh()
        for button in self._steps:
            button.setVisible(bool(balloon.SolvedFor))
        for obj in parts:
            if obj.Status and not status.is_ready(obj):
                self.show_message(
                    status.problem(obj), warning=bool(status.problem(outline)) and has_source(outline)
                )
                break
        else:
            remarks = [*balloon.Warnings, *pattern.Warnings]
            if balloon.Status != status.READY:
                remarks.insert(0, balloon.Status)
            self.show_message("\n".join(remarks), warning=True)
        if not balloon.SolvedFor:
            return
        for name, text in measures(balloon, pattern):
            self._measures.addRow(name, value_label(text))
        self._maker.show(parts)
        if is_target(outline) and status.is_ready(balloon):
            self._body.show(balloon)


def _menu_text(command: str) -> str:
    return Gui.Command.get(f"BalloonWorkbench_{command}").getInfo()["menuText"].replace("&", "")


def has_source(outline) -> bool:
    """What the balloon is to be is drawn, chosen or in a file."""
    if is_gored_body(outline):
        return gored_body.has_profile(outline)
    if is_bag(outline):
        return bag.has_panels(outline)
    if is_target(outline):
        return target.has_body(outline)
    return bool(outline.Source or outline.Drawing)


def file_of(outline) -> str:
    """The file that it comes from; empty where it is none."""
    names = (name for name in ("Drawing", "ProfileFile", "PanelFile", "BodyFile") if hasattr(outline, name))
    followed = getattr(outline, "Source", None) or getattr(outline, "Solid", None)
    return "" if followed else getattr(outline, next(names))


def measures(balloon, pattern) -> list[tuple[str, str]]:
    """Names and values of what a user wants to know about a balloon."""
    mean, largest = lengths_text(balloon.ResidualMean.Value, balloon.ResidualMax.Value)
    cut = size_text(pattern.PatternWidth.Value, pattern.PatternHeight.Value)
    rows = [
        (translate("Size"), size_text(balloon.InflatedWidth.Value, balloon.InflatedHeight.Value)),
        (translate("Thickness"), length_text(balloon.InflatedThickness.Value)),
        (translate("Volume"), volume_text(balloon.Volume.Value)),
        *_off(balloon, translate("{}, at most {}").format(mean, largest)),
        *_creased(balloon),
        (translate("Pattern"), cut if pattern.Roles else NOTHING),
        (translate("Weight"), _weight(balloon) if balloon.Weight else NOTHING),
        (translate("Film"), _state(balloon)),
        (translate("Solver"), balloon.ActiveBackend),
    ]
    if balloon.Load == VOLUME:
        rows.append((translate("Pressure"), pressure_text(pascals(balloon.ActivePressure))))
    return rows


def _off(balloon, text: str) -> list[tuple[str, str]]:
    """How far it is off what was wanted, and its seams off the centres of its gores."""
    if is_bag(balloon.Outline):
        return []
    if is_target(balloon.Outline):
        return quick_rows(balloon)
    if not is_gored_body(balloon.Outline):
        return [(translate("Off the drawing"), text)]
    apart = length_text(balloon.Apart.Value)
    return [
        (translate("Off the profile"), text),
        (translate("Gores"), str(balloon.PanelCount)),
        (translate("Seams and centres apart"), apart),
    ]


def _creased(balloon) -> list[tuple[str, str]]:
    """How far it is off the drawing if the weld creases, where that was simulated."""
    if not balloon.CreasedMax:
        return []
    mean, largest = lengths_text(balloon.CreasedMean.Value, balloon.CreasedMax.Value)
    return [(translate("If the weld creases"), translate("{}, at most {}").format(mean, largest))]


def _weight(balloon) -> str:
    weight, gas = mass_text(from_grams(balloon.Weight)), translated(balloon.Gas.lower())
    if balloon.Floats:
        template = translate("{}, carries {} with {}")
        return template.format(weight, mass_text(from_grams(balloon.Lift)), gas)
    if not balloon.FloatsFrom:
        return translate("{}, never floats with {}").format(weight, gas)
    template = translate("{}, floats from {} width on with {}")
    return template.format(weight, length_text(balloon.FloatsFrom.Value, 3), gas)


def _state(balloon) -> str:
    template = translate("{} of it wrinkles, {} is loose")
    return template.format(percent_text(balloon.WrinkledShare), percent_text(balloon.SlackShare))
