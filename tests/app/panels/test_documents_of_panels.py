# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of many panels from the command line; balloons of all kinds lie beside each other."""

import json

import FreeCAD as App
import numpy as np
import pytest

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document.fcstd import save_fcstd
from BalloonWorkbench.app.document.parts import parts_of
from BalloonWorkbench.app.engine import bag_result
from BalloonWorkbench.app.engine.bag_solve import BagRequest
from BalloonWorkbench.core.bag_job import make_bags
from BalloonWorkbench.core.bags.read_bag import bag_json
from BalloonWorkbench.core.bodies.ready import ready_bag
from BalloonWorkbench.core.job import Settings
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions

PROFILE = {"unit": "mm", "profile": [[0, 0], [100, 80], [60, 200], [0, 260]]}
SQUARE = {"unit": "mm", "outer": [[0, 0], [120, 0], [120, 120], [0, 120]], "holes": []}


@pytest.fixture
def no_solver(monkeypatch):
    def solve(self, progress=None):
        raise AssertionError("solved although nothing changed")

    monkeypatch.setattr(BagRequest, "solve", solve)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "content", "settings"),
    [
        ("GoredBody", json.dumps(PROFILE).encode(), Settings(mesh_size=0.04, body=BodyOptions(gores=5))),
        ("Bag", bag_json(ready_bag("tetrahedron", edge=0.2)), Settings(mesh_size=0.03)),
        ("Outline", json.dumps(SQUARE).encode(), Settings(mesh_size=0.02, side_band=BandOptions(band=0.04))),
    ],
    ids=["gores", "bag", "band"],
)
def test_the_document_of_a_job(kind, content, settings, tmp_path, no_solver):
    """Its objects hold what the command line has designed; nothing is solved again."""
    drawing = tmp_path / "drawing.json"
    drawing.write_bytes(content)
    (design,) = make_bags(drawing, settings).designs
    path = tmp_path / "balloon.FCStd"
    save_fcstd(path, drawing, settings, [design])
    document = App.openDocument(str(path))
    try:
        made = parts_of(document.Balloon)
        assert made.outline.Name == kind
        for obj in made:
            obj.touch()
        document.recompute()
        assert [obj.Status for obj in made] == [status.READY] * 3
        assert made.balloon.Volume.getValueAs("m^3").Value == pytest.approx(design.inflation.volume)
        assert made.balloon.PanelCount == len(design.bag.panels)
    finally:
        App.closeDocument(document.Name)


def test_balloons_of_all_kinds_lie_beside_each_other(doc, tmp_path):
    path = tmp_path / "pear.json"
    path.write_text(json.dumps(PROFILE))
    made = [
        BalloonWorkbench.from_panels(doc, "Tetrahedron", mesh_size=60),
        BalloonWorkbench.from_profile(doc, path, gores=4, mesh_size=60),
        BalloonWorkbench.from_panels(doc, "Cone", mesh_size=60),
    ]
    boxes = []
    for parts in made:
        box = App.BoundBox(parts.outline.Shape.BoundBox)
        box.add(parts.balloon.Mesh.BoundBox)
        boxes += [box, parts.pattern.Shape.BoundBox]
    assert [obj.Status for parts in made for obj in parts] == [status.READY] * 9
    assert not [
        (a, b)
        for k, a in enumerate(boxes)
        for b in boxes[:k]
        if a.XMin < b.XMax and b.XMin < a.XMax and a.YMin < b.YMax and b.YMin < a.YMax
    ]


def test_copies_of_a_balloon_are_alive(doc):
    made = BalloonWorkbench.from_panels(doc, "Tetrahedron", mesh_size=60)
    copied = doc.copyObject(made.pattern, True)
    doc.recompute()
    parts = parts_of(copied)
    assert parts.outline != made.outline
    assert [obj.Status for obj in parts] == [status.READY] * 3
    parts.outline.Edge = 400
    doc.recompute()
    assert parts.balloon.Volume.Value > 1.5 * made.balloon.Volume.Value


def test_a_goal_decides_the_size(doc):
    made = BalloonWorkbench.from_panels(
        doc, "Tetrahedron", edge=100, mesh_size=60, size_goal="Volume", goal_volume="5 l"
    )
    assert made.balloon.Volume.getValueAs("l").Value == pytest.approx(5, rel=0.01)
    assert made.outline.Edge.Value == pytest.approx(100)
    design, _ = bag_result.stored(made.balloon)
    edges = np.linalg.norm(np.diff(design.source.panels[0].outer, axis=0), axis=1)
    # of a tetrahedron of film that hardly stretches, by its edge cubed: docs/validation.md
    assert edges == pytest.approx((0.005 / 0.17296) ** (1 / 3), rel=0.03)
    assert made.pattern.Status == status.READY
