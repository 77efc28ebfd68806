# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys alone come to every command of the workbench."""

import FreeCADGui as Gui
import hands

from BalloonWorkbench.gui import commands

Qt = hands.QtCore.Qt


def menu():
    """The menu of the workbench, after what Python has to hold for it."""
    window = Gui.getMainWindow()
    bar = window.menuBar()
    (entry,) = [each for each in bar.actions() if each.text().replace("&", "") == "Film Balloon"]
    assert "&" in entry.text(), "Alt and its letter open the menu"
    return window, bar, entry, entry.menu()


def test_every_command_is_in_the_menu():
    """The examples are a menu of their own in it."""
    known = {name for name in Gui.listCommands() if name.startswith("BalloonWorkbench_")}
    known = {name for name in known if not name.startswith("BalloonWorkbench_Example_")}
    *_held, entries = menu()
    assert known == set(commands._COMMANDS) | set(commands._RARE)
    assert len([each for each in entries.actions() if not each.isSeparator()]) == len(known)


def test_arrows_come_to_every_entry(made):
    """Down goes through those that can be chosen, and from the last one to the first."""
    *_held, entries = menu()
    entries.popup(hands.QtCore.QPoint(200, 100))
    hands.wait_until(entries.isVisible)
    for each in entries.actions():
        each.setEnabled(True)
    wanted = [each for each in entries.actions() if not each.isSeparator()]
    reached = []
    for _ in wanted:
        hands.key(entries, Qt.Key_Down)
        reached.append(entries.activeAction())
    entries.close()
    assert [each.text() for each in reached] == [each.text() for each in wanted]
