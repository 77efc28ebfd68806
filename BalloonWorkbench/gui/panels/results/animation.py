# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that plays an inflation: a slider, play and pause. It leaves the document as it is."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.app.sharing.share import write_shared
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.units import number_text
from BalloonWorkbench.gui.long_work.worker import Worker
from BalloonWorkbench.gui.panels.widgets.narrow import WrappedLabel
from BalloonWorkbench.gui.panels.widgets.target_file import name_of
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, number_of, translate
from BalloonWorkbench.gui.view3d.inflation_player import FRAMES, Player, request_of
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.file_dialogs import ask_where_to_write
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import pressure_text
from BalloonWorkbench.gui.wrapping import PushButton

_FILES = {"gif": "GIF", "mp4": "MP4"}
_BEAT = 40  # ms between frames
_PAUSE = 25  # beats at the end, before it begins again


class AnimationPanel(TaskPanel):
    """Plays the inflation of one balloon."""

    def __init__(self, parts):
        self.parts = parts
        self.worker: Worker | None = None
        self.player: Player | None = None
        self._wait = 0
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("Animation")
        self.form.setWindowTitle(translate("Inflation"))
        self.form.setWindowIcon(drawn_icon("animate"))
        self.bar = QtWidgets.QProgressBar()
        self.bar.setObjectName("AnimationProgress")
        self.bar.setRange(0, 1000)
        self.play = PushButton()
        self.play.setObjectName("Play")
        self.play.setCheckable(True)
        self.play.setToolTip(translate("Play the inflation, or stop at a frame"))
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("Frame")
        self.slider.setRange(0, FRAMES - 1)
        self.slider.setToolTip(translate("From the flat film to the balloon at rest"))
        self.slider.setAccessibleName(self.slider.toolTip())
        self.frame_text = WrappedLabel()
        self.frame_text.setObjectName("FrameTold")
        self.note = QtWidgets.QLabel(
            translate("Frames are even in movement, not in time. Only the film has mass, the gas has none.")
        )
        self.note.setWordWrap(True)
        self.save = PushButton(translate("Save as GIF or MP4"))
        self.save.setObjectName("SaveAnimation")
        self.save.setToolTip(translate("Write these frames as a moving picture, with the artwork, on white"))
        self.message = WrappedLabel()
        self.message.setObjectName("AnimationMessage")
        column = QtWidgets.QVBoxLayout(self.form)
        for widget in (self.bar, self.play, self.slider, self.frame_text, self.note, self.save, self.message):
            column.addWidget(widget)
        self.timer = QtCore.QTimer(self.form)
        self.timer.setInterval(_BEAT)
        self.timer.timeout.connect(self.next_frame)
        self.play.toggled.connect(self.set_playing)
        self.slider.valueChanged.connect(self.show_frame)
        self.save.clicked.connect(lambda _checked=False: self.save_frames())
        self.slider.sliderPressed.connect(lambda: self.play.setChecked(False))
        self.watch = Watch(parts, self.close)
        self._ready(False)
        self.compute()

    # the dialog

    def getStandardButtons(self):
        return number_of(QtWidgets.QDialogButtonBox.Close)

    def isAllowedAlterView(self):
        return True

    def reject(self):
        self.close()
        return False

    def close(self) -> None:
        """Stop everything and bring the balloon back."""
        self.timer.stop()
        self.watch.remove()
        if self.worker is not None:
            self.worker.abandon()
            self.worker = None
        if self.player is not None:
            self.player.close()
            self.player = None
        Gui.Control.closeDialog()

    # the work

    def compute(self) -> None:
        """Begin to compute the frames."""
        try:
            request = request_of(self.parts.balloon)
        except BalloonError as error:
            self.fail(error)
            return
        self.worker = Worker(request, self.form, translate("Inflating in time"))
        self.worker.progressed.connect(lambda fraction, _text: self.bar.setValue(round(1000 * fraction)))
        self.worker.ended.connect(self.work_done)
        self.worker.start()

    def work_done(self) -> None:
        """The frames are there, or the reason why not."""
        worker, self.worker = self.worker, None
        if worker.design is None:
            self.fail(worker.error)
            return
        self.player = Player(self.parts.balloon, worker.design)
        self._ready(True)
        self.play.setChecked(True)

    def set_playing(self, playing: bool) -> None:
        """Play, from the start when it stands at the end, or pause."""
        self.play.setText(translate("Pause") if playing else translate("Play"))
        self._wait = 0
        if playing and self.slider.value() == self.slider.maximum():
            self.slider.setValue(0)
        if playing:
            self.timer.start()
        else:
            self.timer.stop()

    def next_frame(self) -> None:
        """One frame on; at the end a rest, then from the start."""
        if self.slider.value() < self.slider.maximum():
            self.slider.setValue(self.slider.value() + 1)
            return
        self._wait += 1
        if self._wait >= _PAUSE:
            self._wait = 0
            self.slider.setValue(0)

    def show_frame(self, number: int) -> None:
        """Show a frame and say when that is."""
        if self.player is None:
            return
        self.player.show(number)
        frame = self.player.strip.frames[number]
        self.frame_text.setText(
            translate("{} ms, {}, frame {} of {}").format(
                number_text(1000.0 * frame.time), pressure_text(frame.pressure), number + 1, FRAMES
            )
        )

    def save_frames(self) -> None:
        """Ask for a file and write the frames; below stands what came of it."""
        self.play.setChecked(False)
        balloon, strip = self.parts.balloon, self.player.strip
        self.form.setEnabled(False)
        try:
            title = translate("Save the inflation")
            asked = ask_where_to_write(self.form, title, balloon.Document, name_of(balloon), _FILES)
            if asked is None or self.player is None:
                return
            written = write_shared(self.parts, asked, blown=((strip.rest, strip.frames),))
        except BalloonError as error:
            self.message.setText(translated(str(error)))
            return
        finally:
            self.form.setEnabled(True)
        preferences.put_export_folder(balloon.Document, written.parent)
        words = f"BalloonWorkbench.parts({macro_recorder.obj(balloon)})", macro_recorder.text(written)
        macro_recorder.call("share", *words)
        self.message.setText(translate("Written to {}").format(written))

    def _ready(self, ready: bool) -> None:
        self.bar.setVisible(not ready)
        for widget in (self.play, self.slider, self.frame_text, self.save):
            widget.setVisible(ready)
        self.play.setText(translate("Play"))
        if ready:
            self.show_frame(0)

    def fail(self, error: BalloonError) -> None:
        self.bar.hide()
        super().fail(error)
