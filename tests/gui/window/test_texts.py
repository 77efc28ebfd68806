# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window shows: no address of a file, and no report view for an ordinary mistake."""

import re
from collections.abc import Iterator
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import hands
import Part
import pytest

from BalloonWorkbench.app.border import hooks, status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.outline import set_drawing
from BalloonWorkbench.core.errors import ProgramFault
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.panels.widgets.target_file import name_of
from BalloonWorkbench.gui.qt import QtWidgets

OURS = [name for name in Gui.listCommands() if name.startswith("BalloonWorkbench_")]
#: An address, or folders with separators between them; "DXF, SVG/PDF" and "g/m²" are none.
ADDRESS = re.compile(r"file:|\.html\b|\.svg\b|/\w+/|[A-Za-z]:\\")


def texts_of(widget) -> Iterator[str]:
    """All that a widget shows, or tells when the pointer rests on it."""
    yield from (widget.toolTip(), widget.statusTip())
    if widget.objectName() not in FILES:
        yield from (str(widget.property(name) or "") for name in ("text", "title", "windowTitle"))
    if isinstance(widget, QtWidgets.QComboBox):
        for index in range(widget.count()):
            yield widget.itemText(index)
            yield str(widget.itemData(index, hands.QtCore.Qt.ToolTipRole) or "")
    for action in QtWidgets.QWidget.actions(widget):
        yield from (action.text(), action.toolTip(), action.statusTip())


#: Fields in which users write names of files.
FILES = ("Drawing", "File", "AssemblyFile", "Folder", "CardFolder", "PreferredExportFolder")


def test_tooltips_of_commands_show_no_address():
    """FreeCAD makes them of all that a command tells of itself."""
    for name in OURS:
        for action in Gui.Command.get(name).getAction():
            assert not ADDRESS.search(action.toolTip() + action.statusTip()), name


PANELS = ("Advice", "Animate", "Artwork", "AssemblySheet", "ColourMap", "Compare", "ExportPattern", "Nest")
PANELS += ("ExportForWeb", "Study")


@pytest.mark.slow
def test_nothing_shows_an_address(made):
    """All widgets of a panel, on all its pages, and of the window's own bars."""
    for command in (*PANELS, "balloon", "Equipment", "Machines", "TestCard", "Paint"):
        shown = _shown_by(command, made)
        assert len(shown) > 20, command
        own = str(Path(made.outline.Document.FileName).parent)  # where the user's file goes may be told
        written = f"{name_of(made.balloon)}.html"  # and what it is called
        told = [text.replace(own, "").replace(written, "") for text in shown]
        assert not [*filter(ADDRESS.search, told)], command


def _shown_by(command, made):
    """The texts of a panel or window, which is opened and closed again."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(made.pattern)
    if command == "balloon":
        made.balloon.ViewObject.Proxy.doubleClicked(made.balloon.ViewObject)
    else:
        Gui.runCommand(f"BalloonWorkbench_{command}")
    hands.wait_until(lambda: paint_window._open if command == "Paint" else hands.panel_is_seen())
    hands.wait(0.3)
    widgets = [widget for widget in hands.visible(QtWidgets.QWidget) if is_ours(widget)]
    shown = [re.sub("<[^>]*>", "", text) for widget in widgets for text in texts_of(widget)]
    for window in list(paint_window._open):
        window.close()
    if hands.panel_is_open():
        hands.leave()
        hands.wait_until(hands.panel_is_closed)
    return shown


def is_ours(widget) -> bool:
    """FreeCAD's own report view, combo view and status bar are its own."""
    while widget is not None:
        if widget.objectName() in ("Report view", "Python console", "Start page"):
            return False
        widget = widget.parentWidget()
    return True


OPENS = ("checkShowReportViewOnError", "checkShowReportViewOnWarning")


@pytest.fixture
def report_view():
    """FreeCAD's report view, closed; it opens by itself for what FreeCAD takes for an error or a warning."""
    docks = Gui.getMainWindow().findChildren(QtWidgets.QDockWidget)
    (dock,) = [dock for dock in docks if dock.objectName() == "Report view"]
    settings = App.ParamGet("User parameter:BaseApp/Preferences/OutputWindow")
    for name in OPENS:  # as FreeCAD 0.20 does by itself
        settings.SetBool(name, True)
    was = dock.isVisible()
    dock.hide()
    hands.wait(0.1)
    yield dock
    dock.setVisible(was)
    for name in OPENS:
        settings.RemBool(name)


def test_report_view_opens_for_an_error(report_view):
    """What the tests below would see."""
    App.Console.PrintError("This opens it.\n")
    hands.wait(0.5)
    assert report_view.isVisible()


def _open_sketch(made, folder):
    sketch = made.balloon.Document.addObject("Sketcher::SketchObject", "Open")
    sketch.addGeometry(Part.LineSegment(App.Vector(0, 0, 0), App.Vector(50, 0, 0)), False)
    made.outline.Source = (sketch, [])
    made.outline.Document.recompute()
    assert not status.is_ready(made.outline)


def _nonsense_pressure(made, folder):
    made.balloon.Pressure = 0.0
    made.balloon.Document.recompute()
    assert not status.is_ready(made.balloon)


def _coarse_mesh(made, folder):
    made.balloon.MeshSize = 500.0
    made.balloon.Document.recompute()
    assert not status.is_ready(made.balloon)


def _narrow_film(made, folder):
    Gui.Selection.addSelection(made.pattern)
    Gui.runCommand("BalloonWorkbench_Nest")
    hands.wait_until(hands.panel_is_seen)
    hands.find("FilmWidth").setProperty("rawValue", 20.0)
    hands.wait(0.3)
    hands.leave()


def _no_picture(made, folder):
    (folder / "text.png").write_text("no picture")
    other = create.make(made.balloon.Document)
    set_drawing(other.outline, folder / "text.png")
    made.balloon.Document.recompute()
    assert not status.is_ready(other.outline)


def _wide_relief(made, folder):
    made.pattern.CornerRadius = 50.0
    made.pattern.Document.recompute()
    assert not status.is_ready(made.pattern)


def _nothing_selected(made, folder):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(made.balloon.Document.addObject("App::DocumentObjectGroup", "Empty"))
    for name in OURS:
        if name.split("_")[1] in PANELS and Gui.Command.get(name).isActive():
            Gui.runCommand(name)
            hands.wait(0.2)
            if hands.panel_is_open():
                hands.leave()


def _macro(made, folder):
    """A mistake in a call of the API is the caller's own: it is raised, not printed."""
    with pytest.raises(Exception, match="cheese"):
        create.configure(made, material="cheese")


@pytest.mark.slow
@pytest.mark.parametrize(
    "mistake",
    [
        *(_open_sketch, _nonsense_pressure, _coarse_mesh, _narrow_film),
        *(_no_picture, _wide_relief, _nothing_selected, _macro),
    ],
)
def test_a_mistake_opens_no_report_view(made, report_view, mistake, tmp_path):
    mistake(made, tmp_path)
    hands.wait(0.5)
    assert not report_view.isVisible()


def test_a_fault_of_the_program_opens_it(made, report_view):
    hooks.report(ProgramFault("This is a fault of the program, not yours."))
    hands.wait(0.5)
    assert report_view.isVisible()
