# SPDX-License-Identifier: LGPL-2.1-or-later
"""The maker's numbers of a balloon as rows of a panel, counted in a thread: they come when they are known."""

from __future__ import annotations

from functools import partial

from BalloonWorkbench.app import maker, status
from BalloonWorkbench.app.quantities import cubic_millimetres
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.units import to_grams, to_mm
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.sentences import tell
from BalloonWorkbench.gui.user_units import length_text, pressure_text, volume_text
from BalloonWorkbench.gui.worker import Worker

_METRE = 1000.0  # mm
_counting: list[Worker] = []  # the window keeps them until they are done, whatever becomes of the panel


class MakerRows:
    """Adds rows to a form: all of them, or those that a panel about something else has room for."""

    def __init__(self, form, short: bool = False):
        self._form, self._short = form, short
        self._wanted: Worker | None = None

    def show(self, parts) -> None:
        """What it takes and whether it floats; nothing while something is not up to date."""
        self._wanted = None
        if not all(status.is_ready(obj) for obj in (parts.balloon, parts.pattern)):
            return
        try:
            count = maker.counting(parts, exact=False)
        except BalloonError:
            return
        worker = self._wanted = Worker(_Counting(count))
        _counting.append(worker)
        worker.finished.connect(partial(self._counted, worker))
        worker.start()

    def release(self) -> None:
        """The panel closes."""
        self._wanted = self._form = None

    def _counted(self, worker: Worker) -> None:
        _counting.remove(worker)
        worker.deleteLater()
        fault = worker.fault()
        if worker is not self._wanted:
            return
        if worker.design is None:
            if fault:
                self._form.addRow(value_label(tell(fault)))
            return
        for name, text in _rows(worker.design, self._short):
            self._form.addRow(name, value_label(text))


class _Counting:
    """What a worker is asked."""

    def __init__(self, count):
        self._count = count

    def solve(self, progress):
        return self._count()


def value_label(text: str):
    """A text that wraps and can be copied."""
    label = QtWidgets.QLabel(text)
    label.setWordWrap(True)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return label


def _rows(numbers, short: bool) -> list[tuple[str, str]]:
    found = [
        (translate("Film needed"), _film(numbers), True),
        (translate("Weld length"), length_text(to_mm(numbers.seam_length), 3), False),
        (translate("Weight"), _weight(numbers), False),
        (translate("Safe pressure"), _strength(numbers), True),
        (translate("Gas"), _gas(numbers), False),
        (translate("Will it float?"), tell(numbers.sentence()), True),
    ]
    return [(name, text) for name, text, important in found if important or not short]


def _film(numbers) -> str:
    if numbers.roll is None:
        return translate("{:.3g} m², wider than the usual roll").format(numbers.film_area)
    width, length = numbers.roll
    return translate("{} of a roll of {}").format(length_text(_METRE * length, 3), length_text(to_mm(width)))


def _weight(numbers) -> str:
    told = translate("{:.3g} g: film {:.3g}, weld and neck {:.2g}, valve {:.2g}")
    parts = (numbers.weight, numbers.inner, numbers.border, numbers.valve)
    return told.format(*map(to_grams, parts))


def _strength(numbers) -> str:
    safe = numbers.safety
    if safe.safe_pressure is None:
        return translate("unknown: this film has no strength")
    if safe.safe_pressure < safe.pressure:
        told = translate("less than its {} with a margin of {:g} ({})")
        return told.format(pressure_text(safe.pressure), safe.margin, tell(safe.weakest))
    told = translate("{}, margin {:g} ({})")
    return told.format(pressure_text(safe.safe_pressure), safe.margin, tell(safe.weakest))


def _gas(numbers) -> str:
    one = numbers.floating[0]
    told = translate("{} of {}").format(volume_text(cubic_millimetres(one.gas_needed)), tell(one.gas))
    if one.cost is None:
        return told
    return told + translate(", about {:.2f} {}").format(one.cost, numbers.currency)
