# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command study takes."""

from __future__ import annotations

import argparse

from BalloonWorkbench.core.studies.job import CLUSTERS, KEPT, MOST_ROWS, TIMEOUT, WHOLE
from BalloonWorkbench.core.studies.runners.job_scripts import SCRIPTS
from BalloonWorkbench.core.units import number_text

STUDY = "study"


def add_study(command: argparse.ArgumentParser) -> None:
    """Add its arguments to a parser."""
    command.add_argument(
        "study",
        metavar="STUDY",
        help="CSV table with a column input and one for each option, or JSON file of a grid",
    )
    command.add_argument("--out", metavar="DIR", required=True, help="folder for the table and the balloons")
    command.add_argument(
        "--jobs", metavar="N", type=int, default=0, help="balloons at a time (default one a processor)"
    )
    command.add_argument(
        "--keep",
        choices=KEPT,
        help="of each balloon: the report, that with a small picture for the page, or all files (default"
        " as the study says, else the report)",
    )
    command.add_argument(
        "--timeout",
        metavar="SECONDS",
        type=float,
        default=TIMEOUT,
        help=f"longest time for one balloon (default {number_text(TIMEOUT)})",
    )
    command.add_argument(
        "--most",
        metavar="N",
        type=int,
        default=MOST_ROWS,
        help=f"how many rows are no accident (default {MOST_ROWS})",
    )
    command.add_argument(
        "--shard", metavar="I/N", type=_share, default=WHOLE, help="only this part of the balloons, no table"
    )
    command.add_argument("--scheduler", metavar="ADDRESS", default="", help="use the workers of this Dask")
    command.add_argument(
        "--dask", choices=CLUSTERS, default="", help="make a cluster of Dask, and work on it"
    )
    command.add_argument(
        "--cluster", metavar="FILE", help="JSON file of what the cluster, or the script, is to be made with"
    )
    way = command.add_mutually_exclusive_group()
    way.add_argument("--dry-run", action="store_true", help="only tell what would be done")
    way.add_argument("--collect", action="store_true", help="only write the table of what is there")
    way.add_argument(
        "--script", choices=SCRIPTS, help="only print a script that has other machines work out the shards"
    )
    command.add_argument("--shards", metavar="N", type=int, default=0, help="into how many, for --script")


def _share(text: str) -> tuple[int, int]:
    number, _, count = text.partition("/")
    share = int(number), int(count)
    if not 1 <= share[0] <= share[1]:
        raise ValueError
    return share
