# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel for what is shown on a balloon: a result as colours, the drawing over the silhouette."""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine.bag_result import has_many_panels
from BalloonWorkbench.app.engine.export import export_results
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.results.colour_map import TENSION
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.target_file import name_of
from BalloonWorkbench.gui.panels.widgets.watch import Watch
from BalloonWorkbench.gui.qt import QtWidgets, drawn_icon, translate
from BalloonWorkbench.gui.view3d.film_map import choice_title, choices_of
from BalloonWorkbench.gui.view3d.legend_row import OFF
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.file_dialogs import ask_where_to_write
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.wrapped_check import WrappedCheck

_FILES = {"vtu": "ParaView", "stl": "STL", "npz": "NumPy"}
_STATE = ("ColourMap", "CompareOutlines", "DisplayMode", "ModeWithoutMap")


class ColourMapPanel(TaskPanel):
    """Chooses what is shown on one balloon; Cancel shows what was there before."""

    def __init__(self, parts):
        self.parts = parts
        self.view = parts.balloon.ViewObject
        self.before = {name: getattr(self.view, name) for name in _STATE}
        self.form = QtWidgets.QWidget()
        self.form.setObjectName("ColourMapPanel")
        self.form.setWindowTitle(translate("Colour map"))
        self.form.setWindowIcon(drawn_icon("colour_map"))
        self.choice = ElidedCombo()
        # as wide as the panel, not as its longest entry
        self.choice.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.choice.setMinimumContentsLength(8)
        self.choice.setObjectName("ColourMap")
        self.choice.setAccessibleName(translate("Colour map"))
        self.choice.setToolTip(translate("Result that is shown as colours, with a legend"))
        for entry in choices_of(parts.balloon):
            self.choice.addItem(choice_title(entry), entry)
        self.curves = WrappedCheck(translate("Drawing over silhouette"))
        self.curves.setObjectName("CompareOutlines")
        self.curves.setToolTip(translate("Show the drawing and the silhouette over each other"))
        self.save = QtWidgets.QPushButton(translate("Save results…"))
        self.save.setObjectName("SaveResults")
        self.save.setToolTip(
            translate("Write all results for ParaView (.vtu) or NumPy (.npz), or the shape alone (.stl)")
        )
        self.message = WrappedLabel(translated(status.problem(parts.balloon)))
        self.message.setObjectName("ColourMapMessage")
        column = QtWidgets.QVBoxLayout(self.form)
        for widget in (self.choice, self.curves, self.save, self.message):
            column.addWidget(widget)
        if self.view.ColourMap == OFF:
            self.view.ColourMap = TENSION
        self.choice.setCurrentIndex(self.choice.findData(self.view.ColourMap))
        self.curves.setChecked(self.view.CompareOutlines)
        self.curves.setVisible(not has_many_panels(parts.balloon))
        self.choice.currentIndexChanged.connect(self.choose)
        self.curves.toggled.connect(self.compare)
        self.save.clicked.connect(lambda _checked=False: self.message.setText(save_results(parts.balloon)))
        self.watch = Watch(parts, self.close)

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterSelection(self):
        return True

    def choose(self, index: int) -> None:
        """Show another result."""
        self.view.ColourMap = self.choice.itemData(index)

    def compare(self, visible: bool) -> None:
        """Show the drawing and the silhouette, or not."""
        self.view.CompareOutlines = visible

    def accept(self):
        """Keep what is shown; a macro has it too."""
        name = self.parts.balloon.Name
        for item in _STATE[:2]:
            value = getattr(self.view, item)
            if value != self.before[item]:
                Gui.doCommand(f'Gui.ActiveDocument.getObject("{name}").{item} = {value!r}')
        self.close()
        return False

    def reject(self):
        """Show what was shown before."""
        for name in ("CompareOutlines", "ColourMap", "DisplayMode", "ModeWithoutMap"):
            if getattr(self.view, name) != self.before[name]:
                setattr(self.view, name, self.before[name])
        self.close()
        return False

    def close(self) -> None:
        self.watch.remove()
        Gui.Control.closeDialog()


def save_results(balloon) -> str:
    """Ask for a file, write the results of a balloon object; a sentence about it, empty when cancelled."""
    try:
        path = ask_where_to_write(None, translate("Save results"), balloon.Document, name_of(balloon), _FILES)
        if path is None:
            return ""
        written = export_results(balloon, path)
    except BalloonError as error:
        return translated(str(error))
    preferences.put_export_folder(balloon.Document, written.parent)
    macro_recorder.call("export", macro_recorder.obj(balloon), macro_recorder.text(written))
    return translate("Results written to {}").format(written)
