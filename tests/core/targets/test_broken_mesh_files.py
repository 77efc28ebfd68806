# SPDX-License-Identifier: LGPL-2.1-or-later
"""Broken mesh files of all formats: a divided body or one sentence, within a minute and 2 GB, nothing left.

Each lot is read in a process of its own with limits on its time and its memory.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from broken_meshes import broken_file

COUNT = int(os.environ.get("BALLOON_MESHES", "6"))
#: Meshes of up to a million triangles among them, in `make fuzz`.
HUGE = int(os.environ.get("BALLOON_HUGE_MESHES", "0"))
_LOT, _SECONDS, _BYTES = 12, 60, 2 << 30
_READER = """
import sys, time
from pathlib import Path
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.read_target import read_target
for path in map(Path, sys.argv[2:]):
    start = time.process_time()
    try:
        target = read_target(path, width=0.3)
        made = divide(target, 6)
        assert (made.target.twins >= 0).all(), "not closed"
        assert made.target.volume > 0.0, "inside out"
        said = f"a body of {len(made.names)} panels."
    except BalloonError as error:
        said = str(error)
    taken = time.process_time() - start
    assert taken < float(sys.argv[1]), f"{path.name}: {taken} s"
    print(path.name, said, sep="\\t", flush=True)
"""


def read(paths: list[Path], folder: Path) -> list[str]:
    """What reading each of these files says, a line each."""
    environment = {**os.environ, "TMPDIR": str(folder / "temporary"), "OPENBLAS_NUM_THREADS": "1"}
    (folder / "temporary").mkdir(exist_ok=True)
    done = subprocess.run(
        [sys.executable, "-c", _READER, str(_SECONDS), *map(str, paths)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (_BYTES, _BYTES)),
    )
    said = done.stdout.splitlines()
    assert done.returncode == 0, (paths[len(said)].name, done.stderr[-1500:])
    assert not any((folder / "temporary").iterdir())
    return said


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, COUNT, _LOT))
def test_a_body_or_one_sentence(first: int, tmp_path: Path) -> None:
    paths = [broken_file(number, tmp_path) for number in range(first, min(first + _LOT, COUNT))]
    for line in read(paths, tmp_path):
        _, _, said = line.partition("\t")
        assert said.endswith("."), line
        assert "Traceback" not in said, line
    assert sorted(tmp_path.iterdir()) == sorted([*paths, tmp_path / "temporary"])


@pytest.mark.parametrize("number", range(HUGE))
def test_huge_ones(number: int, tmp_path: Path) -> None:
    random = np.random.default_rng(number)
    path = broken_file(number, tmp_path, int(10.0 ** random.uniform(5.0, 6.0)))
    assert read([path], tmp_path)[0].endswith(".")
