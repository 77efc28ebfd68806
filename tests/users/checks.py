# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must hold at every step of a user, whatever is on the screen; each check tells faults in sentences."""

import gc
import itertools
import re

import FreeCAD as App
import FreeCADGui as Gui
import hands
import numpy as np

from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.gui.paint import window as paint_window
from BalloonWorkbench.gui.panels.widgets.narrow import ElidedCombo, ElidedLabel

QtCore, QtGui, QtWidgets = hands.QtCore, hands.QtGui, hands.QtWidgets

_PARKED = -400  # px; FreeCAD 1.0 keeps docks that are not in use to the left of the screen
_SLACK = 2  # px that styles give or take
_CONTRAST = 3.0  # of text, WCAG 2.1 for large and graphical parts
_READ = 0.65  # of the entry of a choice that shows an ellipsis, and all of it in its tooltip
_STROKE = 6  # px that a letter has at least
_MOST = 8  # faults of a kind that are told for one step
#: Widgets whose parts lie over each other as Qt and FreeCAD made them.
_WHOLE = (
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QComboBox,
    QtWidgets.QLineEdit,
    QtWidgets.QAbstractScrollArea,
    QtWidgets.QTabWidget,
    QtWidgets.QTabBar,
    QtWidgets.QDockWidget,
    QtWidgets.QDialogButtonBox,
)
#: Where a file goes, which the user has chosen and has to know.
_PLACES = ("File", "FileFolder", "AssemblyFile", "AssemblyFileFolder")
_SAYING = (
    QtWidgets.QLabel,
    QtWidgets.QAbstractButton,
    QtWidgets.QComboBox,
    QtWidgets.QLineEdit,
    QtWidgets.QAbstractSpinBox,
)
#: What no text may have in it.
WRONG = {
    "a number with an exponent": r"\d[eE][+-]?\d+\b",
    # the user's own folder and what he has typed: of test.sh and of pytest
    "the address of a file": r"file:|\bqrc:|"
    r"(?<![\w.])/(?!tmp/(?:pytest|tmp\.))(?:work|usr|root|home|tmp|opt)/\S+",
    "no number": r"\b(?:nan|inf)\b",
    "a placeholder": r"\{\w*\}|%[1-9sdn]\b",
    "one of many": r"(?<![\d.,/])1 (?:holes|shapes|pieces|files|sheets|pages|places|panels|parts|balloons)\b",
    "a length of nothing": r"(?<![\d.,])-?0(?:[.,]0+)? (?:x 0(?:[.,]0+)? )?(?:mm|cm|m|in|g|kg|l|ml)\b",
}


def roots():
    """What is ours on the screen: the paint window, panels, boxes; no panel of what FreeCAD edits."""
    edited = Gui.ActiveDocument is not None and Gui.ActiveDocument.getInEdit() is not None
    panels = [
        widget
        for widget in hands.visible(QtWidgets.QWidget)
        if widget.metaObject().className() == "Gui::TaskView::TaskView" and not edited
    ]
    paint = [window for window in paint_window._open if window.isVisible()]
    return [*panels, *paint, *hands.visible(QtWidgets.QDialog)]


def ours():
    """All visible widgets in these, with the roots; each knows its ancestors, the nearest first, as `above`.

    Not by `parentWidget`: PySide takes the shells of children away with that of a parent.
    """
    tops, everything = roots(), hands.visible(QtWidgets.QWidget)
    parts = [w for w in everything if any(top is w or top.isAncestorOf(w) for top in tops)]
    chosen = [w for w in parts if w.mapToGlobal(QtCore.QPoint(0, 0)).x() > _PARKED]
    above.clear()
    for widget in chosen:
        line = [w for w in everything if w is not widget and w.isAncestorOf(widget)]  # Qt counts itself in
        above[widget] = sorted(line, key=lambda w: -sum(other.isAncestorOf(w) for other in line))
    return chosen


above: dict = {}


def parent_of(widget):
    """The widget that it lies in; None for a window."""
    return above[widget][0] if above[widget] and not widget.isWindow() else None


def name(widget):
    kind = type(widget).__name__ if type(widget).__module__.startswith("Balloon") else ""
    said = text_of(widget)[:40]
    return f"{widget.objectName() or kind or widget.metaObject().className()}{f' {said!r}' if said else ''}"


def text_of(widget):
    for method in ("text", "currentText", "title"):
        if hasattr(widget, method):
            said = getattr(widget, method)()
            return said if isinstance(said, str) else ""
    return ""


