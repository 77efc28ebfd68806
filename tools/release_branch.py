# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commit what release.py packs to the branch `release`, which the Addon Manager installs from.

    release_branch.py LIBRARIES [REPOSITORY]

One commit a version, on top of the one before; no work tree and no index is touched. The same version
and sources give the same commit on the same parent; once more, nothing changes. REPOSITORY is this one unless
it is given.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from native_libraries import ROOT
from release import SUMS, addon_files

BRANCH = "refs/heads/release"


class Refused(Exception):
    """Why there is no commit, and what to do."""


class Manifest(NamedTuple):
    """What package.xml says of a release."""

    version: str
    date: str
    name: str
    maintainer: str
    email: str


def manifest(content: bytes) -> Manifest:
    """Read package.xml."""
    root = ElementTree.fromstring(content)
    maintainer = root.find("{*}maintainer")
    assert maintainer is not None
    texts = [str(root.findtext(f"{{*}}{tag}")) for tag in ("version", "date", "name")]
    return Manifest(*texts, str(maintainer.text), maintainer.attrib["email"])


def numbers(version: str) -> list[int]:
    """A version as numbers that compare."""
    return [int(number) for number in re.findall(r"\d+", version)]


def _git(repository: Path, *arguments: str, text: str = "", **environment: str) -> str:
    """The output of git. CalledProcessError when it fails."""
    ended = subprocess.run(
        ["git", "-c", "i18n.commitEncoding=UTF-8", *arguments],
        cwd=repository,
        env={**os.environ, **environment},
        input=text.encode(),
        stdout=subprocess.PIPE,
        check=True,
    )
    return ended.stdout.decode().strip()


def written(files: Mapping[str, bytes], repository: Path) -> str:
    """The tree of files by name, written to the repository; returns its hash."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, str(number)) for number in range(len(files))]
        for path, content in zip(paths, files.values(), strict=True):
            path.write_bytes(content)
        listed = "".join(f"{path}\n" for path in paths)
        blobs = _git(repository, "hash-object", "-w", "--no-filters", "--stdin-paths", text=listed).split()
        entries = [f"100644 {blob}\t{name}\0" for blob, name in zip(blobs, files, strict=True)]
        index = str(Path(folder, "index"))
        _git(repository, "update-index", "-z", "--index-info", text="".join(entries), GIT_INDEX_FILE=index)
        return _git(repository, "write-tree", GIT_INDEX_FILE=index)


def released(repository: Path) -> tuple[str, Manifest] | None:
    """The last release's commit and manifest, or None before the first. Refused for another kind."""
    commit = _git(repository, "for-each-ref", "--format=%(objectname)", BRANCH)
    if not commit:
        return None
    names = _git(repository, "ls-tree", "--name-only", commit).splitlines()
    if SUMS not in names or "package.xml" not in names:
        raise Refused("The branch release holds something else than releases: rename it first.")
    return commit, manifest(_git(repository, "show", f"{commit}:package.xml").encode())


def publish(files: Mapping[str, bytes], repository: Path) -> tuple[str, bool]:
    """Commit files by name to the branch. Returns the commit, and whether it is a new one.

    Raises Refused where the branch would lose or change what was released.
    """
    new, before = manifest(files["package.xml"]), released(repository)
    tree = written(files, repository)
    if before is not None:
        commit, last = before
        if _git(repository, "rev-parse", f"{commit}^{{tree}}") == tree:
            return commit, False
        if numbers(new.version) <= numbers(last.version):
            raise Refused(
                f"Version {last.version} is released with other content, and this is {new.version}: "
                "raise the version in package.xml and CHANGELOG.md."
            )
    if f"branch {BRANCH}" in _git(repository, "worktree", "list", "--porcelain").splitlines():
        raise Refused("The branch release is checked out: check out another branch first.")
    person = {
        f"GIT_{role}_{part}": value
        for role in ("AUTHOR", "COMMITTER")
        for part, value in (("NAME", new.maintainer), ("EMAIL", new.email), ("DATE", f"{new.date}T00:00:00Z"))
    }
    parents = [] if before is None else ["-p", before[0]]
    message = f"{new.name} {new.version}\n"
    commit = _git(repository, "commit-tree", tree, *parents, text=message, **person)
    expected = before[0] if before else "0" * len(commit)
    _git(repository, "update-ref", "-m", message.strip(), BRANCH, commit, expected)
    return commit, True


def uncommitted(repository: Path) -> list[str]:
    """The files that differ from the last commit, or are not in it."""
    listed = _git(repository, "status", "--porcelain", "-z").split("\0")
    return [line.split(maxsplit=1)[-1] for line in listed if line]


def main(arguments: list[str]) -> int:
    """Commit the release of this work tree; 1 where that is refused."""
    libraries, *elsewhere = map(Path, arguments)
    try:
        if changed := uncommitted(ROOT):
            raise Refused(f"Not committed: {', '.join(changed[:5])}. Commit it, or stash it, first.")
        commit, is_new = publish(addon_files(libraries), elsewhere[0] if elsewhere else ROOT)
    except Refused as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{'Committed' if is_new else 'The branch release has it already:'} {commit}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
