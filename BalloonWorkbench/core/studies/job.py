# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of a study, as it goes to another process or machine, and what comes back."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

#: What works out a balloon of the command line's options.
BALLOON = "BalloonWorkbench.cli.studies.row"
#: What is kept of a balloon: its report, that and a small picture, or all files that the command line writes.
REPORT, PICTURES, FILES = "report", "pictures", "files"
KEPT = (REPORT, PICTURES, FILES)
#: The file of a small picture.
PICTURE = "small.png"
#: More rows than this are an accident, unless it is said that they are not.
MOST_ROWS = 1_000_000
TIMEOUT = 3600.0  # s for one job
#: Clusters of Dask that are made for a study.
LOCAL, SSH, SLURM, KUBERNETES = CLUSTERS = "local", "ssh", "slurm", "kubernetes"
#: The share (i, n) of a study that is all of it.
WHOLE = (1, 1)


@dataclass(frozen=True)
class Job:
    """Something to be worked out once, and kept in the folder of its key.

    key      SHA-256 of all that decides the result, in hexadecimal
    request  what `task` gets, of what JSON can hold
    task     a module of ours: `make(request) -> dict[str, bytes]` gives the files, report.json among them
    """

    key: str
    request: Mapping[str, Any]
    task: str = BALLOON


@dataclass(frozen=True)
class Finished:
    """A job that ended.

    sentence  empty where its files are in the folder; else what went wrong
    kept      the failure is in the folder too, because it would come again
    ends      nothing else can be done either: a full disk, a folder that vanished
    """

    key: str
    sentence: str = ""
    kept: bool = True
    ends: bool = False


class Runner(Protocol):
    """Where jobs are worked out."""

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        """Work out jobs, in any order, into the folder of a study; each is told as soon as it ended.

        Jobs are taken as they are needed. A generator that is closed stops the work. Raises BalloonError
        where nothing can be worked out at all.
        """
        ...
