# SPDX-License-Identifier: LGPL-2.1-or-later
"""GLB files as Khronos' glTF validator reads them: nothing is wrong, nothing is doubtful."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawn_shapes import NAMED
from inflated import lifted
from profiles import sphere

from BalloonWorkbench.core.artwork.picture import Picture
from BalloonWorkbench.core.artwork.wrap import wrapped
from BalloonWorkbench.core.bag_design.gore_fit import inflate_gores
from BalloonWorkbench.core.bag_design.inflate_bag import inflate_bag
from BalloonWorkbench.core.bodies.ready import ready_bag
from BalloonWorkbench.core.film.film import Look
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.scenes.glb import glb_bytes
from BalloonWorkbench.core.scenes.surface_mesh import Painted, SurfaceMesh, bag_meshes, two_panel_meshes

ROOT = Path(__file__).parents[3]
PACKAGES = ROOT / "build/gltf-tools/node_modules"
NODE = shutil.which("node")

#: A note that the sides of a picture are no powers of two: programs that need these resize (glTF 2.0, 3.8).
_ALLOWED = {"IMAGE_NPOT_DIMENSIONS"}

pytestmark = pytest.mark.skipif(
    NODE is None or not (PACKAGES / "gltf-validator").is_dir(),
    reason="the glTF validator is not here: see tools/install-gltf-validator.sh",
)


def findings(folder: Path, *contents: bytes) -> list[list[dict[str, Any]]]:
    """What the validator says of GLB files: errors, warnings, notes and hints of each."""
    paths = [folder / f"{k}.glb" for k in range(len(contents))]
    for path, content in zip(paths, contents):
        path.write_bytes(content)
    program = [str(NODE), str(ROOT / "tools/gltf/validate.js"), str(PACKAGES), *map(str, paths)]
    ran = subprocess.run(program, capture_output=True, text=True, timeout=120, check=False)
    assert ran.returncode == 0, ran.stderr
    reports = json.loads(ran.stdout)
    assert [report["mimeType"] for report in reports] == ["model/gltf-binary"] * len(paths)
    return [report["issues"]["messages"] for report in reports]


def picture(low: np.ndarray, size: np.ndarray) -> Picture:
    """Stripes over a box."""
    pixels = np.full((64, 96, 4), 255, np.uint8)
    pixels[::8, :, :3] = (200, 10, 20)
    return Picture(pixels, low, size / (96, 64))


def two_panels(look: Look, *, printed: bool) -> list[SurfaceMesh]:
    inflation = lifted(triangulate(NAMED["heart"], 0.02))
    low, size = inflation.positions[:, :2].min(axis=0), np.ptp(inflation.positions[:, :2], axis=0)
    painted = Painted(picture(low, size), picture(low, size)) if printed else Painted()
    return two_panel_meshes([inflation], 0.005, look, painted)[0]


def gores() -> list[SurfaceMesh]:
    design = inflate_gores(sphere(0.3), 6, film("mylar"), 2000.0, mesh_size=0.12)
    films, low, size = wrapped(design, range(6))
    return bag_meshes(design, Look("foil", "#8040ff"), [(each, picture(low, size)) for each in films])


def test_khronos_finds_nothing(tmp_path: Path) -> None:
    """Two panels bare, clear, with print and two in one file; gores with print; a bag."""
    bag = inflate_bag(ready_bag("cone"), film("mylar"), 1000.0, mesh_size=0.1)
    named = {
        "bare": {"a": two_panels(Look("foil", "#8040ff"), printed=False)},
        "clear": {"a": two_panels(Look("clear", "#8040ff", 0.5), printed=False)},
        "printed": {"a": two_panels(Look("matt"), printed=True)},
        "two": {name: two_panels(Look("matt"), printed=True) for name in ("a", "b\n\u732b")},
        "gores": {"a": gores()},
        "bag": {"a": bag_meshes(bag, Look("foil"))},
    }  # fmt: skip
    said = findings(tmp_path, *(glb_bytes("Balloon \u732b", meshes) for meshes in named.values()))
    for name, messages in zip(named, said, strict=True):
        doubts = [each for each in messages if each["code"] not in _ALLOWED]
        assert doubts == [], name


def test_the_validator_is_asked(tmp_path: Path) -> None:
    """One vertex is out of the range that the file names."""
    content = glb_bytes("", {"a": two_panels(Look("foil"), printed=False)})
    start = 28 + int.from_bytes(content[12:16], "little")
    numbers = np.frombuffer(content[start : start + 12], "<f4") + np.float32(9.0)
    broken = content[:start] + numbers.astype("<f4").tobytes() + content[start + 12 :]
    (messages,) = findings(tmp_path, broken)
    assert any(each["code"] == "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND" for each in messages), messages
