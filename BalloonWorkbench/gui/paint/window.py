# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window: a wide canvas beside the 3D view in which the balloon grows.

The document is untouched until "Make it!"; that is one undo step.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from BalloonWorkbench.app import balloon, create, pattern
from BalloonWorkbench.app import painting as painted
from BalloonWorkbench.app.outline import SYMMETRY
from BalloonWorkbench.app.quantities import cubic_millimetres
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.outline.raster import opencv
from BalloonWorkbench.core.types import no_progress
from BalloonWorkbench.gui.paint.bars import ActionBar, ToolBox
from BalloonWorkbench.gui.paint.canvas import Canvas
from BalloonWorkbench.gui.paint.display import MODE
from BalloonWorkbench.gui.paint.live import Live
from BalloonWorkbench.gui.paint.look import CutOut, Glance
from BalloonWorkbench.gui.paint.painting import SIDE, Painting, picture_from
from BalloonWorkbench.gui.paint.scene import Scene
from BalloonWorkbench.gui.paint.strokes import PEN, Clear, Picture, Stroke
from BalloonWorkbench.gui.paint.tools import THICKEST, THINNEST, TOOLS
from BalloonWorkbench.gui.panels import is_free
from BalloonWorkbench.gui.panels.fields import new_quantity_box
from BalloonWorkbench.gui.panels.watch import Watch
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.worker import Worker

_SHARE = 0.5  # of the main window
_PICTURES = "*.png *.jpg *.jpeg *.bmp *.webp"
_open: list[PaintWindow] = []  # none or one


def open_for(doc, parts=None) -> PaintWindow:
    """The paint window on a new balloon of a document, or on a painted one; there is one window at most."""
    if _open and (_open[0].doc != doc or _open[0].parts != parts):
        _open[0].finish()
    if not _open:
        _load()
        _open.append(PaintWindow(doc, parts))
    _open[0].reveal()
    return _open[0]


