# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are written all or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from BalloonWorkbench.core.errors import ExportError
from BalloonWorkbench.core.files.write import safe_name, write_files


def test_writes_into_new_folders(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b"
    paths = write_files(folder, {"one.txt": b"1", "two.bin": b"\x00\xff"})
    assert [path.name for path in paths] == ["one.txt", "two.bin"]
    assert [path.read_bytes() for path in paths] == [b"1", b"\x00\xff"]
    assert sorted(path.name for path in folder.iterdir()) == ["one.txt", "two.bin"]
    ordinary = folder / "ordinary"
    ordinary.write_bytes(b"")
    assert paths[0].stat().st_mode == ordinary.stat().st_mode


def test_replaces_former_files(tmp_path: Path) -> None:
    write_files(tmp_path, {"one": b"old"})
    write_files(str(tmp_path), {"one": b"new"})
    assert (tmp_path / "one").read_bytes() == b"new"
    assert len(list(tmp_path.iterdir())) == 1


def test_a_file_in_the_place_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "taken").write_bytes(b"mine")
    with pytest.raises(ExportError, match="Cannot write to"):
        write_files(tmp_path / "taken" / "deeper", {"one": b"1"})
    assert (tmp_path / "taken").read_bytes() == b"mine"


def test_a_folder_nobody_can_write(tmp_path: Path) -> None:
    place = Path("/proc/balloon")
    if not place.parent.is_dir():
        pytest.skip("no /proc here")
    with pytest.raises(ExportError, match="another folder"):
        write_files(place, {"one": b"1"})


def test_failure_at_the_last_file_leaves_the_former_state(tmp_path: Path) -> None:
    (tmp_path / "one").write_bytes(b"old")
    (tmp_path / "two").mkdir()  # a folder where a file should go
    with pytest.raises(ExportError):
        write_files(tmp_path, {"one": b"new", "three": b"3", "two": b"2"})
    assert (tmp_path / "one").read_bytes() == b"old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one", "two"]


def test_names_only(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match="file name"):
        write_files(tmp_path / "x", {"ok": b"", "../evil": b""})
    assert not (tmp_path / "x").exists()


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("fish", "fish"),
        ("Poisson d'été", "Poisson d'été"),
        ('a/b\\c: "3" <new>?*|', "a_b_c_ _3_ _new_"),
        ("  two\n lines\t", "two lines"),
        ("ends. .", "ends"),
        ("NUL", "_NUL"),
        ("com1.x", "_com1.x"),
        ("..", "pattern"),
        ("", "pattern"),
        ("lone \udc80 byte", "lone _ byte"),
    ],
)
def test_any_text_names_a_file(text: str, name: str, tmp_path: Path) -> None:
    assert safe_name(text) == name
    write_files(tmp_path, {f"{safe_name(text)}.dxf": b"content"})


@pytest.mark.parametrize("sign", ["x", "é", "魚", "\N{FISH}"])
def test_a_long_text_names_a_file(sign: str, tmp_path: Path) -> None:
    name = safe_name(300 * sign)
    assert len(name) > 30
    write_files(tmp_path, {f"{name}-cutting-shop-inch_in.dxf": b"content"})
