# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the libraries of native_libraries.py: what they show, what they need, and that they compute.

Then the files of release.py: their sums, and that the lists of parts are valid CycloneDX.

    check_release.py LIBRARIES RELEASE

The program of tests/native/small_disc.c inflates a disc to its known volume: here, for aarch64 in QEMU, for
Windows in Wine. What macOS would run cannot be run here; its libraries are read. Exits with 1 when one fails.
"""

from __future__ import annotations

import hashlib
import os
import platform
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import lief
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from macho_signature import signature_faults, signature_place
from native_libraries import PLATFORMS, ROOT, build, zig
from release import PARTS_LIST, SUMS

sys.path.insert(0, str(ROOT))
from BalloonWorkbench.core.solver.native.c_interface import CONSTANTS
from BalloonWorkbench.core.solver.native.library import damage

_HEADER = ROOT / "BalloonWorkbench" / "native" / "include" / "film_solver.h"
_CONSTANTS = f"-DCONSTANTS={','.join(map(repr, CONSTANTS.values()))}"
INTERFACE = set(re.findall(r"\b(film_\w+)\(", _HEADER.read_text(encoding="utf-8")))
# The C++ runtime of macOS replaces these in every program by one common set; they cannot be hidden.
_REPLACEABLE = re.compile(r"_Z(n|d)[aw]|_Z(n|d)l|_mh_dylib_header|__dso_handle")
_OWN = {
    "linux": {"libm.so.6", "libc.so.6", "libpthread.so.0", "libdl.so.2"},
    "windows": {"kernel32.dll"},
    "macos": {"libSystem.B.dylib"},
}
_RUNNERS = {
    "linux-aarch64": ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"],
    "windows-x86_64": ["/usr/lib/wine/wine64"],
}

_PATIENCE = 900  # s; Wine's first start makes its folder, minutes on a busy machine
lief.logging.disable()  # it grumbles about parts of Apple's format that it does not know


def faults(name: str, path: Path) -> list[str]:
    """What is wrong with a library by reading it."""
    system = name.partition("-")[0]
    if system == "macos":
        return _macos_faults(path)
    binary = lief.parse(str(path))
    if system == "windows":
        shown = {entry.name for entry in binary.get_export().entries}
        needed = {item.name.lower() for item in binary.imports if not item.name.startswith("api-ms-win-crt-")}
        found = []
    else:
        shown = {symbol.name for symbol in binary.exported_symbols}
        needed = {library for library in binary.libraries if not library.startswith("ld-linux")}
        limit = tuple(map(int, PLATFORMS[name].target.rpartition("gnu.")[2].split(".")))
        versions = {
            (int(number[0]), int(number[1]))
            for need in binary.symbols_version_requirement
            for symbol in need.get_auxiliary_symbols()
            for number in [re.findall(r"\d+", symbol.name)]
        }
        found = [f"needs glibc {major}.{minor}" for major, minor in versions if (major, minor) > limit]
    return found + _differences(shown, needed, system)


def _macos_faults(path: Path) -> list[str]:
    binary = lief.MachO.parse(str(path)).at(0)
    names = {symbol.name.removeprefix("_") for symbol in binary.exported_symbols}
    shown = {name for name in names if not _REPLACEABLE.match(name.replace("__Z", "_Z"))}
    needed = {library.name.rpartition("/")[2] for library in binary.libraries} - {path.name}
    found = _differences(shown, needed, "macos")
    if tuple(binary.build_version.minos)[:2] != (11, 0):
        found.append(f"needs macOS {binary.build_version.minos}")
    content = path.read_bytes()
    # Apple's processors ask for one; on Intel's the linker leaves it out, and a wrong one would be refused
    if "aarch64" in path.parent.name or signature_place(content):
        found += signature_faults(content)
    return found


def _differences(shown: set[str], needed: set[str], system: str) -> list[str]:
    found = [f"shows {name}" for name in sorted(shown - INTERFACE)]
    found += [f"lacks {name}" for name in sorted(INTERFACE - shown)]
    return found + [f"needs {name}" for name in sorted(needed - _OWN[system])]


def run(name: str, path: Path, folder: Path) -> str:
    """The output of the test program with a library; SubprocessError when it fails or does not end."""
    program = folder / ("small_disc.exe" if name.startswith("windows") else "small_disc")
    rpath = () if name.startswith("windows") else (f"-Wl,-rpath,{path.parent}",)
    source = ROOT / "tests" / "native" / "small_disc.c"
    zig(
        *("cc", "-target", PLATFORMS[name].target, "-std=c99", "-O1", "-Iinclude", _CONSTANTS, source, path),
        *(*rpath, "-lm", "-o", program),
    )
    if not rpath:
        (folder / path.name).write_bytes(path.read_bytes())  # Windows looks beside the program
    # what Wine would ask in a window: whether to download a browser and .NET
    wine = {
        "WINEPREFIX": str(ROOT / "build" / "wine"),
        "WINEDEBUG": "-all",
        "WINEDLLOVERRIDES": "mscoree,mshtml=",
    }
    told = folder / "told"
    with told.open("wb") as output:  # no pipe: Wine's server goes on after the program and would hold it open
        subprocess.run(
            [*_RUNNERS.get(name, []), program],
            check=True,
            env={**os.environ, **wine},
            stdin=subprocess.DEVNULL,
            stdout=output,
            timeout=_PATIENCE,
        )
    return told.read_text(encoding="utf-8").strip()


def library_faults(packed: Path) -> list[str]:
    """Why the loader would refuse libraries in an addon or wheel; there has to be one."""
    with zipfile.ZipFile(packed) as archive, tempfile.TemporaryDirectory() as folder:
        archive.extractall(folder)
        files = {platform.file for platform in PLATFORMS.values()}
        libraries = sorted(path for path in Path(folder).rglob("*") if path.name in files)
        wrong = [told for told in map(damage, libraries) if told is not None]
    return wrong if libraries else ["it holds no library"]


def parts_faults(content: bytes) -> list[str]:
    """What CycloneDX's schema has against a list of parts."""
    error = JsonStrictValidator(SchemaVersion.V1_6).validate_str(content.decode())
    return [] if error is None else [str(error)]


