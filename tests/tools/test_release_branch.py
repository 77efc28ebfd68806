# SPDX-License-Identifier: LGPL-2.1-or-later
"""The branch that the Addon Manager installs from, in repositories made for it."""

from __future__ import annotations

import hashlib
import importlib
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
#: A library is bytes; a text keeps its line ends and letters.
OTHERS = {"lib/x.so": bytes(range(256)), "docs/größe.md": "größer\r\nals\n".encode(), "Init.py": b""}


@pytest.fixture(scope="module")
def branch() -> Iterator[ModuleType]:
    """The program that commits releases."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(ROOT / "tools"))
        yield importlib.import_module("release_branch")


def git(folder: Path, *arguments: str) -> str:
    ended = subprocess.run(["git", *arguments], cwd=folder, check=True, capture_output=True)
    return ended.stdout.decode().rstrip("\n")


def repository(folder: Path, name: str = "Somebody") -> Path:
    """One with a commit, a change that is staged and one that is not."""
    folder.mkdir()
    git(folder, "init", "-q", "-b", "main")
    for key, value in {"user.name": name, "user.email": f"{name}@example.org"}.items():
        git(folder, "config", key, value)
    (folder / "Init.py").write_text("first\n")
    git(folder, "add", ".")
    git(folder, "commit", "-q", "-m", "Start")
    (folder / "staged.py").write_text("staged\n")
    git(folder, "add", ".")
    (folder / "Init.py").write_text("changed\n")
    return folder


def files(version: str, **more: bytes) -> dict[str, bytes]:
    text = (ROOT / "package.xml").read_text(encoding="utf-8")
    start, end = text.index("<version>"), text.index("</version>")
    changed = f"{text[:start]}<version>{version}{text[end:]}"
    return {**OTHERS, **more, "package.xml": changed.encode(), "SHA256SUMS": b"sums\n"}


def state(folder: Path) -> tuple[str, str, str]:
    """What a user sees of the work tree and the index, and where he is."""
    index = hashlib.sha256((folder / ".git" / "index").read_bytes()).hexdigest()
    return git(folder, "status", "--porcelain"), git(folder, "symbolic-ref", "HEAD"), index


def test_a_release_is_one_commit_with_the_files_alone(branch: ModuleType, tmp_path: Path) -> None:
    home = repository(tmp_path / "home")
    before = state(home)
    first, is_new = branch.publish(files("1.9.0"), home)
    assert is_new
    second, _ = branch.publish(files("1.10.0", added=b"new\n"), home)
    assert state(home) == before
    assert git(home, "log", "--format=%H %s", "release").splitlines() == [
        f"{second} Film Balloon 1.10.0",
        f"{first} Film Balloon 1.9.0",
    ]
    clone = tmp_path / "clone"
    git(tmp_path, "clone", "-q", "--branch", "release", "-c", "core.autocrlf=false", str(home), str(clone))
    found = {
        path.relative_to(clone).as_posix(): path.read_bytes()
        for path in clone.rglob("*")
        if path.is_file() and ".git" not in path.parts
    }
    assert found == files("1.10.0", added=b"new\n")


def test_the_same_release_is_the_same_commit_anywhere(
    branch: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here, there = repository(tmp_path / "here"), repository(tmp_path / "there", "Else")
    commits = [branch.publish(files(version), here)[0] for version in ("1.0.0", "1.0.1")]
    for key, value in {
        "core.autocrlf": "true",
        "i18n.commitEncoding": "ISO-8859-1",
        "core.fileMode": "false",
        "commit.gpgSign": "true",
    }.items():
        git(there, "config", key, value)
    monkeypatch.setenv("TZ", "Pacific/Auckland")
    monkeypatch.setenv("GIT_AUTHOR_NAME", "Nobody")
    mask = os.umask(0o077)
    try:
        assert [branch.publish(files(version), there)[0] for version in ("1.0.0", "1.0.1")] == commits
    finally:
        os.umask(mask)
    # Debian's git, asked for what package.xml has
    told = branch.manifest(files("1.0.1")["package.xml"])
    assert git(there, "log", "-1", "--format=%an <%ae> %aI = %cn <%ce> %cI", "release") == " = ".join(
        [f"{told.maintainer} <{told.email}> {told.date}T00:00:00+00:00"] * 2
    )


def test_once_more_changes_nothing(branch: ModuleType, tmp_path: Path) -> None:
    home = repository(tmp_path / "home")
    commit, _ = branch.publish(files("1.0.0"), home)
    assert branch.publish(files("1.0.0"), home) == (commit, False)
    assert git(home, "rev-parse", "release") == commit


@pytest.mark.parametrize("version", ["1.10.0", "1.9.9", "0.1.0"])
def test_what_was_released_stays(branch: ModuleType, tmp_path: Path, version: str) -> None:
    home = repository(tmp_path / "home")
    commit, _ = branch.publish(files("1.10.0"), home)
    with pytest.raises(branch.Refused, match="raise the version"):
        branch.publish(files(version, added=b"new\n"), home)
    assert git(home, "rev-parse", "release") == commit


def test_a_branch_of_another_kind_stays(branch: ModuleType, tmp_path: Path) -> None:
    home = repository(tmp_path / "home")
    (home / "package.xml").write_bytes(files("0.1.0")["package.xml"])
    git(home, "add", "package.xml")
    git(home, "commit", "-q", "-m", "What releases are made from")
    git(home, "branch", "release")
    before = git(home, "rev-parse", "release")
    with pytest.raises(branch.Refused, match="rename it"):
        branch.publish(files("1.0.0"), home)
    assert git(home, "rev-parse", "release") == before


def test_a_checked_out_branch_stays(branch: ModuleType, tmp_path: Path) -> None:
    """Its work tree would seem to take the release back."""
    home = repository(tmp_path / "home")
    commit, _ = branch.publish(files("1.0.0"), home)
    git(home, "worktree", "add", "-q", str(tmp_path / "beside"), "release")
    with pytest.raises(branch.Refused, match="checked out"):
        branch.publish(files("1.0.1"), home)
    assert git(home, "rev-parse", "release") == commit


def test_what_is_not_committed_is_named(branch: ModuleType, tmp_path: Path) -> None:
    home = repository(tmp_path / "home")
    (home / "new.cpp").write_text("compiled too\n")
    assert set(branch.uncommitted(home)) == {"Init.py", "new.cpp", "staged.py"}
