# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels from the command line: which options make sense for them, and their file."""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.form import PANELS, form_of

if TYPE_CHECKING:
    from BalloonWorkbench.core.bag_job import FinishedBags


def check(options: argparse.Namespace) -> None:
    """Raise InputError for options that make no sense together, before the work."""
    round_body = options.gores is not None or options.accuracy is not None
    if options.artwork_back is not None and (round_body or form_of(options.input) not in (None, PANELS)):
        raise InputError("The picture of a body of gores goes all round: leave out --artwork-back.")
    if form_of(options.input) != PANELS:
        return
    if options.command == "design":
        raise InputError(
            f"'{options.input}' has its panels as they are to be cut: use inflate instead of design."
        )


@contextmanager
def file_of(path: str, made: FinishedBags) -> Iterator[str]:
    """The file of what was made: panels that were made at another size are written into one of that name."""
    from BalloonWorkbench.core.bags.bag import Bag
    from BalloonWorkbench.core.bags.read_bag import bag_json

    source = made.sources[0]
    if not isinstance(source, Bag):
        yield path
        return
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / Path(path).name
        file.write_bytes(bag_json(source))
        yield str(file)
