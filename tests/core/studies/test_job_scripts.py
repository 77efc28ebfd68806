# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripts for other machines: as their programs read them, and over a real SSH server."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.runners.job_scripts import (
    SCRIPTS,
    kubernetes_job,
    slurm_script,
    ssh_script,
)

ROOT = Path(__file__).resolve().parents[3]
ODD = ["study", "/a b/it's $HOME.csv", "--out", "/a b/out"]
SETTINGS = {"hosts": ["h"], "image": "i", "claim": "c", "python": "python3"}


def run_with(script: str, place: Path, **environment: str) -> list[list[str]]:
    """The commands that a shell script starts, with their arguments, in the place of Python and SSH."""
    for name in ("env", "ssh"):
        path = place / name
        path.write_text(f"#!{sys.executable}\nimport json, sys\nprint(json.dumps(sys.argv[1:]))\n")
        path.chmod(0o755)
    ended = subprocess.run(
        ["bash", "-c", script],
        env={"PATH": f"{place}:{os.environ['PATH']}", **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    return sorted(json.loads(line) for line in ended.stdout.splitlines())


def test_a_batch_script_of_slurm(tmp_path: Path) -> None:
    settings = SETTINGS | {"time": "01:00:00", "cpus-per-task": 4, "program": "/opt/film balloon"}
    text = slurm_script(ODD, 20, settings)
    lines = text.splitlines()
    assert lines[0] == "#!/bin/bash"
    assert lines[1:5] == [
        "#SBATCH --job-name=balloons", "#SBATCH --array=1-20", "#SBATCH --time=01:00:00",
        "#SBATCH --cpus-per-task=4",
    ]  # fmt: skip
    (asked,) = run_with(text, tmp_path, SLURM_ARRAY_TASK_ID="7", SLURM_CPUS_PER_TASK="4")
    start = ["PYTHONPATH=/opt/film balloon", "python3", "-m", "BalloonWorkbench", *ODD]
    assert asked == [*start, "--shard", "7/20", "--jobs", "4"]


def test_a_job_of_kubernetes(tmp_path: Path) -> None:
    """https://kubernetes.io/docs/concepts/workloads/controllers/job/: indices run from 0."""
    job = json.loads(kubernetes_job(ODD, 20, SETTINGS | {"program": "/opt", "mount": "/data"}))
    assert (job["apiVersion"], job["kind"]) == ("batch/v1", "Job")
    spec = job["spec"]
    assert (spec["completions"], spec["completionMode"]) == (20, "Indexed")
    pod = spec["template"]["spec"]
    assert pod["restartPolicy"] in ("Never", "OnFailure")
    (container,) = pod["containers"]
    assert container["image"] == "i"
    assert container["volumeMounts"][0]["name"] == pod["volumes"][0]["name"]
    assert container["volumeMounts"][0]["mountPath"] == "/data"
    assert pod["volumes"][0]["persistentVolumeClaim"] == {"claimName": "c"}
    (asked,) = run_with(shlex.join(container["command"]), tmp_path, JOB_COMPLETION_INDEX="19")
    assert asked[-6:] == [*ODD[-2:], "--shard", "20/20", "--jobs", "1"]


def test_a_script_for_ssh_has_each_share_once(tmp_path: Path) -> None:
    *shares, last = run_with(ssh_script(ODD, 3, SETTINGS | {"hosts": ["one", "user@two"]}), tmp_path)
    assert last[-1] == "--collect"
    assert sorted(shlex.split(share[-1])[-1] for share in shares) == ["1/3", "2/3", "3/3"]
    assert sorted(share[-2] for share in shares) == ["one", "one", "user@two"]
    assert shlex.split(shares[0][-1])[2:-2] == ["python3", "-m", "BalloonWorkbench", *ODD]


@pytest.mark.parametrize(
    ("kind", "lacking"), [("ssh", "hosts"), ("kubernetes", "image"), ("kubernetes", "claim")]
)
def test_settings_that_lack_something(kind: str, lacking: str) -> None:
    with pytest.raises(InputError, match=lacking):
        SCRIPTS[kind](ODD, 2, {name: value for name, value in SETTINGS.items() if name != lacking})


@pytest.mark.parametrize("value", ["", "a\n#SBATCH --uid=0"])
def test_an_option_of_sbatch_is_one_line(value: str) -> None:
    with pytest.raises(InputError, match="one line"):
        slurm_script(ODD, 2, {"mem": value})


@pytest.fixture
def ssh(tmp_path: Path) -> Iterator[str]:
    """The command that reaches a server of SSH on this machine."""
    server = shutil.which("sshd", path="/usr/sbin:/usr/bin")
    if server is None or not shutil.which("ssh"):
        pytest.skip("needs openssh-server, of tools/debian-packages-readers.txt")
    for name in ("host", "user"):
        key = ["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(tmp_path / name)]
        subprocess.run(key, check=True, stdin=subprocess.DEVNULL)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (tmp_path / "sshd_config").write_text(
        f"HostKey {tmp_path}/host\nAuthorizedKeysFile {tmp_path}/user.pub\nPidFile none\nStrictModes no\n"
        "PermitRootLogin yes\nUsePAM no\n"
    )
    if os.geteuid() == 0:
        Path("/run/sshd").mkdir(exist_ok=True)
    command = [server, "-D", "-e", "-f", f"{tmp_path}/sshd_config", "-o", f"ListenAddress=127.0.0.1:{port}"]
    running = subprocess.Popen(command, stderr=subprocess.PIPE)
    assert running.stderr is not None
    assert re.search(rb"listening on", running.stderr.readline(), re.IGNORECASE)
    try:
        yield (
            f"ssh -p {port} -i {tmp_path}/user -o BatchMode=yes -o StrictHostKeyChecking=no"
            f" -o UserKnownHostsFile={tmp_path}/known -o LogLevel=ERROR"
        )
    finally:
        running.terminate()
        running.wait()


def test_a_study_over_ssh(ssh: str, tmp_path: Path) -> None:
    """Two shares on a machine that is reached by SSH make the table."""
    cube = ROOT / "resources" / "examples" / "bags" / "cube.json"
    study = tmp_path / "a study.csv"
    study.write_text(
        f"input,command,mesh-size,pressure\n{cube},inflate,80mm,1kPa\n{cube},inflate,80mm,2kPa\n"
    )
    command = ["study", str(study), "--out", str(tmp_path / "out"), "--jobs", "1"]
    script = ssh_script(command, 2, {"hosts": ["127.0.0.1"], "ssh": ssh})
    ended = subprocess.run(["sh", "-c", script], capture_output=True, text=True, check=False, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    first, second = (tmp_path / "out" / "table.csv").read_text().splitlines()[1:]
    assert first.endswith(",yes,yes,,")
    assert second.endswith(",yes,yes,,")
