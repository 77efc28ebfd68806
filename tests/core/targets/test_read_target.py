# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files written here by their formats, good and damaged: one closed body, or one sentence."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from mesh_writers import WRITERS
from solids import ball, box, torus

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.mesh_files import RawMesh
from BalloonWorkbench.core.targets.read_target import read_target, target_of
from BalloonWorkbench.core.types import Floats, Ints

MESHES = Path(__file__).parents[2] / "resources" / "meshes"
VOLUME = 4.0 / 3.0 * np.pi * 100.0**3 * 1e-9


def sphere() -> tuple[Floats, Ints]:
    target = ball()
    return 100.0 * target.points, target.triangles


@pytest.mark.parametrize("kind", WRITERS)
def test_every_format_gives_the_body(kind: str, tmp_path: Path) -> None:
    suffix, write = WRITERS[kind]
    path = tmp_path / f"body.{suffix}"
    path.write_bytes(write(*sphere()))
    target = read_target(path)
    assert (target.twins >= 0).all()
    assert len(target.triangles) == len(sphere()[1])
    assert target.volume == pytest.approx(VOLUME, rel=1e-2)
    assert target.notes == ()


@pytest.mark.parametrize("kind", WRITERS)
def test_a_file_that_ends_too_early_or_has_other_bytes_is_told(kind: str, tmp_path: Path) -> None:
    suffix, write = WRITERS[kind]
    data = write(*sphere())
    random = np.random.default_rng(4)
    path = tmp_path / f"body.{suffix}"
    for _ in range(6):
        damaged = bytearray(data[: random.integers(1, len(data))])
        for at in random.integers(0, len(damaged), 5):
            damaged[at] = random.integers(256)
        path.write_bytes(damaged)
        try:
            assert read_target(path).volume > 0.0
        except InputError as error:
            assert str(error).endswith(".")


@pytest.mark.parametrize("kind", [kind for kind in WRITERS if kind != "binary STL"])
def test_a_file_of_another_kind_is_no_stl(kind: str, tmp_path: Path) -> None:
    """Nor are its first bytes taken for a number of triangles."""
    path = tmp_path / "body.stl"
    path.write_bytes(b"another " + WRITERS[kind][1](*sphere()))
    with pytest.raises(InputError, match="no STL file at all"):
        read_target(path)


def test_faces_of_many_corners_are_parted(tmp_path: Path) -> None:
    corners = [[x, y, z] for x in (0, 40) for y in (0, 50) for z in (0, 60)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    path = tmp_path / "box.obj"
    lines = ["v {} {} {}".format(*corner) for corner in corners]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces]
    path.write_text("\n".join(lines))
    assert read_target(path).volume == pytest.approx(0.04 * 0.05 * 0.06)
    path = tmp_path / "box.ply"
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
    header += "property double z\nelement face 6\nproperty list uint8 uint32 vertex_index\nend_header\n"
    body = b"".join(struct.pack("<3d", *corner) for corner in corners)
    body += b"".join(struct.pack("<B4I", 4, *face) for face in faces)
    path.write_bytes(header.encode() + body)
    assert read_target(path).volume == pytest.approx(0.04 * 0.05 * 0.06)


def body_of(points: Floats, triangles: Ints) -> tuple[float, tuple[str, ...]]:
    target = target_of(RawMesh(points, triangles), "body")
    assert (target.twins >= 0).all()
    assert (target.areas >= 0.0).all()
    assert np.isfinite(target.points).all()
    return target.volume, target.notes


