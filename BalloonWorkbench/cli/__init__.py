# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: options, commands, what they print; the work itself is core's."""

from __future__ import annotations

from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; returns its exit code. Loaded here: what tells that NumPy is missing needs none."""
    from BalloonWorkbench.cli import command_line

    return command_line.main(arguments)
