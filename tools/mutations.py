# SPDX-License-Identifier: LGPL-2.1-or-later
"""Break the code in the ways that tests/mutations.json lists, one by one: a quick test must notice each.

mutations.py [WORD...]   only those whose file or test has one of these words in its name

Works on a copy of the tree in build/mutations. Ends with 1 when a mutation survives or no longer applies.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COPY = ROOT / "build" / "mutations"
LEFT_OUT = {".git", ".venv", "build", "out", "__pycache__"}
TESTS_FAILED = 1  # pytest's exit code, and that of tools/test.sh
NATIVE = "BalloonWorkbench/native"


def copy_tree() -> None:
    """Put a fresh copy of the tree in COPY; what CMake has built there stays."""
    COPY.mkdir(parents=True, exist_ok=True)
    for path in COPY.iterdir():
        if path.name not in {"build", ".venv"}:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for path in ROOT.iterdir():
        if path.name in LEFT_OUT:
            continue
        if path.is_dir():
            shutil.copytree(path, COPY / path.name, ignore=shutil.ignore_patterns(*LEFT_OUT), symlinks=True)
        else:
            shutil.copy2(path, COPY / path.name)
    if not (COPY / ".venv").exists():
        (COPY / ".venv").symlink_to(ROOT / ".venv")


def build_native() -> None:
    """Compile the copy's solver."""
    folder = COPY / "build" / "native"
    configure = ["cmake", "-S", str(COPY / NATIVE), "-B", str(folder), "-G", "Ninja"]
    subprocess.run([*configure, "-DCMAKE_BUILD_TYPE=Release"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(folder), "--", "--quiet"], check=True)


def run_test(test: str) -> int:
    """The exit code of a test of the copy."""
    environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1", "FREECAD_USER_HOME": str(COPY / "build")}
    if test.startswith("tests/app"):
        command = ["tools/test.sh", "app"]
        environment["BALLOON_TESTS"] = f"-x {test}"
    else:
        command = [".venv/bin/python", "-m", "pytest", "-q", "-x", test]
    log = COPY / "build" / "test.log"
    with log.open("w") as stream:
        return subprocess.run(
            command, cwd=COPY, env=environment, stdout=stream, stderr=subprocess.STDOUT, check=False
        ).returncode


def outcome(mutation: dict[str, str]) -> str:
    """What became of one mutation: an empty text where the test noticed it."""
    path = COPY / mutation["file"]
    original = path.read_text(encoding="utf-8")
    if original.count(mutation["from"]) != 1:
        return "does not apply"
    native = mutation["file"].startswith(NATIVE)
    path.write_text(original.replace(mutation["from"], mutation["to"]), encoding="utf-8")
    try:
        if native:
            build_native()
        return "" if run_test(mutation["test"]) == TESTS_FAILED else "SURVIVED"
    finally:
        path.write_text(original, encoding="utf-8")
        if native:
            build_native()


def main(words: list[str]) -> int:
    """Try the mutations; 0 when every one is noticed."""
    mutations = json.loads((ROOT / "tests" / "mutations.json").read_text(encoding="utf-8"))
    mutations = [
        one for one in mutations if not words or any(word in one["file"] + one["test"] for word in words)
    ]
    copy_tree()
    build_native()
    for test in sorted({mutation["test"] for mutation in mutations}):
        if run_test(test) != 0:
            print(f"{test} fails without any mutation: see {COPY / 'build' / 'test.log'}")
            return 1
    missed = 0
    for mutation in mutations:
        begun = time.perf_counter()
        what = outcome(mutation)
        missed += bool(what)
        print(
            f"{time.perf_counter() - begun:4.0f} s  {what or 'noticed':14} "
            f"{mutation['file']}: {mutation['from'].strip()} -> {mutation['to'].strip()}",
            flush=True,
        )
    print(f"{len(mutations) - missed} of {len(mutations)} mutations were noticed")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
