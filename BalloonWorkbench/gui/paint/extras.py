# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the second row of the paint window does: layers, any colour, symmetry, text, stamps, the clipboard."""

from __future__ import annotations

from dataclasses import replace

from BalloonWorkbench.gui.paint.bars import ActionBar, ToolBox
from BalloonWorkbench.gui.paint.canvas.canvas_widget import Canvas
from BalloonWorkbench.gui.paint.more_bar import LAYER_TITLES, MoreBar, PaintChoices
from BalloonWorkbench.gui.paint.painting.incoming import copied
from BalloonWorkbench.gui.paint.painting.layers import DECORATION, SHAPE, SIDE, most_alpha
from BalloonWorkbench.gui.paint.painting.pictures import Pictures
from BalloonWorkbench.gui.paint.painting.pieces import CutAway
from BalloonWorkbench.gui.paint.painting.tools import COLOURS, MORE_TOOLS, PIPETTE
from BalloonWorkbench.gui.qt import QtCore, QtGui, QtWidgets, translate

_GAP = 8  # px from the corner of the canvas
#: Lies on white paper in every theme.
_LOOK = "background: #fff6ea; color: #3a2a10; border: 1px solid #b0a590; border-radius: 4px; padding: 3px 6px"


class Extras(QtCore.QObject):
    """Connects bars, canvas and pictures of a paint window; widget: the bars, one below the other.

    `chosen` carries a tool, `message` a sentence.
    """

    chosen = QtCore.Signal(object)
    message = QtCore.Signal(str)

    def __init__(self, canvas: Canvas, tools: ToolBox, actions: ActionBar, pictures: Pictures):
        super().__init__(canvas)
        self.painting, self.canvas, self.hand = canvas.painting, canvas, canvas.hand
        self.actions, self.pictures = actions, pictures
        self.bar, self.options = MoreBar(tools.group), PaintChoices()
        self._before = self.hand.tool  # the pipette gives it back
        self._dialog: QtWidgets.QColorDialog | None = None
        self.note = QtWidgets.QLabel(canvas)
        self.note.setObjectName("PaintLayerNote")
        self.note.setStyleSheet(_LOOK)
        self.note.setAttribute(QtCore.Qt.WA_TransparentForMouseEvents)
        self.note.move(_GAP, _GAP)
        self.widget = QtWidgets.QWidget()
        rows = QtWidgets.QVBoxLayout(self.widget)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(0)
        for row in (actions, self.bar, self.options):
            rows.addWidget(row)
        self.bar.hide()
        self._connect()
        self._show_layer()

    def _connect(self) -> None:
        canvas, bar, options = self.canvas, self.bar, self.options
        self.actions.extended.connect(self._extend)
        self.actions.coloured.connect(self.colour)
        self.actions.mirrored.connect(lambda on: self._symmetry(mirror=on))
        bar.chosen.connect(self.chosen)
        bar.layered.connect(self.paint_on)
        bar.coloured.connect(self.colour)
        bar.folded.connect(lambda fold: self._symmetry(fold=fold))
        bar.asked.connect(self.ask_colour)
        options.written.connect(self._write)
        options.ended.connect(self._end_words)
        options.stamped.connect(lambda stamp: setattr(canvas.stamp, "stamp", stamp))
        options.clipped.connect(self.clip)
        canvas.clipped.connect(self.clip)
        canvas.dropped.connect(self.pictures.paste)
        canvas.words.asked.connect(self._begin_words)
        canvas.pipette.picked.connect(self._pick)
        self.pictures.arrived.connect(self._place)

    def begin(self, tool) -> None:
        """A tool was chosen: its choices are there, and what was being placed is painted."""
        self.canvas.finish()
        if self.hand.tool.name != PIPETTE:
            self._before = self.hand.tool
        if tool in MORE_TOOLS:
            self.actions.buttons["more"].setChecked(True)
        self.options.show_for(tool)
        self._describe(tool)

    def key(self, letter: str) -> bool:
        """Do what a key says; False where it says nothing here."""
        fold = self.bar.fold
        actions = {
            "Q": self.actions.buttons["more"].toggle,
            "D": lambda: self.paint_on(DECORATION if self.hand.layer == SHAPE else SHAPE),
            "K": self.ask_colour,
            ",": lambda: fold.setValue(fold.value() - 1),
            ".": lambda: fold.setValue(fold.value() + 1),
        }
        if letter.isdigit():
            self.colour(COLOURS[int(letter) - 1][0])
        elif letter in actions:
            actions[letter]()
        return letter.isdigit() or letter in actions

    def colour(self, value: str) -> None:
        """Paint with a colour."""
        self.hand.colour = value
        self.actions.show_colour(value)
        if value not in dict(COLOURS):
            self.bar.remember(value)
        self.canvas.words.show()

    def ask_colour(self) -> None:
        """Choose any colour, beside the window."""
        if self._dialog is None:
            self._dialog = QtWidgets.QColorDialog(self.canvas)
            self._dialog.setObjectName("PaintColourDialog")
            self._dialog.setOption(QtWidgets.QColorDialog.DontUseNativeDialog)
            self._dialog.setWindowTitle(translate("Any colour"))
            self._dialog.colorSelected.connect(lambda colour: self.colour(colour.name()))
        self._dialog.setCurrentColor(QtGui.QColor(self.hand.colour))
        self._dialog.show()

    def close(self) -> None:
        """The window closes: what stands beside it goes too."""
        if self._dialog is not None:
            self._dialog.close()

    def paint_on(self, layer: str) -> None:
        """Paint on the shape or the decoration; what is being placed will be there, too."""
        self.hand.end()
        self.hand.layer = layer
        self.bar.show_layer(layer)
        self._show_layer()
        if layer == DECORATION and self.painting.is_empty():
            self.message.emit(translate("Paint a shape first: the decoration is seen on it alone."))

    def _show_layer(self) -> None:
        """Say on the paper which layer is painted on, as soon as there is a choice."""
        title = translate(LAYER_TITLES[self.hand.layer])
        self.note.setText(translate("You paint on: {}").format(title))
        self.note.adjustSize()
        self.note.setVisible(self.bar.isVisibleTo(self.widget) or self.hand.layer == DECORATION)
        self._describe(self.hand.tool)

    def _describe(self, tool) -> None:
        """Say for screen readers what the paper is painted with."""
        self.canvas.setAccessibleDescription(f"{translate(tool.text)}. {self.note.text()}")

    def _extend(self, on: bool) -> None:
        self.bar.setVisible(on)
        if not on:
            self.options.hide()
        else:
            self.options.show_for(self.hand.tool)
        self._show_layer()

    def _symmetry(self, **changes) -> None:
        self.hand.symmetry = replace(self.hand.symmetry, **changes)
        self.canvas.update()

    def _pick(self, colour: str) -> None:
        self.colour(colour)
        self.chosen.emit(self._before)

    # text

    def _begin_words(self) -> None:
        self.options.words.clear()
        self._write()
        self.options.words.setFocus()

    def _write(self) -> None:
        words, options = self.canvas.words, self.options
        words.words, words.joined = options.words.text(), options.joined.isChecked()
        words.family = options.font_box.currentFont().family()
        words.show()

    def _end_words(self, keep: bool) -> None:
        floating = self.canvas.floating
        (floating.confirm if keep else floating.drop)()
        self.options.words.clear()
        self.canvas.setFocus()

    # the clipboard

    def clip(self, name: str) -> None:
        """Copy, cut, paste, or select all."""
        selection = self.canvas.selection
        if name == "paste":
            self.canvas.finish()
            self.pictures.paste(QtWidgets.QApplication.clipboard().mimeData())
        elif name == "all":
            selection.box = (0, 0, SIDE, SIDE)
            self.canvas.update()
        else:
            self.canvas.finish()
            box = selection.box or (0, 0, SIDE, SIDE)
            image = self.painting.image if self.hand.layer == SHAPE else self.painting.layers[DECORATION]
            piece = image.copy(*box)
            if not most_alpha(piece):
                self.message.emit(translate("There is nothing to copy: paint something, or select it."))
                return
            QtWidgets.QApplication.clipboard().setMimeData(copied(piece))
            if name == "cut":
                self.painting.do(CutAway(box, self.hand.layer))

    def _place(self, image, at) -> None:
        """A picture to be placed: where it was dropped, else in the middle of what is seen."""
        canvas = self.canvas
        middle = at or canvas.paper.to_paper(QtCore.QPointF(canvas.rect().center()))
        canvas.floating.lay(image, middle)
        canvas.setFocus()
        self.message.emit(
            translate("Pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.")
        )
