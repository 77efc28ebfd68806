# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever our own files install of Python is pinned, with the sums of the files that may be installed."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
INSTALLER = ROOT / "tools" / "pip-install.sh"
LISTS = sorted([ROOT / "requirements.in", *ROOT.glob("tools/requirements-*.in")])
PROGRAMS = sorted(
    [
        *(ROOT / "Makefile", ROOT / ".ci" / "run", ROOT / ".pre-commit-config.yaml"),
        *ROOT.glob("tools/*.sh"),
        *ROOT.glob("tools/*.py"),
        *ROOT.glob(".github/**/*.yml"),
    ]
)
#: Everything by which packages of Python come from elsewhere.
_INSTALLS = re.compile(
    r"\b(pip3?|uv|pipx|conda|poetry)\s[^#]*\b(install|download|wheel|sync|add|run)\b|\beasy_install\b"
)


def entries(path: Path) -> list[str]:
    """The packages of a list, each with its options in one line."""
    text = re.sub(r"\s*\\\n\s*", " ", path.read_text(encoding="utf-8"))
    return [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]


def names(lines: list[str]) -> set[str]:
    found = [re.match(r"[\w.-]+", line) for line in lines if not line.startswith("-")]
    return {match[0].lower().replace("_", "-") for match in found if match}


def test_nothing_else_installs() -> None:
    """One program calls pip; a container's or a runner's tools are not ours."""
    found = [
        f"{path.relative_to(ROOT)}: {line.strip()}"
        for path in PROGRAMS
        if path != INSTALLER
        for line in path.read_text(encoding="utf-8").splitlines()
        if _INSTALLS.search(line.partition("#")[0])
    ]
    assert not found


def test_the_one_that_installs_asks_for_sums() -> None:
    (command,) = [line for line in INSTALLER.read_text().splitlines() if "-m pip" in line]
    assert {"--require-hashes", "--no-deps", "--only-binary=:all:"} <= set(shlex.split(command))


@pytest.mark.parametrize("source", LISTS, ids=lambda path: path.name)
def test_every_package_is_pinned_with_its_sums(source: Path) -> None:
    lines = entries(source.with_suffix(".txt"))
    for line in lines:
        assert re.match(
            r"[\w.-]+==[\w.]+ ( *; [^\\]+? )?--hash=sha256:[0-9a-f]{64}( --hash=sha256:[0-9a-f]{64})*$", line
        ), line
    assert names(entries(source)) <= names(lines)
    exact = [line.split(" #")[0].strip() for line in entries(source) if "==" in line]
    for each in exact:  # what is chosen by hand is what is installed
        name, version = re.sub(r"\[.*\]", "", each).split("==")
        assert [line for line in lines if line.startswith(f"{name}=={version} ")], each


def test_every_list_that_is_installed_is_made_from_one() -> None:
    installed = set(re.findall(r"requirements[\w-]*\.txt", "".join(path.read_text() for path in PROGRAMS)))
    assert installed <= {source.with_suffix(".txt").name for source in LISTS}
    assert {
        path.name for path in ROOT.glob("**/requirements*.txt") if not {".venv", "build"} & set(path.parts)
    } == {source.with_suffix(".txt").name for source in LISTS}


def test_a_list_for_other_pythons_is_the_same_for_all() -> None:
    """freecad-root.sh installs it for the Python of another Debian; pip reads markers for its own."""
    assert not [
        line for line in entries(ROOT / "requirements.txt") if "python_" in line.partition("--hash")[0]
    ]


def test_lists_serve_both_machines() -> None:
    """A compiled package has more than one file: its list has the sums of all."""
    text = (ROOT / "requirements.txt").read_text(encoding="utf-8")
    compiled = {line.partition("==")[0]: line.count("--hash") for line in entries(ROOT / "requirements.txt")}
    assert {"shapely", "spyrrow", "pythoncdt"} <= {name for name, sums in compiled.items() if sums >= 10}, (
        text[:200]
    )