def overlaps(widgets):
    """Widgets of one parent that lie on each other, and those that something else lies on."""
    families = {}
    for widget in widgets:
        parent = parent_of(widget)
        if parent is None or isinstance(parent, _WHOLE):
            continue
        if parent.metaObject().className().startswith(("Gui::", "QSint::")):
            continue
        families.setdefault(parent, []).append(widget)
    for children in families.values():
        for one, other in itertools.combinations(children, 2):
            both = one.geometry() & other.geometry()
            if both.width() > _SLACK and both.height() > _SLACK:
                yield f"{name(one)} and {name(other)} lie on each other"
    for widget in widgets:
        if isinstance(widget, _SAYING) and not isinstance(parent_of(widget), _WHOLE):
            yield from _covered(widget)


def _covered(widget):
    if isinstance(QtWidgets.QApplication.activePopupWidget(), QtWidgets.QWidget):
        return
    box = widget.visibleRegion().boundingRect()
    if box.width() < 4 or box.height() < 4:
        return
    for x, y in ((0.1, 0.5), (0.5, 0.5), (0.9, 0.5)):
        point = QtCore.QPoint(int(box.left() + x * box.width()), int(box.top() + y * box.height()))
        top = QtWidgets.QApplication.widgetAt(widget.mapToGlobal(point))
        if top is None or widget.isAncestorOf(top) or top.isAncestorOf(widget):
            continue
        if not any(dialog.isAncestorOf(top) for dialog in hands.visible(QtWidgets.QDialog)):
            yield f"{name(widget)} is covered by {name(top)}"
            return


def cut_off(widgets):
    """What is smaller than what it says, off the screen, or only reached by scrolling to the side."""
    for widget in widgets:
        area = _scrolled_by(widget)
        yield from _off_screen(widget) if area is None else _beside(widget, area)
        if isinstance(widget, _SAYING):
            yield from _text_cut_off(widget)
        if isinstance(widget, QtWidgets.QTableWidget):
            yield from _cells_cut_off(widget)
        arrows = [w for w in widgets if isinstance(w, QtWidgets.QToolButton) and parent_of(w) is widget]
        if isinstance(widget, QtWidgets.QTabBar) and arrows:
            yield f"the tabs of {name(widget)} do not fit"
    bars = [bar for bar in widgets if isinstance(bar, QtWidgets.QScrollBar)]
    for bar in bars:
        if bar.orientation() == QtCore.Qt.Horizontal:
            yield f"{name(above[bar][1])} scrolls to the side"
    scrolling = [above[bar][1] for bar in bars if bar.orientation() == QtCore.Qt.Vertical]
    for outer, inner in itertools.permutations(scrolling, 2):
        if outer.isAncestorOf(inner) and isinstance(inner, QtWidgets.QScrollArea):
            yield f"{name(inner)} scrolls inside {name(outer)}, which scrolls"


def _cells_cut_off(table):
    """Cells and headings of a table that cannot be read."""
    for column in range(table.columnCount()):
        if table.isColumnHidden(column):
            continue
        heading = table.horizontalHeaderItem(column)
        cells = [heading] if heading is not None and heading.toolTip() != heading.text() else []
        cells += filter(None, (table.item(row, column) for row in range(table.rowCount())))
        for cell in cells:
            needs = table.fontMetrics().horizontalAdvance(cell.text())
            if needs > table.columnWidth(column) + _SLACK:
                yield f"a cell of {name(table)} has {table.columnWidth(column)} px for {cell.text()!r}"
                break


def _off_screen(widget):
    screen = QtWidgets.QApplication.primaryScreen().geometry().adjusted(-_SLACK, -_SLACK, _SLACK, _SLACK)
    box = QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())
    if not screen.contains(box):
        yield f"{name(widget)} is off the screen: {box.left()}, {box.top()}, {box.right()}, {box.bottom()}"
        return
    least = min(widget.minimumSizeHint().height(), widget.maximumHeight())
    is_part = parent_of(widget) is None or isinstance(parent_of(widget), _WHOLE)
    if not is_part and widget.height() + _SLACK < least:
        yield f"{name(widget)} is {widget.height()} px high and needs {least}"


def _beside(widget, area):
    """Outside of what scrolls; area: (that, its view port)."""
    if widget.metaObject().className().startswith(("Gui::", "QSint::")):
        return  # FreeCAD's frames are as wide as what we put in
    left = widget.mapTo(area[1], QtCore.QPoint(0, 0)).x()
    right = left + widget.width() - area[1].width()
    if left < -_SLACK or right > _SLACK:
        yield f"{name(widget)} is cut off at the side by {max(-left, right)} px"


