# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a release holds; its libraries are checked by `make release-check`."""

from __future__ import annotations

import base64
import hashlib
import importlib
import io
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

import BalloonWorkbench
from BalloonWorkbench.core.solver import library, native

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def release() -> Iterator[ModuleType]:
    """The program that packs."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(ROOT / "tools"))
        yield importlib.import_module("release")


@pytest.fixture(scope="module")
def libraries(release: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Files in the places of the libraries; the one of this platform is real where it was built."""
    folder = tmp_path_factory.mktemp("libraries")
    built = native._FOLDER / library.file_name()
    for name, platform in release.PLATFORMS.items():
        (folder / name).mkdir()
        here = name == library.platform_name() and built.is_file()
        (folder / name / platform.file).write_bytes(built.read_bytes() if here else name.encode() * 500)
    return folder


@pytest.fixture(scope="module")
def files(release: ModuleType, libraries: Path) -> dict[str, bytes]:
    return release.files(libraries)


def opened(content: bytes) -> zipfile.ZipFile:
    return zipfile.ZipFile(io.BytesIO(content))


def test_the_same_content_gives_the_same_bytes(
    release: ModuleType, libraries: Path, files: dict[str, bytes]
) -> None:
    for path in libraries.rglob("*"):
        path.touch()
    assert release.files(libraries) == files


def test_the_loader_knows_every_platform(release: ModuleType) -> None:
    assert set(release.PLATFORMS) == {
        *("linux-x86_64", "linux-aarch64", "windows-x86_64", "macos-x86_64", "macos-aarch64"),
    }
    assert release.PLATFORMS[library.platform_name()].file == library.file_name()


def test_addon_is_complete_and_starts(files: dict[str, bytes], tmp_path: Path) -> None:
    version = BalloonWorkbench.__version__
    with opened(files[f"film-balloon-{version}.zip"]) as archive:
        names = set(archive.namelist())
        archive.extractall(tmp_path)
    top = "BalloonWorkbench/"
    assert all(name.startswith(top) for name in names)
    assert {
        top + name for name in ("Init.py", "InitGui.py", "package.xml", "LICENSE", "LICENSE-ARTWORK")
    } <= names
    assert not [name for name in names if "/tests/" in name or "__pycache__" in name]
    told = subprocess.run(
        [sys.executable, "-c", "import BalloonWorkbench.core.job, BalloonWorkbench as b; print(b.__file__)"],
        cwd=tmp_path / "BalloonWorkbench",
        capture_output=True,
        text=True,
        check=True,
    )
    assert str(tmp_path) in told.stdout


@pytest.mark.skipif(not (native._FOLDER / library.file_name()).is_file(), reason="make native has not run")
def test_addon_brings_the_solver(files: dict[str, bytes], tmp_path: Path) -> None:
    with opened(files[f"film-balloon-{BalloonWorkbench.__version__}.zip"]) as archive:
        archive.extractall(tmp_path)
    program = "from BalloonWorkbench.core.solver import native; print(native.problem_with_library())"
    told = subprocess.run(
        [sys.executable, "-c", program],
        cwd=tmp_path / "BalloonWorkbench",
        capture_output=True,
        text=True,
        check=True,
    )
    assert told.stdout == "None\n"


def test_wheels_are_as_the_specification_wants(files: dict[str, bytes]) -> None:
    wheels = [name for name in files if name.endswith(".whl")]
    assert len(wheels) == 5
    for name in wheels:
        package, version, *tags = name.removesuffix(".whl").split("-")
        assert (package, version, tags[:2]) == (
            library.PACKAGE,
            BalloonWorkbench.__version__,
            ["py3", "none"],
        )
        with opened(files[name]) as archive:
            about = f"{package}-{version}.dist-info"
            listed = archive.read(f"{about}/RECORD").decode().splitlines()
            assert [line.partition(",")[0] for line in listed] == archive.namelist()
            for line in listed[:-1]:
                path, digest, size = line.split(",")
                content = archive.read(path)
                made = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                assert (digest, int(size)) == (f"sha256={made}", len(content))
            tag_lines = archive.read(f"{about}/WHEEL").decode()
            assert all(f"Tag: py3-none-{tag}\n" in tag_lines for tag in tags[2].split("."))


def test_sums_are_those_of_the_files(files: dict[str, bytes]) -> None:
    sums = dict(reversed(line.split("  ")) for line in files["SHA256SUMS"].decode().splitlines())
    assert sums == {
        name: hashlib.sha256(content).hexdigest() for name, content in files.items() if name != "SHA256SUMS"
    }
