# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place that knows the differences between FreeCAD's versions and its quickest ways in."""

from __future__ import annotations

import io
from contextlib import contextmanager

import FreeCAD as App

from BalloonWorkbench.core.errors import ExportError


def qt():
    """QtCore, QtGui and QtWidgets of the running FreeCAD (0.20 keeps the widgets in QtGui)."""
    from PySide import QtCore, QtGui

    try:
        from PySide import QtWidgets
    except ImportError:
        QtWidgets = QtGui
    return QtCore, QtGui, QtWidgets


_REPORT = "ReportOutput"  # FreeCAD's name of the report view
#: What a view provider says has changed when its colour has: the second one since 1.0.
COLOUR_PROPERTIES = ("ShapeColor", "ShapeAppearance")


def has_screen() -> bool:
    """FreeCAD runs with its window."""
    return bool(App.GuiUp)


def panels_are_hidden(window) -> bool:
    """Open panels are not seen: from 1.1 on they lie over a 3D view, and are hidden where there is none."""
    widgets = qt()[2]
    dock = window.findChild(widgets.QDockWidget, "Tasks")
    while dock is not None and dock.metaObject().className() != "Gui::OverlayTabWidget":
        dock = dock.parentWidget()
    return dock is not None and bool(dock.isHidden())


def syncs_views() -> bool:
    """Unless the user says otherwise, the 3D view of what is selected comes to the front: from 1.0 on."""
    return int(App.Version()[0]) >= 1


def is_replaying(document) -> bool:
    """The document is being restored, undone or redone: properties change, but nobody edits."""
    return bool(document.Restoring or getattr(document, "Transacting", False))


def mesh_from_arrays(positions, triangles):
    """A FreeCAD mesh from positions (n, 3) mm and triangles (m, 3).

    Goes through a binary PLY stream: it keeps the order of the vertices and is twenty times
    faster than handing over lists.
    """
    import Mesh
    import numpy as np

    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(positions)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = triangles
    stream = io.BytesIO(header.encode() + np.asarray(positions).astype("<f4").tobytes() + faces.tobytes())
    mesh = Mesh.Mesh()
    mesh.read(Stream=stream, Format="PLY")
    return mesh


def _cam(of_0_20: str, since: str):
    """A module of the workbench Path, which is CAM since 1.0, by both names; ExportError without it."""
    import importlib

    try:
        importlib.import_module("Path")  # knows where the others are
        try:
            return importlib.import_module(since)
        except ImportError:
            return importlib.import_module(of_0_20)
    except ImportError as error:
        raise ExportError("This FreeCAD lacks the workbench Path (CAM since 1.0): install it.") from error


def cam_job(model):
    """A job of the workbench Path or CAM for a model of its document, with a tool controller. ExportError."""
    job = _cam("PathScripts.PathJob", "Path.Main.Job").Create("Job", [model])
    if job.ViewObject is not None:
        job.ViewObject.Proxy = _cam("PathScripts.PathJobGui", "Path.Main.Gui.Job").ViewProvider(
            job.ViewObject
        )
        job.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
        job.ViewObject.Proxy.deleteOnReject = False  # it is no draft that a dialog may throw away
        from draftutils.todo import ToDo

        ToDo.doTasks()  # of the clone of the model, while its document is there
    return job


def cam_operation(job, steps):
    """An operation of a job, each step a G-code with its words in mm and mm/min. ExportError.

    FreeCAD counts feeds in mm/s.
    """
    operation = _cam("PathScripts.PathCustom", "Path.Op.Custom").Create("ToolPaths", None, job)
    if operation.ViewObject is not None:
        views = _cam("PathScripts.PathOpGui", "Path.Op.Gui.Base")
        kind = _cam("PathScripts.PathCustomGui", "Path.Op.Gui.Custom").Command.res
        operation.ViewObject.Proxy = views.ViewProvider(operation.ViewObject, kind)

    path, lines, place = _cam("Path", "Path"), [], {}
    for name, words in steps:
        place.update({letter: value for letter, value in words.items() if letter in "XYZ"})
        arc = name in ("G2", "G3")  # of which the simulator of 0.20 needs all three
        numbers = {**place, **words} if arc else dict(words)
        if "F" in numbers:
            numbers["F"] /= 60.0
        lines.append(path.Command(name, numbers).toGCode())
    operation.Gcode = lines
    return operation


@contextmanager
def report_view_kept():
    """FreeCAD 0.20 tells an error of its own while it merges a job: the report view is left as it is."""
    shown = has_screen() and App.Console.GetStatus(_REPORT, "Err")
    if shown:
        App.Console.SetStatus(_REPORT, "Err", False)
    try:
        yield
    finally:
        if shown:
            App.Console.SetStatus(_REPORT, "Err", True)


def has_material_system() -> bool:
    """FreeCAD keeps its materials in a system of its own, from 1.0 on."""
    import importlib.util

    return importlib.util.find_spec("Materials") is not None


def material_tree():
    """FreeCAD's widget for choosing a material: what wraps one made by its loader; None before 1.0."""
    if not has_material_system():
        return None
    import MatGui

    return getattr(MatGui, "MaterialTreeWidget", None)


def help_text(page) -> str:
    """What's this of a command, from which FreeCAD opens a page of ours (a Path).

    Its Help module takes paths; without it, as in 0.20, FreeCAD gives the text to the desktop as an address.
    """
    import importlib.util

    return page.as_posix() if importlib.util.find_spec("Help") is not None else page.as_uri()