def test_what_is_safe_is_mended_and_told() -> None:
    points, triangles = sphere()
    random = np.random.default_rng(5)
    some = random.integers(0, len(triangles), 400)
    turned = triangles.copy()
    turned[some] = turned[some][:, ::-1]
    unknown = points.copy()
    unknown[7] = np.nan
    apart = points[triangles].reshape(-1, 3)
    loose = np.arange(triangles.size, dtype=np.int32).reshape(-1, 3)
    cases = {
        "inside out": (points, triangles[:, ::-1], ""),
        "turned": (points, turned, "wrong way round"),
        "holes": (
            points,
            triangles[random.permutation(len(triangles))[:-6]],
            "Holes",
        ),
        "NaN": (unknown, triangles, "no numbers"),
        "loose": (apart, loose, ""),
        "loose and rounded": (apart.astype(np.float32) + 1e-5 * random.normal(size=apart.shape), loose, ""),
        "twice": (points, np.concatenate([triangles, triangles[:50]]), "lay on others"),
        "back to back": (points, np.concatenate([triangles, triangles[:50, ::-1]]), "lay on others"),
        "two": (
            np.concatenate([points, 0.3 * points + 400.0]),
            np.concatenate([triangles, triangles + len(points)]),
            "there are: 2",
        ),
        "no area": (points, np.concatenate([triangles, triangles[:9, [0, 1, 1]]]), ""),
    }
    for name, (at, corners, said) in cases.items():
        volume, notes = body_of(at, corners)
        assert volume == pytest.approx(VOLUME, rel=1e-2), name
        assert any(said in note for note in notes) if said else not notes, (name, notes)


def test_an_open_end_is_closed_flat() -> None:
    points, triangles = sphere()
    upper = points[triangles].mean(axis=1)[:, 2] > 0.0
    volume, notes = body_of(points, triangles[upper])
    assert volume == pytest.approx(0.5 * VOLUME, rel=1e-2)
    assert len(notes) == 1


@pytest.mark.parametrize(
    ("points", "triangles", "says"),
    [
        (sphere()[0] * (1.0, 1.0, 0.0), sphere()[1], "flat"),
        (sphere()[0] * 0.0, sphere()[1], "one place"),
        (sphere()[0], sphere()[1][:0], "no triangle"),
        (sphere()[0], sphere()[1] + 5, "not there"),
        (sphere()[0] * np.nan, sphere()[1], "no triangle"),
        (sphere()[0] * 1e5, sphere()[1], "long"),
        (torus().points * 100.0, torus().triangles[: len(torus().triangles) // 2 + 37], "not closed"),
    ],
)
def test_what_is_no_body_is_refused(points: Floats, triangles: Ints, says: str) -> None:
    with pytest.raises(InputError, match=says) as refused:
        body_of(points, triangles)
    assert str(refused.value).endswith(".")


def test_a_strip_without_an_outside_is_refused() -> None:
    """A Moebius strip, thick enough to have no other fault."""
    count = 60
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    rims = [
        np.column_stack(
            [
                (10 + s * np.cos(turn / 2)) * np.cos(turn),
                (10 + s * np.cos(turn / 2)) * np.sin(turn),
                s * np.sin(turn / 2),
            ]
        )
        for s in (-2.0, 2.0)
    ]
    here = np.arange(count)
    ahead = np.roll(here, -1)
    low, high = here, here + count
    next_low = np.where(ahead == 0, count, ahead)
    next_high = np.where(ahead == 0, 0, ahead + count)
    strip = np.concatenate(
        [np.column_stack([low, next_low, high]), np.column_stack([high, next_low, next_high])]
    )
    with pytest.raises(InputError, match="no outside"):
        body_of(np.concatenate(rims), strip.astype(np.int32))


def test_size_and_unit() -> None:
    target = box((1.0, 2.0, 3.0))
    metres = target_of(RawMesh(target.points, target.triangles), "box")
    assert metres.volume == pytest.approx(6.0)
    assert "metres" in metres.notes[0]
    millimetres = target_of(RawMesh(100.0 * target.points, target.triangles), "box")
    assert millimetres.volume == pytest.approx(6e-3)
    wide = target_of(RawMesh(target.points, target.triangles), "box", width=0.5)
    assert np.ptp(wide.points, axis=0).tolist() == pytest.approx([0.5, 1.0, 1.5])
    assert wide.notes == ()
    inside = target_of(RawMesh(target.points, target.triangles), "box", width=0.5, height=0.3)
    assert np.ptp(inside.points, axis=0)[2] == pytest.approx(0.3)


@pytest.mark.parametrize("name", ["spot", "fish"])
def test_known_bodies(name: str) -> None:
    target = read_target(MESHES / f"{name}.obj", width=0.5)
    assert np.ptp(target.points[:, 0]) == pytest.approx(0.5)
    assert len(target.points) - len(target.triangles) // 2 == 2, "a ball"
    assert target.notes == ()
