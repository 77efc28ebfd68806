# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the balloon of a body does it, as rows of a panel: what is known at once, and what a thread finds."""

from __future__ import annotations

from BalloonWorkbench.app.engine import bag_result
from BalloonWorkbench.app.properties.quantities import cubic_metres
from BalloonWorkbench.core.checkpoint import stoppable
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.making.welding import welding_time
from BalloonWorkbench.core.results.body_figures import body_figures
from BalloonWorkbench.core.units import from_mm, percent_text, to_mm, volume_text
from BalloonWorkbench.gui.long_work.latest import LatestWork
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.making.maker_rows import value_label
from BalloonWorkbench.gui.panels.widgets.narrow import fit_heights
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text, lengths_text


class BodyRows:
    """Adds rows to a form; those that take a moment come when they are known."""

    def __init__(self, form):
        self._form = form
        self._figures = LatestWork(self._looked)

    def show(self, balloon) -> None:
        """The figures of a balloon of a body."""
        self.leave()
        try:
            design, film = bag_result.stored(balloon)
        except BalloonError:
            return
        self._figures.ask(_Looking(design, film))

    def release(self) -> None:
        """The panel closes."""
        self.leave()
        self._form = None

    def leave(self) -> None:
        """Nobody waits for the last figures any more."""
        self._figures.leave()

    def _looked(self, worker: Worker) -> None:
        if worker.design is None:
            return
        for name, text in _slow_rows(worker.design):
            self._form.addRow(name, value_label(text))
        fit_heights()


class _Looking:
    """What a worker is asked."""

    def __init__(self, design, film):
        self._design, self._film = design, film

    def solve(self, progress):
        with stoppable(progress):
            return body_figures(self._design, self._film)


def quick_rows(balloon) -> list[tuple[str, str]]:
    """Names and values of what the objects of a balloon of a body know."""
    target = balloon.Outline
    errors = [each.Value for each in (balloon.ResidualMean, balloon.ResidualP95, balloon.ResidualMax)]
    diagonal = target.BodySize.Length
    mean, most, largest = (
        translate("{} ({})").format(text, percent_text(error / diagonal))
        for text, error in zip(lengths_text(*errors), errors)
    )
    seams = translate("{} panels, {} seams of {}").format(
        balloon.PanelCount, balloon.SeamCount, length_text(target.SeamLength.Value, 3)
    )
    welding = welding_time(from_mm(target.SeamLength.Value), balloon.SeamCount)
    return [
        (
            translate("Off the body"),
            translate("in the mean {}, 95 % below {}, at most {}").format(mean, most, largest),
        ),
        (translate("Body"), volume_text(cubic_metres(target.BodyVolume))),
        (translate("Panels"), seams),
        (translate("Welding"), translated(welding.sentence())),
    ]


def _slow_rows(figures) -> list[tuple[str, str]]:
    flat, (inmost, outmost) = (
        figures.flattening,
        lengths_text(*(abs(to_mm(away)) for away in (figures.inmost, figures.outmost))),
    )
    strain = translate("{} in the mean, at most {}").format(
        percent_text(flat.mean), percent_text(flat.largest)
    )
    inside = translate("{} inside").format(inmost) if figures.inmost < 0.0 else inmost
    outside = translate("{} outside").format(outmost) if figures.outmost > 0.0 else outmost
    return [
        (translate("Laid flat"), translate("strain {}").format(strain)),
        (
            translate("Wrinkles"),
            translate("hide {} of the film's width").format(percent_text(figures.hidden)),
        ),
        (translate("It lies"), translate("{} to {}").format(inside, outside)),
    ]
