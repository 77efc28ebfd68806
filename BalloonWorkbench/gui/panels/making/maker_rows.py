# SPDX-License-Identifier: LGPL-2.1-or-later
"""The maker's numbers of a balloon as rows of a panel, counted in a thread: they come when they are known."""

from __future__ import annotations

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import maker
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.app.properties.quantities import cubic_millimetres
from BalloonWorkbench.core.errors import BalloonError, ProgramFault
from BalloonWorkbench.core.making.safety import WELD
from BalloonWorkbench.core.units import area_text, mass_text, money_text, number_text, to_mm
from BalloonWorkbench.gui.long_work.call import Call
from BalloonWorkbench.gui.long_work.latest import LatestWork
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel, fit_heights
from BalloonWorkbench.gui.qt import QtCore, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text, lengths_text, pressure_text, volume_text

_METRE = 1000.0  # mm


class MakerRows:
    """Adds rows to a form: all of them, or those that a panel about something else has room for."""

    def __init__(self, form, short: bool = False):
        self._form, self._short = form, short
        self._count = LatestWork(self._counted)
        self._seam = ""  # what the film's seam is called

    def show(self, parts) -> None:
        """What it takes and whether it floats; nothing while something is not up to date."""
        self._count.leave()
        if not all(status.is_ready(obj) for obj in (parts.balloon, parts.pattern)):
            return
        try:
            count = maker.counting(parts, exact=False)
            self._seam = film.read(parts.balloon).seam
        except BalloonError:
            return
        self._count.ask(Call(count))

    def release(self) -> None:
        """The panel closes."""
        self._count.leave()
        self._form = None

    def _counted(self, worker: Worker) -> None:
        if worker.design is None:
            if isinstance(worker.error, ProgramFault):
                self._form.addRow(value_label(translated(str(worker.error))))
            return
        for name, text in _rows(worker.design, self._short, self._seam):
            self._form.addRow(name, value_label(text))
        fit_heights()


def value_label(text: str):
    """A text that wraps and can be copied."""
    label = WrappedLabel(text)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    return label


def _rows(numbers, short: bool, seam: str) -> list[tuple[str, str]]:
    lines = [
        (translate("Film needed"), _film(numbers), True),
        (translate("Seam length"), length_text(to_mm(numbers.seam_length), 3), False),
        (translate("Weight"), _weight(numbers), False),
        (translate("Safe pressure"), _strength(numbers, seam), True),
        *_weakest(numbers, seam),
        (translate("Gas"), _gas(numbers), False),
        (translate("Will it float?"), translated(numbers.sentence(length=_length)), True),
    ]
    return [(name, text) for name, text, important in lines if important or not short]


def _length(metres: float) -> str:
    return length_text(to_mm(metres), 3)


def _film(numbers) -> str:
    if numbers.roll is None:
        return translated(f"{area_text(numbers.film_area)}; wider than the usual roll")
    width, length = numbers.roll
    return translated(f"{length_text(_METRE * length, 3)} of a roll {length_text(to_mm(width))} wide")


def _weight(numbers) -> str:
    parts = (numbers.weight, numbers.inner, numbers.border, numbers.valve)
    template = (
        translate("{}: film {}, seam and neck {}, valve {}")
        if numbers.valve
        else translate("{}: film {}, seam and neck {}")
    )
    return template.format(*map(mass_text, parts))


def _strength(numbers, seam: str) -> str:
    safe = numbers.safety
    weakest = _weaker(safe, seam)
    if safe.safe_pressure is None:
        return translate("unknown: this film has no strength")
    if safe.safe_pressure < safe.pressure:
        template = translate("less than its {} with a margin of {} ({})")
        return template.format(pressure_text(safe.pressure), number_text(safe.margin), weakest)
    return translated(f"{pressure_text(safe.safe_pressure)} ({weakest}, margin {number_text(safe.margin)})")


def _weaker(safe, seam: str) -> str:
    """What gives way first, by the name that people use for the film's seam."""
    return translated(seam if safe.weakest == WELD else safe.weakest)


def _weakest(numbers, seam: str) -> list[tuple[str, str, bool]]:
    """Where the balloon would give way first; nothing where no strength is known."""
    safe = numbers.safety
    if safe.place is None:
        return []
    x, y, _ = to_mm(safe.place)
    template = translate("{} at ({})").format(_weaker(safe, seam), ", ".join(lengths_text(x, y)))
    if not safe.at_rest:
        template += translate(", estimated: the film did not come to rest")
    return [(translate("Weakest place"), template, False)]


def _gas(numbers) -> str:
    one = numbers.floating[0]
    template = translate("{} of {}").format(
        volume_text(cubic_millimetres(one.gas_needed)), translated(one.gas)
    )
    if one.cost is None:
        return template
    return template + translated(f", about {money_text(one.cost, numbers.currency)}")
