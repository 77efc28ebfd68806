# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens every panel of the workbench, one after the other, for those who look at each of them.

Each function yields a name while a panel, or a page of it, is on the screen, and closes it afterwards.
"""

import gc

import brush
import FreeCADGui as Gui
import hands
from drawn_pictures import coloured, disc, drawn, png

from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.gui.outline_editor import tab as outline_tabs
from BalloonWorkbench.gui.panels.widgets.pages import Pages
from BalloonWorkbench.gui.pattern_view import tab as pattern_tabs
from BalloonWorkbench.gui.window.borders import TaskPanel
from BalloonWorkbench.gui.window.preferences_page import PreferencesPage

QtWidgets = hands.QtWidgets

#: Commands that open a panel on a finished balloon.
COMMANDS = (
    "ExportPattern",
    "Advice",
    "Artwork",
    "Nest",
    "Study",
    "AssemblySheet",
    "ExportForWeb",
    "ColourMap",
    "Animate",
    "Compare",
    "Machines",
    "TestCard",
    "Equipment",
)


#: The classes of all panels that were looked at.
looked_at: set[type] = set()


def dock():
    """The dock with the open panel."""
    looked_at.update(type(each) for each in gc.get_objects() if isinstance(each, TaskPanel))
    (row,) = hands.panel_buttons()
    (around,) = [each for each in hands.visible(QtWidgets.QDockWidget) if each.isAncestorOf(row)]
    return around


def pages(name):
    """Each page of the open panel."""
    (tabs,) = hands.visible(Pages)
    for page in range(tabs.count()):
        tabs.setCurrentIndex(page)
        hands.wait(0.1)
        yield f"{name}-{page}"


def balloon(made):
    """The panel of a finished balloon."""
    made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.wait(1.0)  # the maker's numbers come from a thread
    yield from pages("balloon")
    hands.leave()
    hands.wait_until(hands.panel_is_closed)


def picture(_doc):
    """A new balloon from a picture that is not chosen yet."""
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    yield "picture"
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def many_panels(doc, command, entry):
    """A natural shape (FromProfile, 1), or a pouch with its seams (FromPanels, 6); before, without either."""
    Gui.runCommand(f"BalloonWorkbench_{command}")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.Live = False
    yield f"{command}-empty"
    combo = hands.find("ProfileFrom" if command == "FromProfile" else "Ready")
    hands.choose(combo, combo.itemText(entry))
    yield command
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def body(doc):
    """Without one, and with one that has the most to say: a ball, whose face is curved both ways."""
    ball = doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    Gui.runCommand("BalloonWorkbench_FromBody")
    hands.wait_until(hands.panel_is_seen)
    doc.Balloon.Live = False
    yield "FromBody-empty"
    Gui.Selection.addSelection(ball)
    hands.wait_until(lambda: hands.find("BodyNotes").text())
    yield "FromBody"
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def others(made):
    """Those that look at a finished balloon, print on it, cut it."""
    for command in COMMANDS:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(made.balloon)
        Gui.runCommand(f"BalloonWorkbench_{command}")
        hands.wait_until(hands.panel_is_seen)
        hands.wait(0.5)
        hands.wait_until(lambda: not hands.visible(QtWidgets.QProgressBar))  # then there is more to see
        if command == "TestCard":
            yield from pages(command)
        else:
            yield command
        hands.leave()
        hands.wait_until(hands.panel_is_closed)


def copied_machine(_doc):
    """The form of a machine of the user's own."""
    Gui.runCommand("BalloonWorkbench_Machines")
    hands.wait_until(hands.panel_is_seen)
    hands.click(hands.find("CopyMachine"))
    yield "Machines-copy"
    hands.leave()
    hands.wait_until(hands.panel_is_closed)


def preferences_page():
    """The page of the preferences, which FreeCAD puts into its dialog."""
    page = PreferencesPage()
    page.loadSettings()
    page.form.resize(700, 560)  # what the dialog has for a page on a small screen
    page.form.show()
    page.form.activateWindow()
    hands.wait(0.1)
    yield page.form
    page.form.hide()
    page.form.deleteLater()


def pattern_view(made):
    """The tab with the flat pieces."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_PatternView")
    hands.wait_until(lambda: bool(hands.visible(pattern_tabs.PatternTab)))
    (tab,) = hands.visible(pattern_tabs.PatternTab)
    yield tab


def outline_editor(doc, folder):
    """The tab with the nodes of an outline from a picture, and the sliders of its tracing."""
    path = folder / "disc.png"
    path.write_bytes(png(coloured(drawn(disc(60, 50, 30), 120, 100, fine=3))[..., :3]))
    outline = create.make(doc).outline
    set_drawing(outline, path)
    doc.recompute([outline])
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(outline)
    hands.wait(0.3)  # from FreeCAD 1.0 on that brings the 3D view to the front
    Gui.runCommand("BalloonWorkbench_EditOutline")
    hands.wait_until(lambda: bool(hands.visible(outline_tabs.OutlineTab)))
    (tab,) = hands.visible(outline_tabs.OutlineTab)
    yield tab
    tab.close_tab()
    hands.wait_until(lambda: not hands.visible(outline_tabs.OutlineTab))


def painting():
    """The window for painting: the canvas and the dock beside it."""
    window = brush.open_window()
    yield window
    brush.close_window()
    hands.wait_until(brush.is_closed)
