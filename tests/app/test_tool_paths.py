# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern in FreeCAD's workbench Path or CAM: its own post processor writes the moves of our G-code."""

import importlib
import json

import FreeCAD as App
import numpy as np
import pytest
import sketches
from gcode_reader import Controller

import BalloonWorkbench
from BalloonWorkbench.app import artwork
from BalloonWorkbench.app.document import arrange, create
from BalloonWorkbench.app.engine.export import export_for
from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.machines.machine import FOLDER

#: Where FreeCAD 0.20, 1.0 and 1.1 have them.
PLACES = ("", "PathScripts.post.", "Path.Post.scripts.")


@pytest.fixture
def own(tmp_path, monkeypatch):
    """Machines with all that a file needs: a laser and a hot tip on GRBL."""
    data = json.loads((FOLDER / "gcode-grbl.json").read_text(encoding="utf-8"))
    tools = {
        "beam": {**data["tool"], "feed_mm_min": 600, "power_percent": 40},
        "tip": {"kind": "hot-tip", "feed_mm_min": 240, "depth_mm": 0.2, "dwell_s": 0.5},
    }
    folder = tmp_path / "machines"
    folder.mkdir()
    for name, tool in tools.items():
        layers = {"SEAL": {}} if name == "tip" else data["layers"]
        own = {**data, "name": name, "tool": tool, "layers": layers, "bed_mm": None}
        (folder / f"{name}.json").write_text(json.dumps(own))
    turned = json.loads((FOLDER / "gcode-linuxcnc.json").read_text(encoding="utf-8"))
    wheel = {"kind": "hot-wheel", "feed_mm_min": 240, "depth_mm": 0.2, "turning_axis": "C"}
    turned |= {"name": "wheel", "tool": wheel, "layers": {"SEAL": {}}, "bed_mm": None}
    (folder / "wheel.json").write_text(json.dumps(turned))
    monkeypatch.setenv("BALLOON_MACHINES", str(folder))


def post_of(controller):
    import Path  # noqa: F401  # which is where the posts of 1.0 are

    for place in PLACES:
        for name in (f"{controller}_post", f"{controller}_legacy_post"):
            try:
                return importlib.import_module(place + name)
            except ImportError:
                continue
    pytest.fail(f"this FreeCAD has no post processor for {controller}")


@pytest.mark.parametrize(("name", "controller"), [("beam", "grbl"), ("tip", "grbl"), ("wheel", "linuxcnc")])
def test_freecads_post_processor_writes_the_same_moves(doc, own, tmp_path, name, controller):
    made = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=20, correct=False)
    before = {obj.Name for obj in doc.Objects}
    (job,) = BalloonWorkbench.tool_paths(made.pattern, name)
    (paths,) = job.Operations.Group
    assert paths.TypeId.startswith("Path::Feature")
    assert (paths.Active, paths.ToolController) == (True, job.Tools.Group[0]), "as its simulator asks"
    assert [obj.Label for obj in doc.Objects if obj.Name not in before and not obj.isValid()] == []
    arcs = [each for each in paths.Path.Commands if each.Name in ("G2", "G3")]
    assert arcs, "or nothing is tried here"
    if name == "tip":
        assert all(None not in (each.x, each.y, each.z) for each in arcs), (
            "as the simulator of 0.20 needs them"
        )
    film, lines = job.Stock.Shape.BoundBox, paths.Path.BoundBox
    assert film.ZMax == pytest.approx(0.0, abs=1e-6)
    if name != "wheel":  # FreeCAD takes its axis for one that turns the work
        assert job.Description == ""
        assert film.XMin <= lines.XMin < lines.XMax <= film.XMax
        assert film.YMin <= lines.YMin < lines.YMax <= film.YMax
    else:
        assert "turns the work" in job.Description
    started = [each for each in job.Tools.Group[0].Path.Commands if each.Name in ("M3", "M4")]
    assert not started, "no beam is on before the moves"
    written = tmp_path / "post.gcode"
    post_of(controller).export([*job.Tools.Group, paths], str(written), "--no-show-editor --no-header")
    ours = Controller(controller, name == "beam").read(export_for(made.pattern, name, tmp_path).read_bytes())
    read = Controller(controller, name == "beam").read(written.read_bytes())
    assert len(read.strokes) == len(ours.strokes) > 0
    for one, other in zip(read.strokes, ours.strokes, strict=True):
        assert one.line.shape == other.line.shape
        assert np.abs(one.line - other.line).max() < 0.01
        assert one.feeds == pytest.approx(other.feeds, rel=1e-3)
        assert one.angles == pytest.approx(other.angles, abs=0.01)
        assert (one.power, one.height, one.dwell) == pytest.approx((other.power, other.height, other.dwell))
    assert [way for way, _ in read.travel] == pytest.approx([way for way, _ in ours.travel], abs=0.01)


