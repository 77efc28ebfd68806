# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a study: its rows and what is known of them, a plot; working out, stopping, going on."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from BalloonWorkbench.app.studies import study as studies
from BalloonWorkbench.app.studies import study_table
from BalloonWorkbench.app.studies.variant import MESH
from BalloonWorkbench.app.studies.varied import UNITS
from BalloonWorkbench.core.errors import BalloonError, Cancelled
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.run import run_study
from BalloonWorkbench.core.studies.table import FAILURE
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels import show
from BalloonWorkbench.gui.panels.results.study_plot import StudyPlot
from BalloonWorkbench.gui.panels.results.study_rows import StudyRows
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.panels.widgets.object_panel import ObjectPanel
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.view3d.fit_view import fit_all
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import undo_step
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapping import PushButton

_MOST_STEPS = 1000  # rows that are made of one


def show_panel(obj) -> None:
    """Open the panel on a study, in one undo step."""
    with undo_step(obj.Document, translate("Edit study")):
        show(StudyPanel(obj))


@dataclass(frozen=True)
class _StudyRun:
    """What a worker is asked: to work out the rows of a study that are not there yet."""

    study: Any
    folder: Path
    runner: Any

    def solve(self, progress):
        """In the worker's thread; the balloons themselves are made by other processes."""
        done = [0.0, ""]

        def observe(count, of, _last):
            done[:] = count / max(of, 1), f"balloon {count} of {of}"
            progress(*done)

        run_study(
            self.study,
            self.folder,
            replace(self.runner, is_stopped=lambda: not progress(*done)),
            observe=observe,
        )
        return (True,)


