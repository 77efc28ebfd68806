# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels from the command line: which options make sense for them."""

from __future__ import annotations

import argparse

from BalloonWorkbench.core.bag_design.source import PANELS, form_of
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.machines.bed import SCALE


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
    if options.oversize == SCALE:
        raise InputError(
            f"'{options.input}' has the size of its panels, so the balloon cannot be scaled to fit: leave out"
            " --oversize scale."
        )
