# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pack what users install, from the files of the repository and the libraries of native_libraries.py.

    release.py LIBRARIES FOLDER

writes an addon to unpack into FreeCAD's Mod folder, a wheel with the native library for each platform, the
list of parts and SHA256SUMS; and into the source the list of the wheels, which belongs into the commit that
is released. The same content gives the same bytes.
"""

from __future__ import annotations

import base64
import hashlib
import io
import json
import re
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

from native_libraries import PLATFORMS, ROOT
from parts_list import parts_list

ADDON = "BalloonWorkbench"
WHEEL = "film_balloon_native"
#: What an addon needs, and what its README leads to; of a folder all that is in it.
PARTS = (
    *("BalloonWorkbench", "resources", "Init.py", "InitGui.py", "package.xml", "uninstall.py"),
    *(
        "LICENSE",
        "LICENSE-ARTWORK",
        "LICENSE-THIRD-PARTY",
        *("README.md", "CHANGELOG.md", "SECURITY.md", "ARCHITECTURE.md", "CONTRIBUTING.md"),
        *(
            "docs/install.md",
            "docs/tutorial.md",
            "docs/tutorial-bodies.md",
            "docs/tutorial-machines.md",
            "docs/tutorial-engineers.md",
            "docs/examples.md",
            "docs/freecad.md",
            "docs/command-line.md",
            "docs/machines.md",
            "docs/compare.md",
            "docs/studies.md",
            "docs/api.md",
        ),
        *("docs/help", "docs/images/fish.png", "docs/images/tutorial-*.png", "docs/images/example-*.png"),
    ),
)
PARTS_LIST = "parts.cdx.json"
SUMS = "SHA256SUMS"
WHEEL_LIST = ROOT / "resources" / "native-wheels.json"
_LOADER = ROOT / "BalloonWorkbench" / "core" / "solver" / "native" / "load.py"
_LICENCES = ("LICENSE", "LICENSE-THIRD-PARTY")


def version_and_date() -> tuple[str, tuple[int, int, int]]:
    """Those of package.xml."""
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    year, month, day = map(int, str(manifest.findtext("{*}date")).split("-"))
    return str(manifest.findtext("{*}version")), (year, month, day)


def packed(contents: Mapping[str, bytes], date: tuple[int, int, int]) -> bytes:
    """A zip of files by name, in the given order; the same bytes for the same content."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            entry = zipfile.ZipInfo(name, (*date, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # the mode below is a Unix one
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, content)
    return stream.getvalue()


def with_sum(place: str, library: bytes) -> dict[str, bytes]:
    """A library and its sum beside it, which the loader asks for: see core/solver/native/library.py."""
    sum_of_it = f"{hashlib.sha256(library).hexdigest()}  {place.rpartition('/')[2]}\n"
    return {place: library, f"{place}.sha256": sum_of_it.encode()}


def sums(files: Mapping[str, bytes]) -> bytes:
    """The SHA-256 sums of files by name, as sha256sum writes and checks them."""
    lines = [f"{hashlib.sha256(files[name]).hexdigest()}  {name}\n" for name in sorted(files)]
    return "".join(lines).encode()


def native_libraries(folder: Path) -> dict[str, bytes]:
    """The libraries by platform."""
    return {name: (folder / name / platform.file).read_bytes() for name, platform in PLATFORMS.items()}


def _parts_list(files: Mapping[str, bytes], libraries: Path) -> bytes:
    version, date = version_and_date()
    compiled_with = json.loads((libraries / "versions.json").read_text(encoding="utf-8"))
    return parts_list(files, native_libraries(libraries), compiled_with, version, date)


def addon_files(libraries: Path) -> dict[str, bytes]:
    """The files of an installed workbench, with the libraries of all platforms, in alphabetical order."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--", *PARTS], cwd=ROOT, check=True, capture_output=True, text=True
    )
    names = [name for name in listed.stdout.split("\0") if name]
    contents = {name: (ROOT / name).read_bytes() for name in names}
    for name, library in native_libraries(libraries).items():
        contents |= with_sum(f"BalloonWorkbench/native/lib/{name}/{PLATFORMS[name].file}", library)
    contents[".gitattributes"] = b"* -text\n"  # a clone on Windows has the bytes that were summed up
    contents = dict(sorted(contents.items()))
    contents[PARTS_LIST] = _parts_list(contents, libraries)
    return {**contents, SUMS: sums(contents)}


def addon(libraries: Path, date: tuple[int, int, int]) -> bytes:
    """The workbench as a zip, in the folder under which FreeCAD's Mod has it."""
    contents = addon_files(libraries)
    return packed({f"{ADDON}/{name}": contents[name] for name in sorted(contents)}, date)