def file_faults(path: Path) -> list[str]:
    """What is wrong with a released file by reading it."""
    if path.name.endswith(".cdx.json"):
        return parts_faults(path.read_bytes())
    with zipfile.ZipFile(path) as archive:
        inside = [name for name in archive.namelist() if name.endswith(PARTS_LIST)]
        found = [fault for name in inside for fault in parts_faults(archive.read(name))]
    return found + library_faults(path)


def main(arguments: list[str]) -> int:
    """Check all libraries and the sums; one of them is compiled once more, from nothing."""
    libraries, release = (Path(each).resolve() for each in arguments)
    failed = 0
    here = f"{platform.system().lower()}-{platform.machine()}"
    for name, each in PLATFORMS.items():
        path = libraries / name / each.file
        wrong, told = faults(name, path), []
        if name == here or name in _RUNNERS:
            try:
                with tempfile.TemporaryDirectory() as folder:
                    told = [run(name, path, Path(folder))]
            except (OSError, subprocess.SubprocessError) as error:
                wrong = [*wrong, str(error)]
        told = wrong or ["shows the interface alone, needs nothing unusual", *told]
        print(f"{'FAILED' if wrong else 'ok':6} {name:15} {'; '.join(told)}")
        failed += bool(wrong)
    with tempfile.TemporaryDirectory() as folder:
        again = build(here, Path(folder), Path(folder) / "cache").read_bytes()
    if again != (libraries / here / PLATFORMS[here].file).read_bytes():
        print(f"FAILED {here} differs when it is compiled again")
        failed += 1
    for line in (release / SUMS).read_text(encoding="ascii").splitlines():
        digest, _, file = line.partition("  ")
        if hashlib.sha256((release / file).read_bytes()).hexdigest() != digest:
            print(f"FAILED {file} is not the one that was summed up")
            failed += 1
        for fault in file_faults(release / file):
            print(f"FAILED {file}: {fault}")
            failed += 1
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
