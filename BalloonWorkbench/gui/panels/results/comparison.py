# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that lays a photograph of the balloon over the simulated one, and keeps the fitted film."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import FreeCADGui as Gui

from BalloonWorkbench.app.as_made import photo_comparison
from BalloonWorkbench.app.drawings.qt_picture import picture_reader
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.as_made.comparison_picture import comparison_png
from BalloonWorkbench.core.as_made.comparison_report import comparison_lines
from BalloonWorkbench.core.as_made.photo_scale import FIT
from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.results.photo_marks import PictureWindow
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowForm, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, icon, number_of, translate
from BalloonWorkbench.gui.window import file_dialogs, macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import length_text
from BalloonWorkbench.gui.wrapping import CheckBox, PushButton

_LEAST = 60  # px
_PIXELS = 5  # digits of a length in the picture


class ComparisonPanel(TaskPanel):
    """Compares one balloon; the document stays as it is."""

    def __init__(self, parts):
        self.parts, self.photo = parts, ""
        self.worker: Worker | None = None
        self.compared = None
        self._asked: dict[str, str] = {}  # for what the comparison holds, by the names of the Python API
        self._picture_window = None
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("ComparisonPanel")
        self.form.setWindowTitle(translate("As made"))
        self.form.setWindowIcon(QtGui.QIcon(icon("compare")))
        self._make_fields()
        self._make_answers()
        form = NarrowForm(self.form)
        form.addRow(QtWidgets.QLabel(translate("Photograph")))
        form.addRow(self.file)
        form.addRow(self.mark)
        form.addRow(translate("Pixels"), self.pixels)
        form.addRow(translate("True length"), self.length)
        form.addRow(self.unknown)
        form.addRow(translate("Rim"), self.rim)
        form.addRow(self.fit)
        form.addRow(self.start)
        for widget in (self.message, self.picture, self.save, self.keep, self.replace):
            form.addRow(widget)
        self._show()
        self.watch = Watch(parts, self.close)

    def _make_fields(self) -> None:
        self.file = FileRow(
            "Photo",
            translate("PNG, JPEG or BMP"),
            translate("Straight from the front, from far away, on a plain background of another colour"),
            file_dialogs.ask_for_picture,
        )
        self.mark = PushButton(translate("Mark a length…"))
        self.mark.setToolTip(
            translate("Click both ends of a ruler in the picture, or of another known length")
        )
        self.pixels, self.length, self.rim = (QtWidgets.QLineEdit() for _ in range(3))
        self.pixels.setToolTip(translate("A known length, in pixels of the picture"))
        self.length.setToolTip(translate("The same length as it is, such as 300 mm"))
        self.length.setPlaceholderText("300 mm")
        self.rim.setPlaceholderText(length_text(photo_comparison.usual_rim(self.parts)))
        self.rim.setToolTip(
            translate(
                "How far weld and film reach beyond the seam in the photograph; empty: as in the pattern, 0:"
                " folded back"
            )
        )
        self.unknown = CheckBox(translate("Size unknown"))
        self.unknown.setToolTip(translate("Only the shape is compared, at the size that fits best"))
        self.fit = CheckBox(translate("Fit the film, too"))
        self.fit.setToolTip(
            translate("Find how much the film stretched, and how far the weld draws the seam inward")
        )
        self.start = PushButton(translate("Compare"))
        names = {"MarkLength": self.mark, "PhotoPixels": self.pixels, "PhotoLength": self.length}
        names |= {"PhotoRim": self.rim, "SizeUnknown": self.unknown, "FitFilm": self.fit}
        for name, widget in (names | {"Compare": self.start}).items():
            widget.setObjectName(name)
        for line in (self.pixels, self.length, self.rim):
            line.setMinimumWidth(_LEAST)
        self.file.chosen.connect(self.choose)
        self.mark.clicked.connect(lambda _checked=False: self.mark_length())
        self.unknown.toggled.connect(lambda _checked: self._show())
        self.start.clicked.connect(lambda _checked=False: self.compare())

    def _make_answers(self) -> None:
        self.message = WrappedLabel()
        self.message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.picture = _Thumbnail()
        self.picture.pressed.connect(self._enlarge)
        self.save = PushButton(translate("Save files…"))
        self.save.setToolTip(translate("The picture, and all figures as JSON"))
        self.keep = PushButton(translate("Keep the film"))
        self.keep.setToolTip(
            translate("A film of your own beside the balloon's, with what was found; it changes no pattern")
        )
        self.replace = CheckBox(translate("Forget earlier photographs"))
        self.replace.setToolTip(
            translate("A film of this name is there already: else it gets the mean of all")
        )
        for name, widget in {
            "Message": self.message,
            "ComparedPicture": self.picture,
            "SaveComparison": self.save,
            "KeepFilm": self.keep,
            "ReplaceFilm": self.replace,
        }.items():
            widget.setObjectName(name)
        self.save.clicked.connect(lambda _checked=False: self.save_files())
        self.keep.clicked.connect(lambda _checked=False: self.keep_film())

    def choose(self, path: str) -> None:
        """Take a photograph."""
        self.photo = str(Path(path).expanduser())
        self.file.show_name(Path(path).name)
        self.file.path.setToolTip(self.photo)
        self.message.setText("")
        self._forget()

    def mark_length(self) -> None:
        """Show the photograph, in which a length is marked."""
        self.file.take()
        pixmap = self._pixmap()
        if pixmap.isNull():
            self.message.setText(translate("Choose a photograph first: a PNG, JPEG or BMP file."))
            return
        self._open(PictureWindow(pixmap, translate("Mark a length"), marks=True))
        self._picture_window.marked.connect(self._take_pixels)

    def compare(self) -> None:
        """Begin, in a thread."""
        self.file.take()
        self._close_picture()
        self._forget()
        try:
            asked = self._asking()
            job = photo_comparison.comparing(self.parts, **asked, fit=self.fit.isChecked())
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self._asked = asked
        self.message.setText(translate("Comparing…"))
        self.worker = Worker(_Comparing(job), title="Comparing with the photograph")
        self.worker.ended.connect(partial(self._answered, self.worker))
        self.worker.start()
        self._show()

    def _asking(self) -> dict[str, str]:
        """Photograph, scale and rim by the names of the Python API. Raises InputError."""
        if not self.photo:
            raise InputError(translate("Choose a photograph first: a PNG, JPEG or BMP file."))
        pixels, length = (line.text().replace(",", ".").strip() for line in (self.pixels, self.length))
        if self.unknown.isChecked():
            scale = FIT
        elif pixels and length:
            scale = f"{pixels},{length if length[-1].isalpha() else length + 'mm'}"
        else:
            raise InputError(
                translate("Mark a length in the picture, and give its true length, such as 300 mm.")
            )
        rim = self.rim.text().replace(",", ".").strip()
        return {"photo": self.photo, "scale": scale} | ({"rim": rim} if rim else {})

    def _answered(self, worker: Worker) -> None:
        worker.deleteLater()
        if worker is not self.worker:
            return
        self.worker = None
        worker.fault()
        if worker.error is not None:
            self.message.setText(translated(str(worker.error)))
        else:
            self.compared, png = worker.design
            lines = comparison_lines(self.compared.comparison, self.compared.fit)
            self.message.setText("\n".join(map(translated, lines)))
            self.picture.show_picture(_read(png))
        self._show()

    def save_files(self) -> None:
        """Ask for a folder, and write picture and figures."""
        start = str(preferences.export_folder(self.parts.balloon.Document))
        folder = QtWidgets.QFileDialog.getExistingDirectory(self.form, translate("Choose a folder"), start)
        if not folder:
            return
        try:
            photo_comparison.write(self.compared, folder)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self._record("compare", self.compared, folder=macro_recorder.text(folder))
        preferences.put_export_folder(self.parts.balloon.Document, folder)
        self._say(translate("Files written to {}").format(folder))

    def keep_film(self) -> None:
        """Keep the fitted film among the user's own."""
        balloon, replace = self.parts.balloon, self.replace.isChecked()
        try:
            path = photo_comparison.keep_film(balloon, self.compared, self.photo, replace)
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        self._record("fit_film", path, **({"replace": "True"} if replace else {}))
        self.keep.setEnabled(False)
        self._say(translate("{} is among the films").format(path.stem))

    def _record(self, function: str, result, **more: str) -> None:
        made = f"BalloonWorkbench.parts({macro_recorder.obj(self.parts.balloon)})"
        named = {name: macro_recorder.text(value) for name, value in self._asked.items()}
        macro_recorder.call(function, made, **named, **more, result=result)

    def _say(self, sentence: str) -> None:
        Gui.getMainWindow().statusBar().showMessage(sentence, 8000)

    def _forget(self) -> None:
        """What was found holds no more."""
        self.compared = None
        self._stop()
        self._show()

    def _stop(self) -> None:
        if self.worker is not None:
            self.worker.stop()
        self.worker = None

    def _show(self) -> None:
        """Only what makes sense now can be used."""
        works, done = self.worker is not None, self.compared is not None
        sized = not self.unknown.isChecked()
        for widget in (self.mark, self.pixels, self.length, self.fit):
            widget.setEnabled(sized)
        if not sized:
            self.fit.setChecked(False)
        self.start.setEnabled(not works)
        self.picture.setVisible(done)
        self.save.setVisible(done)
        fitted = done and self.compared.fit is not None
        self.keep.setVisible(fitted)
        self.keep.setEnabled(fitted)
        self.replace.setChecked(False)
        self.replace.setVisible(fitted and self._is_there())

    def _is_there(self) -> bool:
        try:
            return photo_comparison.fitted_film(self.parts.balloon).exists()
        except InputError:  # said when it is asked for
            return False

    def _pixmap(self):
        reader = picture_reader(self.photo)
        return QtGui.QPixmap.fromImage(reader.read()) if self.photo else QtGui.QPixmap()

    def _take_pixels(self, length: float) -> None:
        self.pixels.setText(number_text(length, _PIXELS))

    def _enlarge(self) -> None:
        self._open(PictureWindow(self.picture.whole, translate("Compare with a photograph"), marks=False))

    def _open(self, window) -> None:
        self._close_picture()
        self._picture_window = window
        window.destroyed.connect(lambda *_window: setattr(self, "_picture_window", None))
        window.show()

    def _close_picture(self) -> None:
        if self._picture_window is not None:
            self._picture_window.close()
            self._picture_window = None

    def getStandardButtons(self):
        return number_of(QtWidgets.QDialogButtonBox.Close)

    def reject(self):
        self.close()
        return True

    def close(self) -> None:
        self._stop()
        self._close_picture()
        self.watch.remove()
        Gui.Control.closeDialog()


class _Comparing:
    """What a worker is asked: the comparison and its picture."""

    def __init__(self, job):
        self._job = job

    def solve(self, progress):
        compared = self._job(progress)
        return compared, comparison_png(compared.comparison)


class _Thumbnail(QtWidgets.QLabel):
    """A picture as wide as there is room; `pressed` wishes to see it larger."""

    pressed = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self.whole = QtGui.QPixmap()
        self.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Fixed)
        self.setCursor(QtCore.Qt.PointingHandCursor)
        self.setToolTip(translate("Click to see it larger"))

    def show_picture(self, pixmap) -> None:
        """Another picture."""
        self.whole = pixmap
        self._fit()

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._fit()

    def mousePressEvent(self, event):
        self.pressed.emit()

    def _fit(self) -> None:
        if not self.whole.isNull():
            shown = self.whole.scaledToWidth(max(self.width(), _LEAST), QtCore.Qt.SmoothTransformation)
            self.setPixmap(shown)
            self.setFixedHeight(shown.height())


def _read(png: bytes):
    pixmap = QtGui.QPixmap()
    pixmap.loadFromData(png, "PNG")
    return pixmap
