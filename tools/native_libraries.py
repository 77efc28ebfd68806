# SPDX-License-Identifier: LGPL-2.1-or-later
"""The native library for five platforms, compiled with Zig on any of them.

    native_libraries.py FOLDER [PLATFORM...]

writes FOLDER/PLATFORM/LIBRARY, and FOLDER/versions.json: what is compiled in. The same sources and compiler
give the same bytes.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
NATIVE = ROOT / "BalloonWorkbench" / "native"
EIGEN = Path("/usr/include/eigen3")


class Platform(NamedTuple):
    """One platform: as Zig calls it, the file, what goes to the linker, the tag of its wheel."""

    target: str
    file: str
    link: tuple[str, ...]
    wheel: str


_LINUX = ("-Wl,-soname,libfilm_solver.so", f"-Wl,--version-script={NATIVE / 'exports.map'}")
_MACOS = ("-Wl,-install_name,@rpath/libfilm_solver.dylib",)

#: By the name of the folder that core/solver/native/library.py looks into.
PLATFORMS = {
    "linux-x86_64": Platform(
        "x86_64-linux-gnu.2.17", "libfilm_solver.so", _LINUX, "manylinux_2_17_x86_64.manylinux2014_x86_64"
    ),
    "linux-aarch64": Platform(
        "aarch64-linux-gnu.2.28", "libfilm_solver.so", _LINUX, "manylinux_2_28_aarch64"
    ),
    "windows-x86_64": Platform("x86_64-windows-gnu", "film_solver.dll", (), "win_amd64"),
    "macos-x86_64": Platform("x86_64-macos.11.0", "libfilm_solver.dylib", _MACOS, "macosx_11_0_x86_64"),
    "macos-aarch64": Platform("aarch64-macos.11.0", "libfilm_solver.dylib", _MACOS, "macosx_11_0_arm64"),
}

# as in native/CMakeLists.txt
_FLAGS = (
    *("-std=c++17", "-O3", "-DNDEBUG", "-DFILM_SOLVER_BUILD", "-DEIGEN_MPL2_ONLY"),
    *("-fvisibility=hidden", "-fvisibility-inlines-hidden", "-ffile-prefix-map=.=native", "-w"),
    *("-isystem", str(EIGEN), "-Iinclude", "-I.", "-shared", "-s"),
)


CACHE = ROOT / "build" / "zig"


def zig(*arguments: str | Path, cache: Path = CACHE) -> None:
    """Run Zig in the folder of the solver. CalledProcessError when it fails."""
    environment = {**os.environ, "ZIG_GLOBAL_CACHE_DIR": str(cache), "ZIG_LOCAL_CACHE_DIR": str(cache)}
    command = [sys.executable, "-m", "ziglang", *map(str, arguments)]
    subprocess.run(command, check=True, cwd=NATIVE, env=environment)


def build(name: str, folder: Path, cache: Path = CACHE) -> Path:
    """Compile the library of a platform into FOLDER/NAME."""
    platform = PLATFORMS[name]
    path = folder.resolve() / name / platform.file
    path.parent.mkdir(parents=True, exist_ok=True)
    sources = sorted(str(source.relative_to(NATIVE)) for source in NATIVE.rglob("*.cpp"))
    zig("c++", "-target", platform.target, *_FLAGS, *platform.link, "-o", path, *sources, cache=cache)
    for beside in path.parent.iterdir():  # import libraries and debugging files
        if beside != path:
            beside.unlink()
    return path


def versions() -> dict[str, str]:
    """The versions of what is compiled into the libraries, as their own headers give them."""
    package = importlib.util.find_spec("ziglang")
    if package is None or package.origin is None:
        raise ModuleNotFoundError("ziglang")
    zig_library = Path(package.origin).parent / "lib"

    def numbers(header: Path, *names: str) -> list[str]:
        text = header.read_text(encoding="utf-8")
        return [re.search(rf"# *define {name} +(\d+)", text)[1] for name in names]

    (llvm,) = numbers(zig_library / "libcxx/include/__config", "_LIBCPP_VERSION")  # 220108 is 22.1.8
    mingw = [f"__MINGW64_VERSION_{name}" for name in ("MAJOR", "MINOR", "BUGFIX")]
    eigen = [f"EIGEN_{name}_VERSION" for name in ("WORLD", "MAJOR", "MINOR")]
    return {
        "Eigen": ".".join(numbers(EIGEN / "Eigen/src/Core/util/Macros.h", *eigen)),
        "LLVM": ".".join(str(int(llvm[at : at + 2])) for at in (0, 2, 4)),
        "mingw-w64": ".".join(numbers(zig_library / "libc/include/any-windows-any/_mingw_mac.h", *mingw)),
        "Zig": importlib.metadata.version("ziglang"),
    }


def main(arguments: list[str]) -> None:
    """Compile the named platforms, or all of them."""
    folder, *names = arguments
    for name in names or PLATFORMS:
        path = build(name, Path(folder))
        print(f"{path.stat().st_size:8d} bytes  {path}")
    (Path(folder) / "versions.json").write_text(json.dumps(versions()), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
