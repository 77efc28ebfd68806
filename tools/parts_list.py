# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of parts of a release (a software bill of materials) in CycloneDX's JSON.

It names the released files with their SHA-256, the native libraries with what is compiled into them, and the
Python packages that the workbench uses. The same release gives the same bytes.
"""

from __future__ import annotations

import hashlib
import json
import re
import uuid
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from native_libraries import PLATFORMS, ROOT

Json = dict[str, object]


class Package(NamedTuple):
    """A Python package: the module that is imported, its licence, whether the workbench runs without it."""

    module: str
    licence: str
    optional: bool


#: By the name under which it is installed.
PACKAGES = {
    "numpy": Package("numpy", "BSD-3-Clause", False),
    "scipy": Package("scipy", "BSD-3-Clause", False),
    "ezdxf": Package("ezdxf", "MIT", False),
    "shapely": Package("shapely", "BSD-3-Clause", False),
    "svgelements": Package("svgelements", "MIT", False),
    "pythoncdt": Package(
        "pythoncdt", "MPL-2.0 AND BSD-3-Clause AND Apache-2.0 WITH LLVM-exception", optional=True
    ),
    "matplotlib": Package("matplotlib", "PSF-2.0", True),
    "opencv-python-headless": Package("cv2", "Apache-2.0", True),
    "pillow": Package("PIL", "MIT-CMU", True),
    "pyarrow": Package("pyarrow", "Apache-2.0", True),
    "spyrrow": Package("spyrrow", "MIT", True),
}

_LLVM_LICENCE = "Apache-2.0 WITH LLVM-exception"
#: What is compiled into a library: name, whose version of versions.json, licence as in LICENSE-THIRD-PARTY.
COMPILED_IN = (
    ("Eigen", "Eigen", "MPL-2.0"),
    ("libc++", "LLVM", _LLVM_LICENCE),
    ("libc++abi", "LLVM", _LLVM_LICENCE),
    ("libunwind", "LLVM", _LLVM_LICENCE),
    ("compiler-rt", "Zig", "MIT"),
    ("mingw-w64", "mingw-w64", "ZPL-2.1"),
)
_ONLY_ON = {"mingw-w64": ("windows",), "libunwind": ("linux", "windows")}
_NOT_INSIDE = "Not in the files: FreeCAD brings it, or it is installed beside it. Tested with this version."


def pinned_versions() -> dict[str, str]:
    """The newest version of each package in the list that the tests of several Pythons install."""
    text = (ROOT / "tools" / "requirements-pythons.txt").read_text(encoding="utf-8")
    return dict(re.findall(r"^([\w.-]+)==([\w.]+)", text, re.MULTILINE))  # newer Pythons come last


def parts_list(
    files: Mapping[str, bytes],
    libraries: Mapping[str, bytes],
    compiled_with: Mapping[str, str],
    version: str,
    date: Iterable[int],
) -> bytes:
    """The list as a file.

    files          what is released, by name
    libraries      the native libraries by platform
    compiled_with  versions.json of native_libraries.py
    """
    pinned = pinned_versions()
    native = [_library(name, content, compiled_with, version) for name, content in libraries.items()]
    packages = [_package(name, package, pinned[name]) for name, package in PACKAGES.items()]
    workbench = {
        "type": "application",
        "bom-ref": "workbench",
        "name": "Film Balloon",
        "version": version,
        "licenses": [{"license": {"id": each}} for each in ("LGPL-2.1-or-later", "CC-BY-SA-4.0")],
    }
    used = [str(part["bom-ref"]) for part in (*native, *packages)]
    content: Json = {
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {
            "timestamp": "{:04d}-{:02d}-{:02d}T00:00:00Z".format(*date),
            "component": workbench,
        },
        "components": [*(_file(name, each) for name, each in files.items()), *native, *packages],
        "dependencies": [{"ref": "workbench", "dependsOn": used}, *({"ref": ref} for ref in used)],
    }
    serial = uuid.uuid5(uuid.NAMESPACE_OID, json.dumps(content))
    return (json.dumps({**content, "serialNumber": serial.urn}, indent=1) + "\n").encode()


def _hashes(content: bytes) -> list[Json]:
    return [{"alg": "SHA-256", "content": hashlib.sha256(content).hexdigest()}]


def _file(name: str, content: bytes) -> Json:
    return {"type": "file", "bom-ref": f"file:{name}", "name": name, "hashes": _hashes(content)}


def _library(platform: str, content: bytes, compiled_with: Mapping[str, str], version: str) -> Json:
    system = platform.partition("-")[0]
    inside = [
        {
            "type": "library",
            "bom-ref": f"native:{platform}:{name}",
            "name": name,
            "version": compiled_with[source],
            "licenses": [_licence(licence)],
        }
        for name, source, licence in COMPILED_IN
        if system in _ONLY_ON.get(name, (system,))
    ]
    return {
        "type": "library",
        "bom-ref": f"native:{platform}",
        "name": f"{PLATFORMS[platform].file} for {platform}",
        "version": version,
        "hashes": _hashes(content),
        "licenses": [_licence("LGPL-2.1-or-later")],
        "components": inside,
    }


def _package(name: str, package: Package, version: str) -> Json:
    return {
        "type": "library",
        "bom-ref": f"python:{name}",
        "name": name,
        "version": version,
        "description": _NOT_INSIDE,
        "scope": "optional" if package.optional else "required",
        "licenses": [_licence(package.licence)],
        "purl": f"pkg:pypi/{name}@{version}",
    }


def _licence(licence: str) -> Json:
    """An SPDX identifier, or an expression of several."""
    return {"expression": licence} if " " in licence else {"license": {"id": licence}}
