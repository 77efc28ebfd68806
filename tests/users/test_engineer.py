# SPDX-License-Identifier: LGPL-2.1-or-later
"""A CAD engineer makes a balloon of a sketch, changes it, has it cut, adds a second one, and saves."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
import sketches

from BalloonWorkbench.app.border import status


def ready(doc):
    balloons = [obj for obj in doc.Objects if type(getattr(obj, "Proxy", None)).__name__ == "BalloonProxy"]
    return bool(balloons) and all(obj.Status == status.READY for obj in balloons)


def solved():
    return hands.find("Apply").isVisible()


def test_engineer(user, story, tmp_path):
    doc = App.newDocument("Bracket")
    hands.wait(0.3)
    drawn = _balloon_of_sketch(user, story, doc)
    _wider(user, story, doc, drawn)
    _pressure_by_expression(user, story, doc.Balloon)
    _advice(user, story, doc.Balloon)
    _exported(user, story, doc.Pattern, tmp_path)
    _second_balloon(user, story, doc)
    _undone_and_redone(user, story, doc)
    _saved_and_opened(user, story, doc, tmp_path)


def _balloon_of_sketch(user, story, doc):
    drawn = sketches.rectangle(doc, 90, 60)
    Gui.SendMsgToActiveView("ViewFit")
    user.select(drawn)
    story.step("sketch-selected")
    user.command("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.panel_is_seen)
    story.step("panel-opens")
    hands.wait_until(lambda: ready(doc) and solved(), 60)
    story.step("inflated")
    for number in range(hands.find("Steps").count()):
        user.button(f"Step{number}")
        hands.wait_until(solved, 60)
        story.step(f"page-{number + 1}")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    story.expect("001" not in doc.Balloon.Label, f"the first balloon is called {doc.Balloon.Label}")
    story.step("ok")
    return drawn


def _wider(user, story, doc, drawn):
    drawn.setDatum("Width", App.Units.Quantity("140 mm"))
    user.click(hands.visible(hands.QtWidgets.QMenuBar)[0].mapToGlobal(hands.QtCore.QPoint(400, 10)))
    user.key("Escape")
    doc.recompute()
    hands.wait(0.5)
    story.expect(
        doc.Balloon.InflatedWidth.Value == pytest.approx(140, rel=0.03), "the balloon is not 140 mm wide"
    )
    story.step("dimension-140")


def _pressure_by_expression(user, story, balloon):
    user.open_in_tree(balloon)
    hands.wait_until(hands.panel_is_seen)
    field = hands.find("Pressure")
    hands.show_tab(field)
    hands.wait(0.5)  # the page takes its place
    user.click(field.mapToGlobal(hands.QtCore.QPoint(20, field.height() // 2)))
    story.step("pressure-page")
    give_expression(user, field, "1 kPa + 2 kPa", story)
    hands.wait_until(lambda: balloon.Pressure.Value == pytest.approx(3), 20)
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    story.expect(bool(balloon.ExpressionEngine), "the expression was not kept")
    story.step("expression")


def _advice(user, story, balloon):
    user.select(balloon)
    user.command("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    hands.wait(2.0)
    story.step("advice")
    user.panel(
        "Close" if hands.panel_buttons()[0].button(hands.QtWidgets.QDialogButtonBox.Close) else "Cancel"
    )
    hands.wait_until(hands.panel_is_closed)


def _exported(user, story, pattern, folder):
    user.select(pattern)
    user.command("BalloonWorkbench_ExportPattern")
    hands.wait_until(hands.panel_is_seen)
    user.choose(hands.find("Machine"), "LightBurn")
    story.step("export-machine")
    story.expect(
        "Bracket" in hands.find("File").text() or "Rectangle" in hands.find("File").text(),
        f"the file is not called after the balloon: {hands.find('File').text()}",
    )
    user.replace(hands.find("File"), str(folder / "bracket.dxf"), confirm=False)
    story.step("export-file")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed)
    assert (folder / "bracket.dxf").exists()
    story.step("exported")


def _second_balloon(user, story, doc):
    second = sketches.sketch(doc, *sketches.polygon((0, 0), (70, 0), (35, 60)), name="Triangle")
    user.select(second)
    user.command("BalloonWorkbench_FromSketch")
    hands.wait_until(hands.panel_is_seen)
    hands.wait_until(lambda: ready(doc) and solved(), 60)
    story.step("second-panel")
    user.panel("Ok")
    hands.wait_until(hands.panel_is_closed, 60)
    user.key("v")
    user.key("f")
    story.step("second")


def _undone_and_redone(user, story, doc):
    names = [obj.Name for obj in doc.Objects]
    user.key("Ctrl", "z")
    hands.wait(0.5)
    story.expect(len(doc.Objects) < len(names), "undo left the second balloon")
    story.step("undone")
    user.key("Ctrl", "Shift", "z")
    hands.wait(0.5)
    story.expect([obj.Name for obj in doc.Objects] == names, "redo did not bring the second balloon back")
    story.step("redone")


def _saved_and_opened(user, story, doc, folder):
    file = folder / "bracket.FCStd"
    with user.answering(file):
        user.key("Ctrl", "s")
        hands.wait_until(file.exists, 20)
    App.closeDocument(doc.Name)
    App.openDocument(str(file))
    hands.wait(1.0)
    story.expect(ready(App.ActiveDocument), "the balloons are not ready after opening")
    story.step("reopened")


def give_expression(user, field, text, story):
    """Press = in a field, type, confirm: FreeCAD's own dialog."""
    from hands import QtCore, QtWidgets

    done = []

    def look():
        for dialog in hands.visible(QtWidgets.QDialog):
            if "Expression" in dialog.metaObject().className() and not done:
                done.append(True)
                user.key("Ctrl", "a")
                user.write(text)
                hands.wait(0.3)
                story.step("expression-dialog")
                user.key("Return")

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(300)
    user.write("=")
    hands.wait(1.5)
    timer.stop()
    assert done, "no dialog for an expression came"
