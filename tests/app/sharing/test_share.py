# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a document for others: the model has its vertices and its print, the page needs no network."""

import json
import re
import struct
import zlib
from dataclasses import replace

import FreeCAD as App
import numpy as np
import pytest
import sketches

import BalloonWorkbench
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.drawings.drawing_file import KEY
from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.pattern import build
from BalloonWorkbench.app.sharing.finished_job import finished_job
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.errors import BalloonError, ExportError
from BalloonWorkbench.core.geometry.polyline import bounds
from BalloonWorkbench.core.shared import sharing
from BalloonWorkbench.core.tracing.picture_file import decode


@pytest.fixture(scope="module")
def solved():
    """A balloon from a sketch, uncorrected: quick."""
    document = App.newDocument("Sharing")
    name = document.Name
    document.UndoMode = 1
    yield create.balloon_from_sketch(
        document, sketches.rectangle(document, 120, 80), mesh_size=20, correct=False
    )
    App.closeDocument(name)


def read_glb(path):
    """The scene of a GLB file, and a function that reads one of its accessors: by its own definition."""
    data = path.read_bytes()
    magic, version, length, size = struct.unpack_from("<4sIII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    scene, binary = json.loads(data[20 : 20 + size]), data[28 + size :]
    numbers = {5126: "<f4", 5125: "<u4", 5123: "<u2"}

    def read(number):
        accessor = scene["accessors"][number]
        view = scene["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        kind = numbers[accessor["componentType"]]
        return np.frombuffer(binary, kind, accessor["count"] * width, begin).reshape(-1, width)

    return scene, read


def vertices(path):
    """All places (n, 3) in a GLB file, about their middle."""
    scene, read = read_glb(path)
    parts = [part for mesh in scene["meshes"] for part in mesh["primitives"]]
    places = np.concatenate([read(part["attributes"]["POSITION"]) for part in parts]).astype(float)
    return places - 0.5 * (places.min(axis=0) + places.max(axis=0))


def missing(places, among):
    """The largest distance of a place (n, 3) from the nearest of others (m, 3), all about the same middle."""
    return np.linalg.norm(places[:, None] - among, axis=2).min(axis=1).max()


def test_the_model_has_the_vertices_of_the_document(parts, tmp_path):
    """To the single precision that a GLB has; the weld lies round them, as wide as the pattern has it."""
    found = vertices(BalloonWorkbench.share(parts, tmp_path / "balloon.glb"))
    mesh = np.array([tuple(point) for point in parts.balloon.Mesh.Topology[0]]) * 1e-3
    mesh -= 0.5 * (mesh.min(axis=0) + mesh.max(axis=0))
    assert missing(mesh, found) < 2e-6
    wider = np.ptp(found, axis=0) - np.ptp(mesh, axis=0)
    welds = 2.0 * build(parts.pattern).seal_width
    assert (0.7 * welds < wider[:2]).all()  # the corners are farthest out: there it lies across
    assert (wider[:2] < 1.01 * welds).all()
    assert wider[2] == pytest.approx(0.0, abs=1e-6)


def test_gores_too(doc, tmp_path):
    """Upright, as they are seen: the same places with their axes exchanged."""
    made = BalloonWorkbench.from_profile(
        doc, gore_length="300 mm", gores=4, mesh_size="100 mm", mode="Inflate as drawn"
    )
    found = vertices(BalloonWorkbench.share(made, tmp_path / "gores.glb"))
    inflation, _ = film_result.stored(made.balloon)
    own = inflation.positions[:, [0, 2, 1]] * (1.0, 1.0, -1.0)
    own = own - 0.5 * (own.min(axis=0) + own.max(axis=0))
    assert missing(own, found) < 2e-6
    assert missing(found, own) < 2e-6
    page = BalloonWorkbench.share(made, tmp_path / "gores.html").read_text(encoding="utf-8")
    assert page.count("<path") > 3


def test_print_and_ground(parts, picture, tmp_path, monkeypatch):
    """What is printed is on the model and in the picture, left and right, on each kind of ground."""
    monkeypatch.setattr(sharing, "_LARGE", (320, 240))
    BalloonWorkbench.artwork(parts.pattern, picture=str(picture), resolution=50)
    scene, _ = read_glb(BalloonWorkbench.share(parts, tmp_path / "printed.glb"))
    assert len(scene["images"]) == 1
    white = decode(BalloonWorkbench.share(parts, tmp_path / "white.png"))
    clear = decode(BalloonWorkbench.share(parts, tmp_path / "clear.png", ground="transparent"))
    assert white[..., 3].min() == 255
    assert (white[0, 0, :3] == 255).all()
    assert clear[0, 0, 3] == 0
    blue_ground = decode(BalloonWorkbench.share(parts, tmp_path / "blue.png", ground="#102030"))
    assert blue_ground[0, 0].tolist() == [16, 32, 48, 255]
    behind = decode(BalloonWorkbench.share(parts, tmp_path / "photo.png", ground=str(picture)))
    assert behind[0, 0].tolist() == [20, 40, 200, 255]
    assert behind[0, -1].tolist() == [200, 30, 30, 255]
    for ground, count in ((None, 0), ("transparent", 0), ("#102030", 1), (str(picture), 1)):
        page = BalloonWorkbench.share(parts, tmp_path / "page.html", ground=ground)
        assert page.read_text("utf-8").count('id="balloon-ground"') == count
    (tmp_path / "notes.txt").write_text("notes")
    for wrong, why in (
        ("#12345", "no colour"),
        ("none.jpg", "none.jpg"),
        (tmp_path / "notes.txt", "notes.txt"),
    ):
        with pytest.raises(BalloonError, match=why):
            BalloonWorkbench.share(parts, tmp_path / "wrong.png", ground=str(wrong))
    assert not (tmp_path / "wrong.png").exists()
    colours = white[..., :3].astype(int)
    blue = np.argwhere(colours[..., 2] - colours[..., 0] > 60)[:, 1]
    red = np.argwhere(colours[..., 0] - colours[..., 2] > 60)[:, 1]
    assert min(len(blue), len(red)) > 5_000
    assert blue.mean() < 0.6 * red.mean()
    assert blue.max() < np.median(red)


def test_what_is_painted_is_there_without_an_artwork(doc, tmp_path):
    """A disc painted blue and green on nothing, in its colours where it was painted."""
    y, x = np.mgrid[:80, :80] - 39.5
    pixels = np.zeros((80, 80, 4), np.uint8)
    pixels[np.hypot(x, y) < 35] = (20, 40, 200, 255)
    pixels[(np.hypot(x, y) < 35) & (x > 0)] = (20, 150, 30, 255)
    content = png_bytes(pixels, 100.0)
    body = b"tEXt" + KEY.encode() + b"\0strokes"  # as the paint window writes it
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    head = content.index(b"IDAT") - 4
    (tmp_path / "painting.png").write_bytes(content[:head] + chunk + content[head:])
    made = BalloonWorkbench.from_picture(
        doc, tmp_path / "painting.png", width="100 mm", mesh_size="20 mm", mode="Inflate as drawn"
    )
    scene, _ = read_glb(BalloonWorkbench.share(made, tmp_path / "balloon.glb"))
    assert len(scene["images"]) == 1
    front = finished_job(made).printed.front
    outline, _ = bounds(finished_job(made).balloon.design.target.outer)
    columns, rows = front.columns_rows(outline + np.array([[0.03, 0.05], [0.07, 0.05], [-0.01, 0.05]]))
    colours = front.pixels[np.rint(rows).astype(int), np.maximum(np.rint(columns).astype(int), 0)]
    assert (colours[:2] == [(20, 40, 200, 255), (20, 150, 30, 255)]).all()
    assert colours[2, 0] > colours[2, 2]  # bare film is red


def test_a_print_keeps_its_place_on_the_film(parts, picture):
    """Flat film is wider than the balloon: each vertex has the same place in the picture all the same."""
    BalloonWorkbench.artwork(parts.pattern, picture=str(picture), resolution=50)
    job = finished_job(parts)
    rest = job.balloon.design.inflation
    flat = np.column_stack([rest.panel.rest_positions, np.zeros(len(rest.positions))])
    states = [rest, replace(rest, positions=flat)]
    make = sharing.surfaces(job.balloon, job.printed)
    for blown, before in zip(*(make([state])[0] for state in states), strict=True):
        assert np.array_equal(blown.places, before.places)
        assert np.ptp(before.positions[:, 0]) > 1.02 * np.ptp(blown.positions[:, 0])
        assert np.ptp(blown.places[:, 0]) > 0.5


def test_the_page_needs_no_network(parts, tmp_path):
    """Nothing in it is fetched; it has the balloon's numbers, and the same bytes each time."""
    page = BalloonWorkbench.share(parts, tmp_path / "balloon.html")
    text = page.read_text(encoding="utf-8")
    sources = re.findall(r"(?:src|href|srcset|action)\s*=\s*[\"']?([^\"'\s>]+)", text)
    assert len(sources) >= 2
    assert all(source.startswith(("data:", "#")) for source in sources)
    assert not re.search(r"@import|url\((?!['\"]?(?:data:|#))", text)
    assert '<html lang="en">' in text
    assert "Volume" in text
    again = BalloonWorkbench.share(parts, tmp_path / "again.html")
    assert again.read_bytes() == page.read_bytes()


def test_what_cannot_be_shared_is_told(parts, tmp_path):
    with pytest.raises(ExportError, match=r"\.glb"):
        BalloonWorkbench.share(parts, tmp_path / "balloon.blend")
    (tmp_path / "a file").write_text("here")
    with pytest.raises(ExportError, match="a file"):
        BalloonWorkbench.share(parts, tmp_path / "a file" / "balloon.glb")
    broken = BalloonWorkbench.artwork(parts.pattern, resolution=50)  # without a picture
    with pytest.raises(ExportError, match=f"{broken.Label} is not up to date"):
        BalloonWorkbench.share(parts, tmp_path / "printed.glb")
    assert not list(tmp_path.glob("*.glb"))


def test_a_balloon_that_is_not_inflated_yet_says_so(parts, tmp_path):
    """As it would be with other values, of which there is no result."""
    parts.balloon.Live = False
    parts.balloon.Pressure = 1.5 * parts.balloon.Pressure.Value
    parts.balloon.Document.recompute()
    with pytest.raises(ExportError, match="changed since"):
        BalloonWorkbench.share(parts, tmp_path / "balloon.glb")
    assert not list(tmp_path.iterdir())
