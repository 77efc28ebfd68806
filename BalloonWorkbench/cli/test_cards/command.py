# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command test-card: makes a card, or keeps the settings of its best field."""

from __future__ import annotations

import argparse
from dataclasses import fields
from pathlib import Path

from BalloonWorkbench.cli import console
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.test_cards.job import keep_field, write_card
from BalloonWorkbench.core.types import Say


def run(options: argparse.Namespace, say: Say) -> int:
    """Do what the options say; the exit code. Raises BalloonError."""
    lines = _keep(options) if options.card is not None else _make(options)
    return 0 if console.show("\n".join(map(say, lines)) + "\n") is None else console.UNSHOWN


def _make(options: argparse.Namespace) -> list[str]:
    if options.machine is None or options.out is None:
        raise InputError("A test card is for a machine, in a folder: give --machine and --out.")
    values = {field.name: getattr(options, field.name) for field in fields(ToolOptions)}
    tried = {name: value if isinstance(value, list) else [value] for name, value in values.items() if value}
    card, paths = write_card(options.machine, tried, options.out, options.bed)
    columns, rows = ", ".join(card.columns), ", ".join(card.rows)
    return [f"Columns from the left: {columns}", f"Rows from below: {rows}", *_written(paths)]


def _keep(options: argparse.Namespace) -> list[str]:
    if options.keep is None or options.name is None:
        raise InputError("Of a card one field is kept: give --keep B3, or another one, and --name.")
    path = keep_field(options.card, options.keep, options.name)
    return [*_written((path,)), f"Use it as --machine {path.stem}; in FreeCAD it is among the machines."]


def _written(paths: tuple[Path, ...]) -> list[str]:
    return [f"Wrote {path}" for path in paths]
