# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that makes a test card: machine, tool, settings with one value or several, and the folder."""

from __future__ import annotations

from dataclasses import replace

import FreeCAD as App

from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.own.entries import ENTRIES, entry_value
from BalloonWorkbench.core.machines.own.keep import machine_data
from BalloonWorkbench.core.machines.tool import needed
from BalloonWorkbench.core.test_cards.card import make_card
from BalloonWorkbench.core.test_cards.tried import SETTINGS, read_tried
from BalloonWorkbench.core.units import to_mm
from BalloonWorkbench.gui.panels.widgets.narrow import NarrowCombo, NarrowForm, WrappedLabel
from BalloonWorkbench.gui.panels.widgets.target_folder import TargetFolder
from BalloonWorkbench.gui.qt import QtCore, QtWidgets, translate
from BalloonWorkbench.gui.window.sentences import translated
from BalloonWorkbench.gui.window.user_units import size_text

_LEAST = 60  # px


class CardPage(QtWidgets.QWidget):
    """What a card tries."""

    def __init__(self):
        super().__init__()
        self._known = [known for known in machines().values() if known.tool is not None]
        self.choice = NarrowCombo()
        self.choice.setObjectName("CardMachine")
        for known in self._known:
            self.choice.addItem(translated(known.title))
        names = [known.name for known in self._known]
        preferred = preferences.get("Machine")
        self.choice.setCurrentIndex(names.index(preferred) if preferred in names else 0)
        self.tool = NarrowCombo()
        self.tool.setObjectName("CardTool")
        (kinds,) = (entry for entry in ENTRIES if entry.key == "kind")
        for kind, title in kinds.titles.items():
            self.tool.addItem(translated(title), kind)
        self.hint, self.card_size = WrappedLabel(), WrappedLabel()
        self.hint.setText(
            translate(
                "Give one or two settings several values, such as 200, 300, 400, and each of the others one."
            )
        )
        self.card_size.setObjectName("CardSize")
        self._form = NarrowForm(self)
        self._form.addRow(translate("Machine"), self.choice)
        self._form.addRow(translate("Tool"), self.tool)
        self._form.addRow(self.hint)
        self._lines = {name: self._line(name, entry) for name, entry in SETTINGS.items()}
        self.folder = TargetFolder(App.ActiveDocument, "CardFolder", "test-card")
        self._form.addRow(QtWidgets.QLabel(translate("Folder")))
        self._form.addRow(self.folder)
        self._form.addRow(self.card_size)
        self.choice.currentIndexChanged.connect(lambda _index: self._begin())
        self.tool.activated.connect(lambda _index: self._turn())
        self._begin()

    @property
    def machine(self):
        """The chosen machine, with the bed that the user has given it."""
        chosen = self._known[self.choice.currentIndex()]
        return replace(chosen, bed=preferences.bed(chosen))

    @property
    def own_bed(self) -> bool:
        """The bed is another one than in the machine's file."""
        return self.machine.bed != self._known[self.choice.currentIndex()].bed

    def tried(self) -> dict[str, str]:
        """The settings as texts, by the names of the Python API; commas stand between values only."""
        texts = {
            name: _plain(line.text()) for name, (_, line) in self._lines.items() if line.isVisibleTo(self)
        }
        own = {} if self._kind == self.machine.tool.kind else {"tool": self._kind}
        return own | {name: text for name, text in texts.items() if text}

    def objection(self) -> str:
        """What to say instead of making the card; empty where nothing stands against it."""
        tool = self.machine.tool
        known = tool if tool.kind == self._kind else None
        missing = [
            translate(SETTINGS[name].label)
            for name in SETTINGS
            if _in_tool(name) in needed(self._kind, self.machine.version)
            and not self._lines[name][1].text().strip()
            and getattr(known, _in_tool(name), None) is None
        ]
        if missing:
            return translate("Nobody but you knows this: {}. Give one value, or several to try.").format(
                ", ".join(missing)
            )
        return self.folder.objection(["test-card.json", "test-card.svg"])

    @property
    def _kind(self) -> str:
        return self.tool.currentData()

    def _line(self, name: str, entry):
        line = QtWidgets.QLineEdit()
        line.setObjectName(f"Try_{name}")
        line.setMinimumWidth(_LEAST)
        line.setToolTip(translate(entry.tip))
        label = QtWidgets.QLabel(f"{translate(entry.label)} ({entry.unit})")
        label.setBuddy(line)
        self._form.addRow(label)
        self._form.addRow(line)
        line.textChanged.connect(lambda _text: self._show_size())
        return label, line

    def _begin(self) -> None:
        """Another machine: its tool, and what its file knows of it."""
        self.tool.setCurrentIndex(self.tool.findData(self.machine.tool.kind))
        self._turn()

    def _turn(self) -> None:
        """Another tool: the settings that it has."""
        machine = self.machine
        data = machine_data(machine.name) if self._kind == machine.tool.kind else {}
        for name, (label, line) in self._lines.items():
            has = self._kind in SETTINGS[name].of_tool
            for widget in (label, line):
                self._form.show_widget(widget, has)
            line.setText(str(entry_value(SETTINGS[name], data)) if has and data else "")
        self._show_size()

    def _show_size(self) -> None:
        """How many fields there are, on how much film; nothing while something is missing."""
        try:
            card = make_card(self.machine, read_tried(self.tried()))
        except BalloonError:
            self.card_size.setText("")
            return
        size = size_text(*map(to_mm, card.size))
        self.card_size.setText(translate("Fields: {}, on {} of film").format(len(card.fields), size))


def _in_tool(name: str) -> str:
    """A setting as the tool itself calls it."""
    return name.removeprefix("tip_")


def _plain(text: str) -> str:
    """Values with commas between them: where a comma is the decimal point, only one before a space parts."""
    separator = ", " if QtCore.QLocale().decimalPoint() == "," else ","
    values = text.replace(";", ", ").split(separator)
    return ", ".join(value.strip().replace(",", ".") for value in values if value.strip())