class PaintWindow(QtWidgets.QDockWidget):
    """Paints one balloon; parts: None until there is one."""

    def __init__(self, doc, parts=None):
        super().__init__(translate("Paint a balloon"), Gui.getMainWindow())
        self.setObjectName("BalloonPaint")
        self.setWindowIcon(drawn_icon("paint"))
        self.doc, self.parts = doc, parts
        self.making = False
        self._hidden: list = []
        self._neighbours: list = []
        self._import: Worker | None = None
        self.painting = Painting(self)
        self.canvas = Canvas(self.painting)
        self.live = Live(self.painting, self)
        self.scene = Scene(doc.Name)
        self.tools, self.actions = ToolBox(), ActionBar()
        self._build()
        self._connect()
        self.watch = Watch(parts or (), self.finish, doc)
        if parts is not None:
            self._take_over(parts)
        self.refresh()

    def reveal(self) -> None:
        """Take the left half of the window, with the painting as it was left."""
        main = Gui.getMainWindow()
        if self.parent() is None or main.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea:
            main.addDockWidget(QtCore.Qt.LeftDockWidgetArea, self, QtCore.Qt.Horizontal)
        if not self.isVisible():
            others = [dock for dock in main.findChildren(QtWidgets.QDockWidget) if dock.isVisible()]
            self._neighbours = [
                (dock, dock.width())
                for dock in others
                if dock is not self and main.dockWidgetArea(dock) == QtCore.Qt.LeftDockWidgetArea
            ]
        self.show()
        self.raise_()
        main.resizeDocks([self], [int(_SHARE * main.width())], QtCore.Qt.Horizontal)
        self._set_hidden(True)
        self.canvas.setFocus()
        if not self.painting.is_empty():
            self.live.changed()

    def closeEvent(self, event):
        """Put aside; the painting is kept for the next time."""
        self._leave()
        super().closeEvent(event)
        QtCore.QTimer.singleShot(0, self._give_back)

    def finish(self) -> None:
        """Close for good."""
        self.watch.remove()
        self._leave()
        if self._import is not None:
            self._import.wait()
        Gui.getMainWindow().removeDockWidget(self)
        self._give_back()
        self.deleteLater()
        if self in _open:
            _open.remove(self)

    def _give_back(self) -> None:
        """The panels beside it are as wide as before, and the 3D view has the room."""
        docks = [(dock, width) for dock, width in self._neighbours if dock.isVisible()]
        if docks:
            Gui.getMainWindow().resizeDocks(*map(list, zip(*docks)), QtCore.Qt.Horizontal)

    def _leave(self) -> None:
        self.making = False
        self.live.stop()
        self.scene.clear()
        self._set_hidden(False)

    # what it consists of

    def _build(self) -> None:
        self.width_field = new_quantity_box()
        self.width_field.setObjectName("PaintWidth")
        self.width_field.setProperty("unit", "mm")
        self.width_field.setProperty("minimum", 1.0)
        self.width_field.setProperty("singleStep", 10.0)
        self.width_field.setProperty("rawValue", self.live.width)
        self.width_field.setKeyboardTracking(False)
        self.width_field.setToolTip(translate("Width of the balloon when it is inflated"))
        self.numbers = QtWidgets.QLabel()
        self.numbers.setObjectName("PaintNumbers")
        self.hint = QtWidgets.QLabel()
        self.hint.setObjectName("PaintHint")
        self.hint.setWordWrap(True)
        self.hint.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
        self.bar = QtWidgets.QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setMaximumHeight(4)
        self.bar.setRange(0, 1000)
        self.make_button = QtWidgets.QPushButton(translate("Make it!"))
        self.make_button.setObjectName("PaintMake")
        self.make_button.setIcon(drawn_icon("balloon"))
        self.make_button.setIconSize(QtCore.QSize(24, 24))
        self.make_button.setToolTip(translate("Put outline, balloon and pattern into the document"))
        font = self.make_button.font()
        font.setBold(True)
        self.make_button.setFont(font)
        below = QtWidgets.QHBoxLayout()
        below.addWidget(QtWidgets.QLabel(translate("Width")))
        below.addWidget(self.width_field)
        below.addWidget(self.numbers, 1)
        below.addWidget(self.make_button)
        body = QtWidgets.QWidget()
        room = QtWidgets.QGridLayout(body)
        room.setContentsMargins(4, 4, 4, 4)
        room.addWidget(self.actions, 0, 0, 1, 2)
        room.addWidget(self.tools, 1, 0)
        room.addWidget(self.canvas, 1, 1)
        room.addWidget(self.bar, 2, 0, 1, 2)
        room.addWidget(self.hint, 3, 0, 1, 2)
        room.addLayout(below, 4, 0, 1, 2)
        room.setColumnStretch(1, 1)
        room.setRowStretch(1, 1)
        self.setWidget(body)

    def _connect(self) -> None:
        self.tools.chosen.connect(self.choose)
        self.actions.coloured.connect(self.colour)
        self.actions.thickened.connect(self.canvas.set_thickness)
        self.actions.mirrored.connect(self._mirror)
        self.actions.acted.connect(self.act)
        self.canvas.chosen.connect(self._key)
        self.canvas.told.connect(self.tell)
        self.canvas.growing.connect(self.live.drawing)
        self.painting.changed.connect(self._painted)
        self.live.found.connect(self._found)
        self.live.refused.connect(self._refused)
        self.live.empty.connect(self._nothing)
        self.live.progressed.connect(lambda part: self.bar.setValue(round(1000 * part) % 1000))
        self.make_button.clicked.connect(self.make)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self.live.stop)
        QtCore.QObject.connect(self.width_field, QtCore.SIGNAL("valueChanged(double)"), self.live.set_width)

    def _take_over(self, parts) -> None:
        """The painting, width and values of a balloon that was made before."""
        outline = parts.outline
        self.painting.load(Path(outline.Drawing))
        self.live.width = outline.Width.Value
        self.width_field.setProperty("rawValue", self.live.width)
        self.live.sheet = pattern.values(parts.pattern)
        if outline.LoopCounts:
            wanted = balloon.request(parts.balloon).settings
            self.live.settings = replace(
                wanted, symmetry=SYMMETRY[outline.Symmetry], intake=parts.pattern.Intake
            )
        self._hidden = [
            obj.Name
            for each in (parts, *create.companions(parts))
            for obj in each
            if obj.ViewObject.Visibility
        ]

    def _set_hidden(self, away: bool) -> None:
        """The objects of the balloon make room for its live look."""
        if self.scene.document() is None:
            return
        for obj in map(self.doc.getObject, self._hidden):
            if obj is not None:
                obj.ViewObject.Visibility = not away

    # what the user does

    def choose(self, tool) -> None:
        self.canvas.cancel()
        self.canvas.tool = tool
        self.tools.show_chosen(tool)
        self.tell("")
        self.canvas.update()

    def colour(self, value: str) -> None:
        self.canvas.colour = value

    def act(self, name: str) -> None:
        """One of the buttons over the canvas."""
        self.canvas.cancel()
        if name in ("undo", "redo"):
            getattr(self.painting, name)()
        elif name == "clear":
            if not self.painting.is_empty():
                self.painting.do(Clear())
        elif name == "fit":
            self.canvas.fit()
        elif name == "backdrop" and self.painting.backdrop is not None:
            self.painting.set_backdrop(None)
        else:
            self._choose_file(as_paint=name == "picture")

    def put_picture(self, path: Path) -> None:
        """Paint a picture, without its background, on the paper."""
        try:
            content = picture_from(path).content
        except BalloonError as error:
            self.tell(str(error))
            return
        self._import = Worker(CutOut(content), self)
        self._import.finished.connect(self._cut_out)
        self._import.start()

    def lay_under(self, path: Path) -> None:
        """A picture for tracing."""
        try:
            self.painting.set_backdrop(picture_from(path))
        except BalloonError as error:
            self.tell(str(error))

    def make(self) -> None:
        """Put the balloon into the document, as soon as it is solved."""
        if self.making or not is_free():
            return
        self.canvas.end()
        if self.painting.is_empty():
            self.tell(translate("Paint something first: a closed line is enough."))
            return
        self.making = True
        self.refresh()
        if self.live.is_settled():
            self._keep(self.live.latest)
        else:
            self.tell(translate("The pattern is being fitted to the painting ..."))
            self.live.study()

    def _keep(self, look) -> None:
        """Take a study over into the document, in one undo step."""
        pause = _breathe
        self.doc.openTransaction(translate("Paint a balloon"))
        try:
            if self.parts is None:
                parts = painted.make(self.doc, look.file, self.live.width, look.solved, pause)
                parts.balloon.getParentGroup().Label = translate("Painted balloon")
                for each in (parts, *create.companions(parts)):
                    each.balloon.ViewObject.DisplayMode = MODE
            else:
                painted.update(self.parts, look.file, self.live.width, look.solved, pause)
        except BalloonError as error:
            self.doc.abortTransaction()
            self.making = False
            self.refresh()
            self.tell(str(error))
            return
        self.doc.commitTransaction()
        self.finish()
        Gui.SendMsgToActiveView("ViewFit")

    def _choose_file(self, as_paint: bool) -> None:
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("Choose a picture"), "", translate("Pictures") + f" ({_PICTURES})"
        )
        if path:
            (self.put_picture if as_paint else self.lay_under)(Path(path))

    def _cut_out(self) -> None:
        worker, self._import = self._import, None
        if worker.design is not None:
            self.painting.do(Picture(worker.design))
        else:
            self.tell(str(worker.error or ""))

    def _key(self, letter: str) -> None:
        thickness = self.actions.thickness
        if letter == "M":
            self.actions.buttons["mirror"].toggle()
        elif letter in ("[", "]"):
            step = 3 if letter == "]" else -3
            thickness.setValue(min(max(thickness.value() + step, THINNEST), THICKEST))
        else:
            self.choose(next(tool for tool in TOOLS if tool.key == letter))

    def _mirror(self, on: bool) -> None:
        self.canvas.mirror = on
        self.canvas.update()

    # what comes of it

    def _painted(self) -> None:
        self.live.changed()
        self.refresh()

    def _found(self, look) -> None:
        width = App.Units.Quantity(self.live.width, App.Units.Length).UserString
        self.canvas.overlay.show(look, width)
        self.canvas.update()
        self.scene.show(look, self.painting.image)
        lengths = [App.Units.Quantity(value, App.Units.Length).UserString for value in look.size]
        volume = App.Units.Quantity(cubic_millimetres(look.volume), App.Units.Volume).UserString
        self.numbers.setText(translate("{} x {}, {} thick, {}").format(*lengths, volume))
        serious = [text for severity, text, _ in look.remarks if severity != "hint"]
        self.tell(serious[0] if serious else "")
        if self.making and self.live.is_settled():
            self._keep(look)

    def _refused(self, text: str) -> None:
        self._nothing()
        self.tell(text)

    def _nothing(self) -> None:
        """There is no balloon to show."""
        self.making = False
        self.canvas.overlay.clear()
        self.canvas.update()
        self.scene.clear()
        self.numbers.setText("")
        self.refresh()

    def tell(self, text: str) -> None:
        self.hint.setText(text or translate("Draw a closed line, or paint an area: it becomes a balloon."))

    def refresh(self) -> None:
        """Buttons that would do nothing are off."""
        buttons = self.actions.buttons
        buttons["undo"].setEnabled(self.painting.can_undo())
        buttons["redo"].setEnabled(self.painting.can_redo())
        self.make_button.setEnabled(not self.making)
        if not self.hint.text():
            self.tell("")


def _load() -> None:
    """Bring in what takes a while to load and stops everything meanwhile: not during the first stroke."""
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    opencv()
    import MeshGui  # noqa: F401
    import PartGui  # noqa: F401
    from pivy import coin  # noqa: F401

    dot = Painting()
    dot.do(Stroke(PEN, "#000000", points=[(SIDE / 2, SIDE / 2, SIDE / 2)]))
    Glance(dot.image, 0, 100.0, Settings()).solve(no_progress)
    QtWidgets.QApplication.restoreOverrideCursor()


def _breathe() -> None:
    """Let the window answer while the document is filled; nobody may change it meanwhile."""
    QtWidgets.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
