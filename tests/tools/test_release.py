# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a release holds; its libraries are checked by `make release-check`."""

from __future__ import annotations

import ast
import base64
import hashlib
import importlib
import io
import json
import posixpath
import re
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

import pytest

import BalloonWorkbench
from BalloonWorkbench.core.solver.native import library, load

ROOT = Path(__file__).resolve().parents[2]
COMPILED_WITH = {"Eigen": "3.4.0", "LLVM": "22.1.8", "mingw-w64": "15.0.0", "Zig": "0.17.1"}


#: What FreeCAD brings under these names.
HOSTS = {
    "draftutils",
    "FreeCAD",
    "FreeCADGui",
    "Part",
    "Mesh",
    "MeshPart",
    "Sketcher",
    "Materials",
    "MatGui",
    "pivy",
    "Path",
}
HOSTS |= {"PySide", "PySide2", "PySide6"}


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
    built = load._FOLDER / library.file_name()
    for name, platform in release.PLATFORMS.items():
        (folder / name).mkdir()
        here = name == library.platform_name() and built.is_file()
        (folder / name / platform.file).write_bytes(built.read_bytes() if here else name.encode() * 500)
    (folder / "versions.json").write_text(json.dumps(COMPILED_WITH), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def files(release: ModuleType, libraries: Path) -> dict[str, bytes]:
    return release.files(libraries)


@pytest.fixture(scope="module")
def addon(release: ModuleType, libraries: Path) -> dict[str, bytes]:
    return release.addon_files(libraries)


def sums_in(sums: bytes) -> dict[str, str]:
    """Read SHA256SUMS: sums by name."""
    return dict(reversed(line.split("  ")) for line in sums.decode().splitlines())


def sums_of(packed: dict[str, bytes]) -> dict[str, str]:
    return {
        name: hashlib.sha256(content).hexdigest() for name, content in packed.items() if name != "SHA256SUMS"
    }


def opened(content: bytes) -> zipfile.ZipFile:
    return zipfile.ZipFile(io.BytesIO(content))


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.skipif(not (load._FOLDER / library.file_name()).is_file(), reason="make native has not run")
def test_addon_brings_the_solver(files: dict[str, bytes], tmp_path: Path) -> None:
    with opened(files[f"film-balloon-{BalloonWorkbench.__version__}.zip"]) as archive:
        archive.extractall(tmp_path)
    program = "from BalloonWorkbench.core.solver.native import load; print(load.problem_with_library())"
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


def test_the_source_knows_the_wheels_of_its_version(release: ModuleType) -> None:
    """What a workbench without a library may fetch, as the last `make release` wrote it."""
    listed = json.loads(release.WHEEL_LIST.read_text(encoding="utf-8"))
    assert (listed["version"], listed["interface"]) == (BalloonWorkbench.__version__, load.ABI_VERSION)
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    repository = manifest.findtext("{*}url[@type='repository']")
    assert listed["address"] == f"{repository}/releases/download/v{listed['version']}"
    assert set(listed["wheels"]) == set(release.PLATFORMS)
    for name, entry in listed["wheels"].items():
        tag = release.PLATFORMS[name].wheel
        assert entry["file"] == f"{library.PACKAGE}-{listed['version']}-py3-none-{tag}.whl"
        assert re.fullmatch("[0-9a-f]{64}", entry["sha256"])
        assert 50_000 < entry["size"] < 1_000_000


def test_the_list_is_that_of_the_wheels(
    release: ModuleType, libraries: Path, files: dict[str, bytes]
) -> None:
    listed = json.loads(release.wheel_list(libraries))["wheels"]
    made = {entry["file"]: (entry["size"], entry["sha256"]) for entry in listed.values()}
    assert made == {
        name: (len(content), hashlib.sha256(content).hexdigest())
        for name, content in files.items()
        if name.endswith(".whl")
    }


def test_sums_are_those_of_the_files(files: dict[str, bytes]) -> None:
    assert sums_in(files["SHA256SUMS"]) == sums_of(files)


def test_addon_has_the_sums_of_all_its_files(addon: dict[str, bytes]) -> None:
    assert sums_in(addon["SHA256SUMS"]) == sums_of(addon)


@pytest.mark.slow
def test_a_clone_of_the_branch_has_the_sums_also_on_windows(
    addon: dict[str, bytes], release: ModuleType, tmp_path: Path
) -> None:
    """Git for Windows changes line ends unless the files forbid it."""
    home, clone = tmp_path / "home", tmp_path / "clone"
    subprocess.run(["git", "init", "-q", "--bare", str(home)], check=True)
    importlib.import_module("release_branch").publish(addon, home)
    subprocess.run(
        ["git", "-c", "core.autocrlf=true", "clone", "-q", "--branch", "release", str(home), str(clone)],
        check=True,
    )
    found = {name: (clone / name).read_bytes() for name in addon}
    assert sums_in(found["SHA256SUMS"]) == sums_of(found)


def test_what_an_addon_leads_to_is_in_it(addon: dict[str, bytes]) -> None:
    """A page that names another one, or a picture, is of no use without it."""
    missing = []
    for name, content in addon.items():
        if name.endswith(".md"):
            text = content.decode()
            for link in re.findall(r"\]\(([^)#]+)[^)]*\)|<img[^>]* src=\"([^\"]+)\"", text):
                target = next(filter(None, link))
                path = posixpath.normpath(posixpath.join(posixpath.dirname(name), target))
                if "://" not in target and not any(each.startswith(path) for each in addon):
                    missing.append(f"{name}: {target}")
    assert not missing


def test_addon_holds_nothing_for_developers(addon: dict[str, bytes]) -> None:
    """The Addon Manager takes the packages of a requirements.txt for those that the workbench needs."""
    tops = {name.partition("/")[0] for name in addon}
    assert not tops & {
        "tests",
        "tools",
        "benchmarks",
        "Makefile",
        "pyproject.toml",
        "requirements.txt",
        ".ci",
    }


@pytest.mark.parametrize("kind", ["files", "addon"])
def test_parts_are_listed_with_their_sums(kind: str, request: pytest.FixtureRequest) -> None:
    packed: dict[str, bytes] = request.getfixturevalue(kind)
    listing = next(name for name in packed if name.endswith(".cdx.json"))
    parts = json.loads(packed[listing])["components"]
    assert {
        part["name"]: part["hashes"][0]["content"] for part in parts if part["type"] == "file"
    } == sums_of({name: content for name, content in packed.items() if name != listing})


def test_list_of_parts_says_what_the_libraries_are_made_of(
    addon: dict[str, bytes], libraries: Path, release: ModuleType
) -> None:
    parts = {part["bom-ref"]: part for part in json.loads(addon["parts.cdx.json"])["components"]}
    third_party = (ROOT / "LICENSE-THIRD-PARTY").read_text(encoding="utf-8")
    named = set()
    for name, platform in release.PLATFORMS.items():
        part = parts[f"native:{name}"]
        content = (libraries / name / platform.file).read_bytes()
        assert part["hashes"] == [{"alg": "SHA-256", "content": hashlib.sha256(content).hexdigest()}]
        inside = {each["name"]: each["version"] for each in part["components"]}
        assert ("mingw-w64" in inside) == name.startswith("windows")
        assert (inside["Eigen"], inside["libc++"]) == ("3.4.0", "22.1.8")
        for each in part["components"]:
            (licence,) = each["licenses"]
            assert licence.get("expression", licence.get("license", {}).get("id")) in third_party
        named |= set(inside)
    assert all(name in third_party for name in named)


@pytest.mark.slow
def test_list_of_parts_names_every_package_that_is_imported(addon: dict[str, bytes]) -> None:
    parts_list = importlib.import_module("parts_list")
    own = {*sys.stdlib_module_names, "BalloonWorkbench", *HOSTS}
    imported = set()
    for path in (ROOT / "BalloonWorkbench").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            modules = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            modules += [str(node.module)] if isinstance(node, ast.ImportFrom) else []
            imported |= {module.partition(".")[0] for module in modules} - own
    assert imported == {package.module for package in parts_list.PACKAGES.values()}
    listed = {
        part["purl"] for part in json.loads(addon["parts.cdx.json"])["components"] if part.get("purl", "")
    }
    pins = (ROOT / "requirements.txt").read_text(encoding="utf-8")
    pinned = dict(re.findall(r"^([\w-]+)==([\w.]+)", pins, re.MULTILINE))
    assert {f"pkg:pypi/{name}@{version}" for name, version in pinned.items()} - listed == {
        f"pkg:pypi/typing-extensions@{pinned['typing-extensions']}"  # what ezdxf needs
    }
