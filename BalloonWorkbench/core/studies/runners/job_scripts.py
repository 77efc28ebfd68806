# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scripts that have other machines work out the shares of a study, as text; who starts them is the user."""

from __future__ import annotations

import json
import shlex
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import InputError

_OWN = ("python", "program", "hosts", "ssh", "image", "claim", "mount", "name")
_PROGRAM = str(Path(__file__).resolve().parents[4])
#: Settings of a script in its settings' file, for its sentence.
_NEEDS = {"hosts": '["node1", "node2"]', "image": '"registry/film-balloon"', "claim": '"studies"'}


def slurm_script(command: Sequence[str], shards: int, settings: Mapping[str, Any]) -> str:
    """A batch script for sbatch: an array with a task a share.

    command   what follows `python -m BalloonWorkbench`
    settings  python; program: the folder of BalloonWorkbench there, "" where Python has it; and options of
              sbatch by name: {"time": "01:00:00", "mem": "4G", "cpus-per-task": 4}
    """
    options = {"job-name": settings.get("name", "balloons"), "array": f"1-{shards}"}
    options |= {name: value for name, value in settings.items() if name not in _OWN}
    lines = [f"#SBATCH --{name}={_word(value)}" for name, value in options.items()]
    share = '--shard "${SLURM_ARRAY_TASK_ID}"/' + str(shards)
    return "\n".join(
        [
            "#!/bin/bash",
            *lines,
            f'exec {_started(command, settings)} {share} --jobs "${{SLURM_CPUS_PER_TASK:-1}}"',
            f"# when all are done: {_started(command, settings)} --collect",
            "",
        ]
    )


def kubernetes_job(command: Sequence[str], shards: int, settings: Mapping[str, Any]) -> str:
    """An indexed Job for `kubectl create -f`, as JSON: a pod a share, one processor each.

    settings  image, claim: of the volume that all share; mount: where the study and its folder lie in it,
              /study if not said; name, python
    """
    shell = f"exec {_started(command, {'python': 'python3', 'program': ''} | dict(settings))}"
    shell += f' --shard "$((JOB_COMPLETION_INDEX + 1))"/{shards} --jobs 1'
    claim = {"claimName": _needed(settings, "claim")}
    container = {
        "name": "balloons",
        "image": _needed(settings, "image"),
        "command": ["sh", "-c", shell],
        "resources": {"requests": {"cpu": "1"}, "limits": {"cpu": "1"}},
        "volumeMounts": [{"name": "study", "mountPath": settings.get("mount", "/study")}],
    }
    pod = {
        "restartPolicy": "OnFailure",
        "containers": [container],
        "volumes": [{"name": "study", "persistentVolumeClaim": claim}],
    }
    spec = {
        "completions": shards,
        "parallelism": shards,
        "completionMode": "Indexed",
        "template": {"spec": pod},
    }
    job = {
        "apiVersion": "batch/v1",
        "kind": "Job",
        "metadata": {"name": settings.get("name", "balloons")},
        "spec": spec,
    }
    return json.dumps(job, indent=2) + "\n"


def ssh_script(command: Sequence[str], shards: int, settings: Mapping[str, Any]) -> str:
    """A shell script: each share on the next of the hosts, all at once; then the table, here.

    settings  hosts; python, program: on them; ssh: the command, with its options
    """
    hosts = _needed(settings, "hosts")
    if not isinstance(hosts, list) or not hosts:
        raise InputError(f'"hosts" is no list: write {_NEEDS["hosts"]}.')
    ssh = settings.get("ssh", "ssh -o BatchMode=yes")
    lines = []
    for number in range(1, shards + 1):
        host = shlex.quote(str(hosts[(number - 1) % len(hosts)]))
        there = shlex.quote(f"{_started(command, settings)} --shard {number}/{shards}")
        lines.append(f"{ssh} {host} {there} </dev/null &")
        lines.append('waiting="$waiting $!"')
    return "\n".join(
        [
            "#!/bin/sh",
            "waiting= failed=0",
            *lines,
            'for each in $waiting; do wait "$each" || failed=1; done',
            f"{_started(command, settings)} --collect",
            "exit $failed",
            "",
        ]
    )


SCRIPTS: dict[str, Callable[[Sequence[str], int, Mapping[str, Any]], str]] = {
    "slurm": slurm_script,
    "kubernetes": kubernetes_job,
    "ssh": ssh_script,
}


def _started(command: Sequence[str], settings: Mapping[str, Any]) -> str:
    program = str(settings.get("program", _PROGRAM))
    words = ["env", f"PYTHONPATH={program}"] if program else []
    python = str(settings.get("python", sys.executable))
    return shlex.join([*words, python, "-m", "BalloonWorkbench", *command])


def _needed(settings: Mapping[str, Any], name: str) -> Any:
    if name not in settings:
        raise InputError(f'The settings lack "{name}": write {{"{name}": {_NEEDS[name]}}} into their file.')
    return settings[name]


def _word(value: Any) -> str:
    text = str(value)
    if "\n" in text or not text:
        raise InputError(f"'{text}' is no value for an option of sbatch: write one line.")
    return text