def test_freecads_simulator_shows_the_film_and_where_it_is_welded(doc, own):
    import PathSimulator

    made = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=20, correct=False)
    (job,) = BalloonWorkbench.tool_paths(made.pattern, "tip")
    box = job.Stock.Shape.BoundBox
    simulator = PathSimulator.PathSim()
    for percent in (1.0, 0.1):  # coarsest and finest, as its slider has them
        simulator.BeginSimulation(job.Stock.Shape, 0.01 * percent * max(box.XLength, box.YLength))
        whole, _ = simulator.GetResultMesh()
        assert whole.CountFacets > 0
    simulator.SetToolShape(job.Tools.Group[0].Tool.Shape, 0.005)
    place = App.Placement(App.Vector(0.0, 0.0, box.ZMax), App.Rotation())
    for command in job.Operations.Group[0].Path.Commands:
        place = simulator.ApplyCommand(place, command)
    _, pressed = simulator.GetResultMesh()
    assert pressed.CountFacets > 0
    assert pressed.BoundBox.ZMin == pytest.approx(-0.2, abs=0.01), "the tip is 0.2 mm deep"


def test_each_film_has_a_job_in_the_document_of_its_pattern(doc, own):
    """Foil and valve, while another document is the active one; twice, and recomputed."""
    knife = BalloonWorkbench.from_sketch(
        doc, sketches.ring(doc), mesh_size=20, mode="Inflate as drawn", film="pe",
        intake_kind="Self-sealing film valve",
    )  # fmt: skip
    other = App.newDocument("Other")
    for _ in range(2):
        jobs = BalloonWorkbench.tool_paths(knife.pattern, "beam")
        assert [len(job.Operations.Group) for job in jobs] == [1, 1]
        assert jobs[0].Stock.Shape.BoundBox.XLength > jobs[1].Stock.Shape.BoundBox.XLength > 40.0
    assert App.ActiveDocument == other
    assert not other.Objects
    App.closeDocument(other.Name)
    for obj in doc.Objects:
        obj.touch()
    doc.recompute()
    assert [obj.Label for obj in doc.Objects if not obj.isValid()] == []


def test_what_is_made_beside_a_job_finds_its_place(doc, own):
    """Paths lie nowhere in FreeCAD 0.20: they are no obstacle."""
    made = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=20, correct=False)
    BalloonWorkbench.tool_paths(made.pattern, "beam")
    print_of = artwork.make(made.pattern)
    other = create.balloon_from_sketch(doc, sketches.rectangle(doc), mesh_size=20, correct=False)
    doc.recompute()
    beside = [obj.Shape.BoundBox for obj in (made.pattern, other.pattern)]
    assert not beside[0].intersect(beside[1])
    assert print_of.Pattern == made.pattern
    assert len(list(arrange.boxes(doc.Objects, App.Placement()))) > 4


def test_what_cannot_be_made_leaves_no_object(doc, own):
    made = create.balloon_from_sketch(doc, sketches.ring(doc), mesh_size=20, correct=False)
    before = len(doc.Objects)
    for name, text in (("gcode-grbl", "feed and power"), ("lightburn", "reads no G-code")):
        with pytest.raises(ExportError, match=text):
            BalloonWorkbench.tool_paths(made.pattern, name)
    assert len(doc.Objects) == before
