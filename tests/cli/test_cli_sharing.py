# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon for others: balloon.glb and report.html of drawings, gores and panels, whatever their names."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
import trimesh
from PIL import Image, ImageSequence

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.shared import animation, sharing

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
TWO = {"unit": "mm", "parts": [
    {"outer": [[0, 0], [120, 0], [120, 70], [0, 70]]}, {"outer": [[150, 0], [220, 0], [220, 70], [150, 70]]}
]}  # fmt: skip
NASTY = "a <b>&amp; 'c' \"d\".json"


def shared(file: Path, out: Path, *options: str) -> tuple[trimesh.Scene, str]:
    """Both files, read again."""
    assert main(["inflate", str(file), "--out", str(out), "--glb", "--report", "html", *options]) == 0
    return trimesh.load(out / "balloon.glb", process=False), (out / "report.html").read_text(encoding="utf-8")


def test_two_shapes_with_a_picture_of_any_name(tmp_path: Path) -> None:
    """Both with their numbers, in metres beside each other, printed with their own part of the picture."""
    (tmp_path / NASTY).write_text(json.dumps(TWO), encoding="utf-8")
    pixels = np.full((80, 220, 4), (20, 40, 200, 255), np.uint8)
    pixels[:, 135:] = (20, 180, 40, 255)
    (tmp_path / "colours.png").write_bytes(png_bytes(pixels, 100.0))
    asked = (
        "--mesh-size",
        "15mm",
        "--artwork",
        str(tmp_path / "colours.png"),
        "--dpi",
        "20",
        "--language",
        "de",
    )
    scene, page = shared(tmp_path / NASTY, tmp_path / "out", *asked)
    assert 0.2 < scene.extents[0] < 0.24
    assert scene.extents[0] > 2.5 * scene.extents[1] > 0.1
    for part in scene.geometry.values():
        image = np.asarray(part.visual.material.baseColorTexture.convert("RGB"))
        column = np.clip(part.visual.uv[:, 0] * image.shape[1], 0, image.shape[1] - 1).astype(int)
        blue = image[len(image) // 2, column, 2] > 100
        assert blue.all() == (part.vertices[:, 0].mean() < 0.0)
        assert blue.any() == blue.all()
    assert '<html lang="de">' in page
    assert "A &lt;b&gt;&amp;amp; &#x27;c&#x27; &quot;d&quot;" in page
    assert "<b>" not in page
    assert page.count("<table") == 6  # form, material and numbers of both
    assert "Volumen" in page
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"balloon.glb", "report.html", "report.json", "artwork-front.png"} <= names


@pytest.mark.slow
@pytest.mark.parametrize(
    ("file", "options", "height"),
    [("profiles/sphere.json", ("--gores", "6", "--width", "200mm", "--mesh-size", "60mm"), 0.2),
     ("bags/cube.json", ("--mesh-size", "60mm"), 0.19)],
)  # fmt: skip
def test_many_panels(tmp_path: Path, file: str, options: tuple[str, ...], height: float) -> None:
    """Closed, upright, and as large as the report says."""
    scene, page = shared(EXAMPLES / file, tmp_path / "out", *options)
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    inflated = report["parts"][0]["inflated"]
    sizes = [1e-3 * inflated[key] for key in ("width_mm", "height_mm", "thickness_mm")]
    assert scene.extents == pytest.approx(sizes, rel=1e-5)
    assert scene.extents[1] == pytest.approx(height, rel=0.3)
    whole = scene.to_mesh()
    whole.merge_vertices(merge_tex=True, merge_norm=True)
    assert whole.is_watertight
    assert whole.volume == pytest.approx(inflated["volume_m3"], rel=0.1)
    assert page.count("<path") > 6
    assert page.startswith("<!DOCTYPE html>")


