# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forge's workflows: what they run exists, what they may do is little, and a release arrives whole."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
MANIFEST = ElementTree.parse(ROOT / "package.xml").getroot()
VERSION = str(MANIFEST.findtext("{*}version"))
ADDRESS = str(MANIFEST.findtext("{*}url[@type='repository']"))
#: What a runner or Debian brings, besides our own make and .ci/run.
PROGRAMS = {"apt-get", "git", "grep", "gh", "cd", "sha256sum", "if", "fi", "make", ".ci/run"}


def workflow(name: str) -> dict[Any, Any]:
    return yaml.safe_load((ROOT / ".github" / "workflows" / f"{name}.yml").read_text(encoding="utf-8"))


def jobs() -> dict[str, dict[str, Any]]:
    return {f"{path.stem}/{name}": job for path in FILES for name, job in workflow(path.stem)["jobs"].items()}


def scripts(job: dict[str, Any]) -> list[str]:
    return [step["run"] for step in job["steps"] if "run" in step]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_actions_are_pinned_by_their_commit(path: Path) -> None:
    used = re.findall(r"uses:.*", path.read_text(encoding="utf-8"))
    assert used
    assert all(re.fullmatch(r"uses: [\w-]+/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line) for line in used), (
        used
    )


@pytest.mark.parametrize("name", jobs())
def test_a_job_ends_and_may_do_little(name: str) -> None:
    """What compiles or tests foreign code may not write; what may write runs nothing of the repository."""
    job = jobs()[name]
    assert 0 < job["timeout-minutes"] <= 150
    allowed = job.get("permissions", workflow(name.partition("/")[0])["permissions"])
    writes = [scope for scope, level in allowed.items() if level != "read"]
    ours = [line for line in scripts(job) if re.search(r"\bmake\b|\.ci/|tools/|python", line)]
    assert not (writes and ours)
    assert set(writes) <= {"contents"}
    assert all("${{" not in line for line in scripts(job)), "values of the forge come through the environment"
    checkouts = [step for step in job["steps"] if "actions/checkout" in step.get("uses", "")]
    assert all(step["with"]["persist-credentials"] is False for step in checkouts)


@pytest.mark.parametrize("name", jobs())
def test_what_it_runs_exists(name: str) -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    phony = set(str(re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)[1]).split())
    for script in scripts(jobs()[name]):
        lines = script.replace("\\\n", " ").splitlines()
        for command in [part.strip() for line in lines for part in line.split("&&")]:
            assert command.split()[0] in PROGRAMS, command
            if command.startswith("make "):
                assert set(command.split()[1:]) <= phony, command
    assert (ROOT / ".ci" / "run").stat().st_mode & 0o111


def test_the_check_is_the_one_of_this_machine() -> None:
    assert [line for line in scripts(jobs()["check/check"]) if "git" not in line] == [".ci/run"]


def stub(folder: Path, *names: str) -> dict[str, str]:
    """An environment in which some programs do nothing but note how they were called."""
    folder.mkdir()
    for name in names:
        (folder / name).write_text(f'#!/bin/sh\necho "{name} $*" >>"{folder}/calls"\n')
        (folder / name).chmod(0o755)
    server, _, path = ADDRESS.rpartition("/")
    return {
        "PATH": f"{folder}:{os.environ['PATH']}",
        "HOME": str(folder),
        "GITHUB_REF_NAME": f"v{VERSION}",
        "GITHUB_SERVER_URL": server,
        "GITHUB_REPOSITORY": path,
        "GIT_CONFIG_NOSYSTEM": "1",
    }


def ran(script: str, folder: Path, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """A step as the forge runs it."""
    return subprocess.run(
        ["bash", "-e", "-c", script], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize(
    ("change", "passes"),
    [({}, True), ({"GITHUB_REF_NAME": "v9.9.9"}, False), ({"GITHUB_REPOSITORY": "fork"}, False)],
)
def test_only_our_version_at_our_address_is_published(
    tmp_path: Path, change: dict[str, str], passes: bool
) -> None:
    (step,) = [script for script in scripts(jobs()["release/build"]) if "grep" in script]
    assert (ran(step, ROOT, {**stub(tmp_path / "bin"), **change}).returncode == 0) == passes


def commit(folder: Path, text: str) -> None:
    (folder / "file").write_text(text)
    for arguments in (
        ["add", "."],
        ["-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "-q", "-m", text],
    ):
        subprocess.run(["git", *arguments], cwd=folder, check=True)


@pytest.mark.parametrize("releases", [0, 1])
def test_a_release_arrives_on_top_of_those_before(tmp_path: Path, releases: int) -> None:
    """The steps with git, from a clone of the forge's repository to a push there; the rest only is noted."""
    forge, source = tmp_path / "forge" / "project", tmp_path / "source"
    environment = stub(tmp_path / "bin", "gh", "make", "apt-get")
    environment |= {"GITHUB_SERVER_URL": str(forge.parent), "GITHUB_REPOSITORY": forge.name}
    git = ["git", "-c", "init.defaultBranch=main"]
    subprocess.run([*git, "init", "-q", str(source)], check=True)
    commit(source, "main")
    if releases:
        subprocess.run(["git", "checkout", "-q", "--orphan", "release"], cwd=source, check=True)
        commit(source, "first release")
        subprocess.run(["git", "checkout", "-q", "main"], cwd=source, check=True)
    subprocess.run(["git", "clone", "-q", "--bare", str(source), str(forge)], check=True)
    work = tmp_path / "work"
    subprocess.run(["git", "clone", "-q", "--branch", "main", str(forge), str(work)], check=True)

    steps = [script for script in scripts(jobs()["release/build"]) if "grep" not in script]
    at = steps.index("make release-branch")
    before, after = [each for each in steps[:at] if "origin/release" in each], steps[at + 1 :]
    for step in before:
        assert ran(step, work, environment).returncode == 0
    start = ["checkout", "-q", "release"] if releases else ["checkout", "-q", "--orphan", "release"]
    subprocess.run(["git", *start], cwd=work, check=True)
    commit(work, "next release")
    (work / "build" / "release").mkdir(parents=True)
    content = b"packed"
    (work / "build" / "release" / "a.zip").write_bytes(content)
    (work / "build" / "release" / "SHA256SUMS").write_text(f"{hashlib.sha256(content).hexdigest()}  a.zip\n")
    for step in after:
        assert ran(step, work, environment).returncode == 0

    here = tmp_path / "publishes"
    here.mkdir()
    (work / "build").rename(here / "made")  # what is uploaded of it, downloaded
    for step in scripts(jobs()["release/publish"]):
        ended = ran(step, here, environment)
        assert ended.returncode == 0, ended.stderr
    log = subprocess.run(
        ["git", "log", "--format=%s", "release"], cwd=forge, capture_output=True, text=True, check=True
    )
    assert log.stdout.splitlines() == ["next release", "first release"][: releases + 1]
    assert f"gh release create v{VERSION} " in (tmp_path / "bin" / "calls").read_text()
    assert "made/release/SHA256SUMS made/release/a.zip" in (tmp_path / "bin" / "calls").read_text()
    (here / "made" / "release" / "a.zip").write_bytes(b"changed")
    assert ran(scripts(jobs()["release/publish"])[0], here, environment).returncode != 0