def _scrolled_by(widget):
    for inner, outer in itertools.pairwise((widget, *above[widget])):
        if isinstance(outer, QtWidgets.QAbstractScrollArea):
            return (outer, inner) if inner.objectName() == "qt_scrollarea_viewport" else None
    return None


def _text_cut_off(widget):
    """Words that have no room in their widget."""
    said = text_of(widget).replace("&", "")
    if not said or "<" in said:
        return
    if isinstance(widget, ElidedLabel):
        if not widget.toolTip():
            yield f"{name(widget)} says nowhere what it leaves out"
        return
    if isinstance(widget, QtWidgets.QLabel) and widget.wordWrap():
        lines = widget.heightForWidth(widget.width())
        if lines > widget.height() + _SLACK:
            yield f"{name(widget)} has {widget.height()} px for lines of {lines}"
    needs, has = _needed_width(widget, said), _width_of_text(widget)
    if needs > has + _SLACK:
        yield f"{name(widget)} has {has} px for a text of {needs}"


def _needed_width(widget, said):
    """Pixels that a text needs in its widget."""
    wraps = isinstance(widget, QtWidgets.QLabel) and widget.wordWrap()
    parts = re.split(r"(?<=[/-])|\s", said) if wraps else said.split("\n")
    needs = max(widget.fontMetrics().horizontalAdvance(part) for part in parts or [""])
    if isinstance(widget, ElidedCombo):
        return needs * _READ
    if isinstance(widget, QtWidgets.QPushButton) and not widget.icon().isNull():
        return needs + widget.iconSize().width()
    return needs


def _width_of_text(widget):
    """Pixels that a widget has for its text; no end where the text is not shown or moves along."""
    Style = QtWidgets.QStyle
    if isinstance(widget, QtWidgets.QLabel):
        return widget.contentsRect().width() - 2 * widget.margin()
    if isinstance(widget, (QtWidgets.QCheckBox, QtWidgets.QRadioButton)):
        option = QtWidgets.QStyleOptionButton()
        option.initFrom(widget)
        return widget.style().subElementRect(Style.SE_CheckBoxContents, option, widget).width()
    if isinstance(widget, QtWidgets.QComboBox):
        option = QtWidgets.QStyleOptionComboBox()
        option.initFrom(widget)
        field = Style.CC_ComboBox, option, Style.SC_ComboBoxEditField, widget
        return widget.style().subControlRect(*field).width()
    if isinstance(widget, QtWidgets.QToolButton) and not widget.icon().isNull():
        only = widget.toolButtonStyle() == QtCore.Qt.ToolButtonIconOnly
        return float("inf") if only else widget.contentsRect().width()
    if isinstance(widget, QtWidgets.QLineEdit):
        return float("inf")
    if isinstance(widget, QtWidgets.QAbstractSpinBox):
        line = widget.findChild(QtWidgets.QLineEdit)
        return line.width() - line.textMargins().left() - line.textMargins().right()
    return widget.contentsRect().width()


def texts(widgets):
    """(where, text) of all that is said: labels, fields, lists, tooltips, our menu, the status bar."""
    main = Gui.getMainWindow()
    for widget in widgets:
        if widget.objectName() not in _PLACES:
            yield from _texts_of(widget)
    for action in main.findChildren(QtGui.QAction if hasattr(QtGui, "QAction") else QtWidgets.QAction):
        if action.objectName().startswith("BalloonWorkbench_"):
            yield "a command", " ".join((action.text(), action.toolTip(), action.statusTip()))
    yield "status bar", main.statusBar().currentMessage()
    for obj in App.ActiveDocument.Objects if App.ActiveDocument is not None else ():
        yield "tree", obj.Label


def _texts_of(widget):
    where, said = name(widget), text_of(widget)
    if said and _is_said(widget, said):
        yield where, said
    if widget.toolTip():
        yield f"tooltip of {where}", widget.toolTip()
    if isinstance(widget, QtWidgets.QListWidget):
        yield from ((where, widget.item(row).text()) for row in range(widget.count()))
    if isinstance(widget, QtWidgets.QComboBox):
        yield from ((f"entry of {where}", widget.itemText(row)) for row in range(widget.count()))


def _is_said(widget, text):
    """By us: a file that is typed is the user's own, and a setting may be nothing."""
    if isinstance(widget, QtWidgets.QLineEdit):
        return not widget.objectName().startswith("qt_") and "/" not in text
    return not isinstance(widget, QtWidgets.QAbstractSpinBox) or widget.objectName() in ("Width", "Height")