def wheel(library: Path, tag: str, version: str, date: tuple[int, int, int]) -> bytes:
    """A package with nothing but the library of one platform, for any Python 3."""
    about = f"{WHEEL}-{version}.dist-info"
    metadata = (
        f"Metadata-Version: 2.1\nName: {WHEEL.replace('_', '-')}\nVersion: {version}\n"
        "Summary: The native solver of the Film Balloon workbench for FreeCAD\n"
        "License: LGPL-2.1-or-later\nRequires-Python: >=3.10\n"
        + "".join(f"License-File: {name}\n" for name in _LICENCES)
        + "\nA library with a plain C interface; the Film Balloon workbench finds it by itself.\n"
    )
    tags = "".join(f"Tag: py3-none-{each}\n" for each in tag.split("."))
    contents = {
        f"{WHEEL}/__init__.py": b'# SPDX-License-Identifier: LGPL-2.1-or-later\n"""Holds a library."""\n',
        **with_sum(f"{WHEEL}/{library.name}", library.read_bytes()),
        f"{about}/METADATA": metadata.encode(),
        f"{about}/WHEEL": f"Wheel-Version: 1.0\nGenerator: release\nRoot-Is-Purelib: false\n{tags}".encode(),
        **{f"{about}/{name}": (ROOT / name).read_bytes() for name in _LICENCES},
    }
    record = "".join(
        f"{name},sha256={_digest(content)},{len(content)}\n" for name, content in contents.items()
    )
    contents[f"{about}/RECORD"] = f"{record}{about}/RECORD,,\n".encode()
    return packed(contents, date)


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def wheels(libraries: Path) -> dict[str, tuple[str, bytes]]:
    """File name and content of the wheel of each platform."""
    version, date = version_and_date()
    return {
        name: (
            f"{WHEEL}-{version}-py3-none-{platform.wheel}.whl",
            wheel(libraries / name / platform.file, platform.wheel, version, date),
        )
        for name, platform in PLATFORMS.items()
    }


def wheel_list(libraries: Path) -> bytes:
    """What a workbench without a library may fetch, and how it knows that file: native/native_wheel.py."""
    version, _ = version_and_date()
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    address = str(manifest.findtext("{*}url[@type='repository']", "")).strip().rstrip("/")
    interface = re.search(r"^ABI_VERSION = (\d+)$", _LOADER.read_text(encoding="utf-8"), re.MULTILINE)
    if interface is None:
        raise SystemExit(f"{_LOADER} does not say which interface it needs.")
    listed = {
        "version": version,
        "interface": int(interface[1]),
        "address": f"{address}/releases/download/v{version}",
        "wheels": {
            name: {"file": file, "size": len(content), "sha256": hashlib.sha256(content).hexdigest()}
            for name, (file, content) in wheels(libraries).items()
        },
    }
    return f"{json.dumps(listed, indent=2)}\n".encode()


def files(libraries: Path) -> dict[str, bytes]:
    """Everything that is released, by name."""
    version, date = version_and_date()
    made = {f"film-balloon-{version}.zip": addon(libraries, date), **dict(wheels(libraries).values())}
    made[f"film-balloon-{version}.cdx.json"] = _parts_list(made, libraries)
    return {**made, SUMS: sums(made)}


def main(arguments: list[str]) -> None:
    """Write the files."""
    libraries, folder = map(Path, arguments)
    folder.mkdir(parents=True, exist_ok=True)
    WHEEL_LIST.write_bytes(wheel_list(libraries))
    for name, content in files(libraries).items():
        (folder / name).write_bytes(content)
        print(f"{len(content):8d} bytes  {folder / name}")


if __name__ == "__main__":
    main(sys.argv[1:])
