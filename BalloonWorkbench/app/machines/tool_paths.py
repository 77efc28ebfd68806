# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern's moves on a machine as jobs of FreeCAD's workbench Path (CAM since 1.0)."""

from __future__ import annotations

import tempfile
from contextlib import contextmanager
from pathlib import Path

import FreeCAD as App

from BalloonWorkbench.app import host
from BalloonWorkbench.app.engine.export import check_for, machine_of, sheet
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.units import to_mm

#: What a post processor of FreeCAD says itself: units, modes, the end.
_OF_POSTS = ("G17", "G21", "G40", "G49", "G54", "G64", "G90", "G91.1", "G94", "M2")
#: How thick the film is shown [mm], and the width of a tool that has none of its own.
_FILM, _TOOL = 0.1, 0.2
#: How thick the board below the film is in the stock, as a part of its longer side: FreeCAD's simulator shows
#: nothing that is thinner than its grid, of 1 % of that side at most.
_BOARD = 0.02
_CLEAR = 80  # %: the film lies at the origin, as the machine has it, and a hot tip moves below its upper face


def tool_paths(
    pattern_obj, machine_name: str, bed=None, oversize: str = "refuse", tabs=None, tabs_below=None
) -> list:
    """New jobs, one for each film, with the moves that `export_for` writes for a machine that reads G-code.

    Raises ExportError, and makes none, when the machine cannot make the pattern, or this FreeCAD has no such
    workbench.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = job_file(pattern_obj, folder, machine_name, bed, oversize, tabs, tabs_below)
        return add_jobs(pattern_obj.Document, path)


def job_file(
    pattern_obj, folder, machine_name: str, bed=None, oversize: str = "refuse", tabs=None, tabs_below=None
) -> Path:
    """The jobs as a document in a folder, for `add_jobs`. ExportError.

    FreeCAD opens and closes undo steps while it makes a job: in a document of its own they do no harm.
    """
    from BalloonWorkbench.app.border import hooks
    from BalloonWorkbench.core.machines.preflight import ERROR
    from BalloonWorkbench.core.machines.toolpaths import draw
    from BalloonWorkbench.core.machines.writers.moves import moves
    from BalloonWorkbench.core.options.making import SPLIT

    if oversize == SPLIT:
        raise ExportError("Tool paths are not split over beds: write the G-code, or choose a larger bed.")
    made_for, pattern = machine_of(machine_name, bed, tabs, tabs_below), sheet(pattern_obj)
    for finding in check_for(pattern_obj, machine_name, bed, oversize, tabs, tabs_below):
        if finding.severity == ERROR:
            raise ExportError(finding.text)

    def drawn(_progress) -> dict:
        drawings = {stock: draw(pattern.of_stock(stock), made_for) for stock in pattern.stocks}
        return {stock: (drawing, moves(drawing, made_for)) for stock, drawing in drawings.items()}

    path = Path(folder) / "jobs.FCStd"
    parts = hooks.run_blocking("Making tool paths", drawn)
    with _scratch() as document:
        for stock, (drawing, steps) in parts.items():
            label = f"{pattern_obj.Label} {made_for.name} {stock}".strip()
            _job(document, label, drawing, made_for, steps)
        document.recompute()
        document.saveAs(str(path))
    return path


def add_jobs(document, path: Path) -> list:
    """Bring the jobs of a file into a document; returns them."""
    before = {obj.Name for obj in document.Objects}
    with host.report_view_kept():
        document.mergeProject(str(path))
    jobs = [obj for obj in document.Objects if obj.Name not in before and hasattr(obj, "Operations")]
    for job in jobs:
        job.Proxy.obj = job  # its operations ask for it; a job that is merged is not told
        for model in job.Model.Group if job.ViewObject is not None else ():
            for film in (model, *model.Objects):  # a clone, and the film itself
                film.ViewObject.Transparency = _CLEAR
    return jobs


def _job(document, label: str, drawing, made_for, steps) -> None:
    """The job of one film that lies with its corner at the origin, its upper face at 0."""
    film = document.addObject("Part::Box", "Film")
    film.Label = f"{label} film"
    film.Length, film.Width, film.Height = drawing.width, drawing.height, _FILM
    film.Placement.Base.z = -_FILM
    film.recompute()
    job = host.cam_job(film)
    job.Label = label
    if made_for.tool.turning_axis:
        job.Description = (
            f"The G-code turns the tool by {made_for.tool.turning_axis}. FreeCAD takes that axis for one that"
            " turns the work: its 3D view shows the path turned."
        )
    for side in ("Xneg", "Xpos", "Yneg", "Ypos", "Zpos"):
        setattr(job.Stock, f"Ext{side}", 0.0)
    job.Stock.ExtZneg = _BOARD * max(drawing.width, drawing.height)
    (controller,) = job.Tools.Group
    controller.Tool.Diameter = max(to_mm(made_for.kerf), _TOOL)
    controller.Tool.SpindleDirection = "None"  # the moves themselves start and stop what turns or burns
    moved = [(step.name, step.words) for step in steps if step.name not in ("", *_OF_POSTS)]
    host.cam_operation(job, moved).Label = f"{label} moves"


@contextmanager
def _scratch():
    """A document that nobody sees; FreeCAD's workbench makes its objects in the active one."""
    before = App.ActiveDocument
    document = App.newDocument("Jobs", hidden=True, temp=True)
    App.setActiveDocument(document.Name)
    try:
        yield document
    finally:
        App.closeDocument(document.Name)
        if before is not None:
            App.setActiveDocument(before.Name)