def test_picture_and_page_on_a_ground(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """White or the page's own, a colour, nothing, a photograph; a wrong one is told before the work."""
    monkeypatch.setattr(sharing, "_LARGE", (160, 120))
    (tmp_path / "box.json").write_text(json.dumps({"unit": "mm", "outer": TWO["parts"][0]["outer"]}))
    (tmp_path / "room.png").write_bytes(png_bytes(np.full((40, 90, 4), (20, 40, 60, 255), np.uint8), 100.0))
    asked = ["inflate", str(tmp_path / "box.json"), "--mesh-size", "30mm", "--out", str(tmp_path / "out")]
    for ground, corner, on_page in (
        ((), (255, 255, 255, 255), 0),
        (("--ground", "#102030"), (16, 32, 48, 255), 1),
        (("--ground", "transparent"), (0, 0, 0, 0), 0),
        (("--ground", str(tmp_path / "room.png")), (20, 40, 60, 255), 1),
    ):
        assert main([*asked, "--png", "--report", "html", *ground]) == 0
        pixels = np.asarray(Image.open(tmp_path / "out" / "balloon.png").convert("RGBA"))
        assert pixels[0, 0].tolist() == [*corner]
        assert pixels[60, 80, :3].tolist() != [*corner[:3]]
        page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
        assert page.count('id="balloon-ground"') == on_page
    for wrong, why in (
        (("--png", "--ground", "#10203"), "is no colour"),
        (("--png", "--ground", str(tmp_path / "none.png")), "none.png"),
        (("--ground", "#102030"), "Give --png"),
    ):
        out = tmp_path / "wrong"
        assert main([*asked[:-1], str(out), *wrong]) != 0
        assert why in capsys.readouterr().err
        assert not out.exists()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["gif", "mp4"])
def test_the_inflation_as_a_moving_picture(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """OpenCV and Pillow play it: flat film at first, a thick balloon at the end, its shadow below; red film
    on white. The same input gives the same file."""
    monkeypatch.setattr(animation, "_FRAMES", 4)
    bag = EXAMPLES / "bags" / "cube.json"
    for out in ("one", "other"):
        asked = ("--mesh-size", "60mm", "--animation", kind, "--only", "report")
        assert main(["inflate", str(bag), "--out", str(tmp_path / out), *asked]) == 0
    file, again = (tmp_path / out / f"inflation.{kind}" for out in ("one", "other"))
    frames = played(file)
    assert len(frames) == (4 if kind == "gif" else 4 + animation._REST)
    red = [(frame[..., 0] > frame[..., 1] + 60.0) for frame in frames]
    assert red[-1].sum() != red[0].sum()
    assert np.ptp(np.flatnonzero(red[-1].any(axis=0))) > 1.1 * np.ptp(np.flatnonzero(red[0].any(axis=0)))
    assert frames[0][:4].min() > 240.0
    below = np.flatnonzero(red[-1].any(axis=1)).max()
    assert (np.ptp(frames[-1][below + 2 :], axis=-1) < 20.0).all()
    assert frames[-1][below + 2 :].min() < 225.0
    assert file.read_bytes() == again.read_bytes()


def played(file: Path) -> list[np.ndarray]:
    if file.suffix == ".gif":
        return [
            np.array(each.convert("RGB"), dtype=float) for each in ImageSequence.Iterator(Image.open(file))
        ]
    video, frames = cv2.VideoCapture(str(file)), []
    while (read := video.read())[0]:
        frames.append(read[1][..., ::-1].astype(float))
    return frames


def test_what_cannot_be_animated_is_left_out_with_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(animation, "opencv", lambda: None)
    bag = EXAMPLES / "bags" / "cube.json"
    asked = ("--mesh-size", "60mm", "--animation", "mp4", "--only", "report")
    assert main(["inflate", str(bag), "--out", str(tmp_path), *asked]) == 0
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert any("choose a GIF" in warning for warning in report["warnings"])
    assert not (tmp_path / "inflation.mp4").exists()