def wrong_words(widgets):
    told = set()
    for where, said in texts(widgets):
        for what, pattern in WRONG.items():
            hit = re.search(pattern, said)
            if hit and (where, what) not in told:
                told.add((where, what))
                yield f"{where} has {what}: {said[max(hit.start() - 30, 0) : hit.end() + 30]!r}"


def report_view():
    """FreeCAD's report view came up."""
    for dock in hands.visible(QtWidgets.QDockWidget):
        if dock.objectName() == "Report view" and not dock.visibleRegion().isEmpty():
            yield "the report view is open"


def lying_on_each_other():
    """Visible results whose boxes overlap, seen from above; mm."""
    boxes = {}
    for obj in App.ActiveDocument.Objects if App.ActiveDocument is not None else ():
        kind = type(getattr(obj, "Proxy", None)).__name__
        if obj.ViewObject is None or not obj.ViewObject.Visibility or kind not in _BODIES:
            continue
        box = (obj.Mesh if hasattr(obj, "Mesh") else obj.Shape).BoundBox
        if box.isValid() and box.XLength > 0:
            boxes[obj.Label, obj.Name] = box
    for (one, a), (other, b) in itertools.combinations(boxes.items(), 2):
        x = min(a.XMax, b.XMax) - max(a.XMin, b.XMin)
        y = min(a.YMax, b.YMax) - max(a.YMin, b.YMin)
        if x > 0.01 and y > 0.01:
            yield f"{one[0]} and {other[0]} overlap by {x:.0f} x {y:.0f} mm"


_BODIES = {"BalloonProxy", "PatternProxy", "FilmSheetProxy", "ArtworkProxy"}


def faint(image, widgets):
    """Texts that can hardly be read on the picture of the screen."""
    ratio = QtWidgets.QApplication.primaryScreen().devicePixelRatio()
    for widget in widgets:
        if not isinstance(widget, (QtWidgets.QLabel, QtWidgets.QAbstractButton, QtWidgets.QComboBox)):
            continue
        if not re.search(r"\w", text_of(widget)) or not widget.isEnabled():
            continue
        if isinstance(widget, QtWidgets.QAbstractButton) and widget.underMouse():
            continue  # as the theme lights it up
        top = QtWidgets.QApplication.widgetAt(widget.mapToGlobal(widget.rect().center()))
        if isinstance(top, QtWidgets.QWidget) and top.window() is not widget.window():
            continue  # a box lies over it
        seen = widget.visibleRegion().boundingRect()
        if seen.width() < 8 or seen.height() < max(8, 0.6 * widget.height()):
            continue  # scrolled out of sight, with the letters perhaps
        at = widget.mapToGlobal(seen.topLeft())
        box = QtCore.QRect(at * ratio, seen.size() * ratio).adjusted(1, 1, -1, -1) & image.rect()
        ratio_here = contrast(pixels(image.copy(box))[..., :3])
        if ratio_here < _CONTRAST:
            yield f"{name(widget)} has a contrast of {ratio_here:.1f}"


def contrast(rgb):
    """Of the background (h, w, 3) and what is farthest from it, as WCAG 2.1 has it."""
    flat = rgb.reshape(-1, 3)
    colours, counts = np.unique(flat, axis=0, return_counts=True)
    light = np.where(colours <= 10, colours / 255 / 12.92, ((colours / 255 + 0.055) / 1.055) ** 2.4)
    light = light @ (0.2126, 0.7152, 0.0722)
    ground = light[counts.argmax()]
    ratios = (np.maximum(light, ground) + 0.05) / (np.minimum(light, ground) + 0.05)
    often = np.repeat(ratios, np.minimum(counts, _STROKE))
    return float(np.sort(often)[-min(_STROKE, len(often))])


def all_of(image):
    """Every fault of the screen as it is."""
    collecting = gc.isenabled()  # not while a worker runs
    gc.disable()  # see hands.visible
    try:
        return list(_all_of(image, ours()))
    finally:
        if collecting:
            gc.enable()


def _all_of(image, widgets):
    kinds = {
        "overlap": overlaps(widgets),
        "cut off": cut_off(widgets),
        "words": wrong_words(widgets),
        "report view": report_view(),
        "3D": lying_on_each_other(),
        "contrast": faint(image, widgets),
    }
    for kind, faults in kinds.items():
        for fault in list(dict.fromkeys(faults))[:_MOST]:
            yield f"{kind}: {fault}"
