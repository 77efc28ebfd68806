# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown fills the free part of the 3D view: no panel over the view hides any of it."""

import FreeCAD as App
import FreeCADGui as Gui
import hands
import pytest
from pictures import framed

from BalloonWorkbench.app.document import create
from BalloonWorkbench.gui.view3d import fit_view

SMALL = 1366, 768  # px
SIDES = {"OverlayLeft": (0, 0, 0.2, 1), "OverlayRight": (0.7, 0.2, 0.3, 0.8)}
#: What is left when one panel comes after the other.
FREE = {
    "OverlayLeft": (0.2, 1, 0, 1),
    "OverlayRight": (0.2, 0.7, 0, 1),
    "OverlayTop": (0.2, 0.7, 0, 0.8),
    "OverlayBottom": (0.2, 0.7, 0.3, 0.8),
}
SIDES |= {"OverlayTop": (0, 0, 1, 0.2), "OverlayBottom": (0.1, 0.7, 0.9, 0.3)}


def view():
    return Gui.ActiveDocument.activeView()


@pytest.fixture
def ring():
    with framed(SMALL):
        Gui.runCommand("BalloonWorkbench_Example_ring")
        hands.wait_until(lambda: App.ActiveDocument is not None)
        hands.wait(0.3)
        yield App.ActiveDocument


@pytest.fixture
def lay_over():
    """Lays an empty panel over the view, named as those of FreeCAD 1.1."""
    made = []

    def lay(name):
        window = view().graphicsView()
        panel = hands.QtWidgets.QWidget(Gui.getMainWindow())
        panel.setObjectName(name)
        corner = window.mapTo(Gui.getMainWindow(), hands.QtCore.QPoint(0, 0))
        x, y, width, height = SIDES[name]
        panel.setGeometry(
            corner.x() + int(x * window.width()),
            corner.y() + int(y * window.height()),
            int(width * window.width()),
            int(height * window.height()),
        )
        panel.setAutoFillBackground(True)
        panel.show()
        made.append(panel)

    yield lay
    for panel in made:
        panel.setParent(None)
        panel.deleteLater()


def has_overlays():
    return Gui.getMainWindow().findChild(hands.QtWidgets.QWidget, "OverlayRight") is not None


def seen(doc):
    """Left, right, bottom and top of all that is shown, in parts of the view: as FreeCAD projects it."""
    width, height = view().getSize()
    points = [point.Vector for point in doc.Balloon.Mesh.Points[::7]]
    points += [edge.firstVertex().Point for obj in (doc.Outline, doc.Pattern) for edge in obj.Shape.Edges]
    pixels = [view().getPointOnScreen(point) for point in points]
    across, up = ([pixel[axis] for pixel in pixels] for axis in (0, 1))
    return min(across) / width, max(across) / width, min(up) / height, max(up) / height


def fits(doc, free, slack=0.012):
    """All of it is in the free part, and fills that in one direction."""
    left, right, bottom, top = seen(doc)
    inside = left > free[0] - slack and right < free[1] + slack
    inside &= bottom > free[2] - slack and top < free[3] + slack
    filled = max((right - left) / (free[1] - free[0]), (top - bottom) / (free[3] - free[2]))
    return inside and 0.6 < filled <= 1.0


def test_all_that_is_shown_fills_the_view(ring):
    for camera in ("Orthographic", "Perspective"):
        view().setCameraType(camera)
        for turn in ("viewTop", "viewAxonometric"):
            getattr(view(), turn)()
            hands.wait(0.6)  # FreeCAD turns the camera slowly
            fit_view.fit_all()
            hands.wait(0.05)
            assert fits(ring, fit_view.free_part(view())), f"{camera}, {turn}"


def test_panels_over_the_view_hide_nothing(ring, lay_over):
    if has_overlays():
        pytest.skip("this FreeCAD has its own")
    view().viewTop()
    hands.wait(0.6)
    for side, free in FREE.items():
        lay_over(side)
        for camera in ("Orthographic", "Perspective"):
            view().setCameraType(camera)
            fit_view.fit_all()
            hands.wait(0.05)
            assert fit_view.free_part(view()) == pytest.approx(free, abs=0.005)
            assert fits(ring, free), f"{camera}, {side}"
    hands.screenshot("fit")


def test_a_panel_that_opens_does_not_hide_what_was_there(ring, lay_over):
    view().viewTop()
    hands.wait(0.6)
    fit_view.fit_all()
    if not has_overlays():
        lay_over("OverlayRight")
    ring.Balloon.ViewObject.Proxy.doubleClicked(ring.Balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.7)
    hands.wait_until(lambda: seen(ring)[1] < fit_view.free_part(view())[1] + 0.012, 20)
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def test_a_view_that_shows_a_part_stays(ring, lay_over):
    """Who looks closely at something goes on doing so when a panel opens."""
    fit_view.fit_all()
    camera = view().getCameraNode()
    camera.height.setValue(0.2 * camera.height.getValue())
    before = camera.height.getValue(), camera.position.getValue().getValue()
    if not has_overlays():
        lay_over("OverlayRight")
    ring.Balloon.ViewObject.Proxy.doubleClicked(ring.Balloon.ViewObject)
    hands.wait_until(hands.panel_is_seen)
    hands.wait(0.7)
    camera = view().getCameraNode()
    assert (camera.height.getValue(), camera.position.getValue().getValue()) == before
    hands.press("Cancel")
    hands.wait_until(hands.panel_is_closed)


def test_an_empty_document_and_one_that_is_closed(doc):
    fit_view.fit_all()
    create.make(doc)
    fit_view.fit_all()
    fit_view.fit_all(None)
    assert view().getCameraNode().position.getValue().length() < 1e6
    App.closeDocument(doc.Name)
    fit_view.fit_all()
    assert not App.listDocuments()
