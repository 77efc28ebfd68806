# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon for others: balloon.glb and report.html of drawings, gores and panels, whatever their names."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

from BalloonWorkbench.cli import main
from BalloonWorkbench.core.artwork.files import png_bytes

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