class StudyPanel(ObjectPanel):
    """Edits a study, and shows its balloons."""

    def __init__(self, obj):
        super().__init__(obj, "StudyPanel", translate("Study"), "study")
        self.worker: Worker | None = None
        self._progress = ""
        self.table: study_table.Table | None = None
        self.jobs: dict[int, Any] = {}
        self.row_results: dict[int, dict] = {}
        self.column, self.across, self.up = (QtWidgets.QComboBox() for _ in range(3))
        self.first, self.last = QtWidgets.QLineEdit(), QtWidgets.QLineEdit()
        self.steps, self.make_rows = QtWidgets.QSpinBox(), PushButton(translate("Make rows"))
        self.rows, self.plot = StudyRows(), StudyPlot()
        self.start = PushButton(translate("Work out"))
        self.take = PushButton(translate("Take this row"))
        self.message = WrappedLabel()
        self._build()
        self.read()

    def _build(self) -> None:
        for name, widget in {
            "StudyColumn": self.column,
            "StudyFirst": self.first,
            "StudyLast": self.last,
            "StudySteps": self.steps,
            "StudyMakeRows": self.make_rows,
            "StudyAcross": self.across,
            "StudyUp": self.up,
            "StudyStart": self.start,
            "StudyTake": self.take,
            "StudyMessage": self.message,
        }.items():
            widget.setObjectName(name)
        self.rows.setAccessibleName(translate("Rows"))
        self.steps.setRange(1, _MOST_STEPS)
        self.steps.setValue(5)
        self.make_rows.setToolTip(translate("Each row of the table once with each of these values"))
        self.take.setToolTip(translate("Give the document the values of the chosen row"))
        form = QtWidgets.QFormLayout(self.form)
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        self.first.setToolTip(translate("From this value, with its unit"))
        self.last.setToolTip(translate("To this value, with its unit"))
        self.steps.setToolTip(translate("Number of values, both ends among them"))
        for choice, text in (
            (self.column, translate("Vary")),
            (self.up, translate("Plot")),
            (self.across, translate("over")),
        ):
            choice.setAccessibleName(text)
        form.addRow(translate("Vary"), self.column)
        form.addRow(translate("From"), self.first)
        form.addRow(translate("To"), self.last)
        form.addRow(translate("Values"), self.steps)
        form.addRow(self.make_rows)
        form.addRow(self.rows)
        form.addRow(self.start)
        form.addRow(self.take)
        form.addRow(translate("Plot"), self.up)
        form.addRow(translate("over"), self.across)
        form.addRow(self.plot)
        form.addRow(self.message)
        self.column.currentIndexChanged.connect(lambda _index: self._offer_present())
        self.make_rows.clicked.connect(lambda _checked=False: self.cross())
        self.start.clicked.connect(lambda _checked=False: self.start_or_stop())
        self.take.clicked.connect(lambda _checked=False: self.take_row())
        self.rows.cellDoubleClicked.connect(lambda row, _column: self.show_row(row))
        self.rows.itemSelectionChanged.connect(self._show_plot)
        self.across.currentIndexChanged.connect(lambda _index: self._show_plot())
        self.up.currentIndexChanged.connect(lambda _index: self.refresh())

    # what the table asks for

    def read(self) -> bool:
        """Read the spreadsheet anew; False with a sentence where it is of no use."""
        self.message.setText("")
        try:
            self.table = studies.read(self.obj)
            self.jobs = studies.jobs_of(self.table, studies.core_study(self.obj, self.table))
        except BalloonError as error:
            if self.table is None or not self.table.inputs:
                self.start.setEnabled(False)
            self.message.setText(translated(str(error)))
            return False
        self.start.setEnabled(True)
        self.row_results = {}
        self._offer_columns()
        self.refresh()
        return True

    def _is_whole(self) -> bool:
        """Nobody has deleted the balloon or the table meanwhile; else a sentence tells."""
        return (self.obj.Balloon is not None and self.obj.Table is not None) or self.read()

    def _offer_columns(self) -> None:
        inputs = [each.heading for each in self.table.inputs.values()]
        for choice, entries in (
            (self.column, inputs),
            (self.across, [*inputs, *self._results()]),
            (self.up, [*self._results(), *inputs]),
        ):
            if [choice.itemText(place) for place in range(choice.count())] != entries:
                choice.clear()
                choice.addItems(entries)
                if choice is not self.up:
                    choice.setCurrentText(self._first_varied())

    def _first_varied(self) -> str:
        """The first input that is not the same in all rows, else the first."""
        rows = [values for values in self.table.rows.values() if isinstance(values, dict)]
        inputs = list(self.table.inputs.values())
        vary = (each for each in inputs if len({str(values[each.key]) for values in rows}) > 1)
        return next(vary, inputs[0]).heading

    def _results(self) -> list[str]:
        return [name for name in self.table.results.values() if name != FAILURE]

    def _shown_results(self) -> list[str]:
        """What the plot shows; the spreadsheet has all of them."""
        return [name for name in self._results() if name == self.up.currentText()]

    def _offer_present(self) -> None:
        place = self.column.currentIndex()
        if self.table is not None and 0 <= place < len(self.table.inputs):
            for field in (self.first, self.last):
                field.setText(list(self.table.inputs.values())[place].shown())

    def cross(self) -> None:
        """Rows for so many values of one column."""
        if not self.read():
            return
        letters = list(self.table.inputs)[self.column.currentIndex()]
        try:
            values = study_table.spread(
                self.table.inputs[letters], self.first.text(), self.last.text(), self.steps.value()
            )
            study_table.cross(self.obj.Table, self.table, letters, values)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self.obj.Table.recompute()
        if self.read():
            self.across.setCurrentText(self.column.currentText())

    # what is known

    def refresh(self) -> None:
        """Show what is known of each row; what was known before is not read again."""
        if self.table is None or self.obj.Table is None:
            return
        missing = {
            number: values for number, values in self.table.rows.items() if not self.row_results.get(number)
        }
        self.row_results |= studies.known(
            self.table._replace(rows=missing), self.jobs, studies.folder(self.obj)
        )
        inputs, results = list(self.table.inputs.values()), self._shown_results()
        rows = {
            number: [
                *(self._input_text(letters, number) for letters in self.table.inputs),
                *(self.row_results.get(number, {}).get(name) for name in results),
            ]
            for number in self.table.rows
        }
        failures = {
            number: translated(str(each.get(FAILURE) or "")) for number, each in self.row_results.items()
        }
        self.rows.show_rows([each.heading for each in inputs], results, rows, failures)
        self._say_counts()
        self._show_plot()

    def _input_text(self, letters: str, number: int) -> str:
        return str(self.obj.Table.getContents(f"{letters}{number}")).lstrip("='")

    def _say_counts(self) -> None:
        failures = [str(each[FAILURE]) for each in self.row_results.values() if each.get(FAILURE)]
        done = sum(bool(each) for each in self.row_results.values())
        text = translate("{} of {} rows are worked out.").format(done, len(self.table.rows))
        if failures:
            text += " " + translate("{} of them cannot be made:").format(len(failures))
        self.message.setText(
            "\n".join([text, *(translated(each) for each in [*dict.fromkeys(failures)][:3])])
        )

    def _show_plot(self) -> None:
        if self.table is None:
            return
        across, up = self._numbers(self.across.currentText()), self._numbers(self.up.currentText())
        points = {row: (across[row], up[row]) for row in across if row in up}
        self.plot.show_points(points, self._axis(self.across), self._axis(self.up), self._chosen())

    def _axis(self, choice) -> str:
        """The name of a column with the unit of its numbers, which names of results have already."""
        name = choice.currentText()
        kinds = [each.kind for each in self.table.inputs.values() if each.heading == name]
        unit = UNITS.get(kinds[0], "") if kinds else ""
        return f"{name} [{unit}]" if unit else name

    def _numbers(self, name: str) -> dict[int, float]:
        """The numbers of a column by row."""
        if name in self.table.results.values():
            values = {row: row_results.get(name) for row, row_results in self.row_results.items()}
        else:
            key = next((each.key for each in self.table.inputs.values() if each.heading == name), "")
            values = {row: own.get(key) for row, own in self.table.rows.items() if isinstance(own, dict)}
        return {
            row: float(value)
            for row, value in values.items()
            if isinstance(value, (int, float)) and not isinstance(value, bool)
        }

    def _chosen(self) -> int | None:
        """The number of the chosen row in the spreadsheet."""
        places = sorted({index.row() for index in self.rows.selectedIndexes()})
        return list(self.table.rows)[places[0]] if places and self.table is not None else None

    # the work

    def start_or_stop(self) -> None:
        """Work out what is missing, or stop: what is there stays, and the next start goes on from it."""
        if self.worker is not None:
            self.worker.stop()
            return
        if not self.read():
            return
        try:
            study = studies.core_study(self.obj, self.table)
            request = _StudyRun(study, studies.folder(self.obj), studies.runner(self.obj))
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self.worker = Worker(request, self.form, translate("Study"))
        self.worker.progressed.connect(lambda _fraction, text: self._progressed(text))
        self.worker.ended.connect(self._ended)
        self._progress = ""
        self.start.setText(translate("Stop"))
        self.make_rows.setEnabled(False)
        self.worker.start()

    def _progressed(self, text: str) -> None:
        if text != self._progress:  # a balloon more
            self._progress = text
            self.refresh()

    def _ended(self) -> None:
        worker, self.worker = self.worker, None
        self.start.setText(translate("Work out"))
        self.make_rows.setEnabled(True)
        self.refresh()
        self._keep()
        if worker.error is not None and not isinstance(worker.error, Cancelled):
            worker.fault()
            self.message.setText(translated(str(worker.error)))
        worker.deleteLater()

    def _keep(self) -> None:
        """Write the results into the spreadsheet."""
        if self.table is not None and self.obj.Table is not None:
            studies.keep_results(self.obj, self.table, self.row_results)
            self.obj.Table.recompute()

    def show_row(self, place: int) -> None:
        """Show the balloon of a row in place of the document's own."""
        import Mesh

        if not self._is_whole():
            return
        number = list(self.table.rows)[place]
        if number not in self.jobs:
            return
        path = StudyFolder(studies.folder(self.obj)).of(self.jobs[number].key) / MESH
        if not path.is_file():
            self.message.setText(translate("This row is not worked out: choose Work out."))
            return
        balloon, shown = self.obj.Balloon, self.obj.Shown
        if shown is None:
            shown = self.doc.addObject("Mesh::Feature", "StudyRow")
            self.obj.Shown = shown
        shown.Mesh, shown.Placement = Mesh.Mesh(str(path)), balloon.Placement
        shown.Label = translate("{}, row {}").format(balloon.Label, number)
        balloon.ViewObject.Visibility = False
        shown.ViewObject.Visibility = True
        fit_all(balloon.ViewObject.Document)

    def take_row(self) -> None:
        """Give the document the values of the chosen row."""
        if not self._is_whole():
            return
        number = self._chosen()
        if number is None or self.worker is not None:
            self.message.setText(translate("Choose a row first."))
            return
        try:
            studies.take_row(self.obj, self.table, number)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self.obj.Balloon.ViewObject.Visibility = True
        if self.obj.Shown is not None:
            self.obj.Shown.ViewObject.Visibility = False
        self.doc.recompute()
        if self.is_open:
            self.read()

    # the dialog

    def abandon(self) -> None:
        if self.worker is not None:
            self.worker.abandon()
            self.worker = None
        super().abandon()

    def accept(self):
        if self.worker is not None:
            self.worker.abandon()
            self.worker = None
        self._keep()
        self.doc.recompute([*filter(None, (self.obj, self.obj.getParentGroup()))])
        self.keep()
        if self.table is not None and self.obj.Balloon is not None and self.obj.Table is not None:
            rows = repr(studies.variants_of(self.obj, self.table))
            parts = f"BalloonWorkbench.parts({macro_recorder.obj(self.obj.Balloon)})"
            macro_recorder.call("study", parts, rows, result=self.obj, name="study")
        return True
