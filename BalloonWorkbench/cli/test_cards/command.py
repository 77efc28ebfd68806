# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command test-card: makes a card, or keeps the settings of its best field."""

from __future__ import annotations

import argparse
from dataclasses import fields
from pathlib import Path

from BalloonWorkbench.cli import console
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.machines.machine import machine, own_folder
from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.test_cards.card import make_card
from BalloonWorkbench.core.test_cards.files import card_files
from BalloonWorkbench.core.test_cards.keep import kept_machine, machine_data
from BalloonWorkbench.core.types import Say


def run(options: argparse.Namespace, say: Say) -> int:
    """Do what the options say; the exit code. Raises BalloonError."""
    lines = _keep(options) if options.card is not None else _make(options)
    return 0 if console.show("\n".join(map(say, lines)) + "\n") is None else console.UNSHOWN


def _make(options: argparse.Namespace) -> list[str]:
    if options.machine is None or options.out is None:
        raise InputError("A test card is for a machine, in a folder: give --machine and --out.")
    check_folder(options.out)
    values = {field.name: getattr(options, field.name) for field in fields(ToolOptions)}
    tried = {name: value if isinstance(value, list) else [value] for name, value in values.items() if value}
    card = make_card(machine(options.machine, options.bed), tried)
    paths = write_files(options.out, card_files(card, machine_data(options.machine)))
    columns, rows = ", ".join(card.columns), ", ".join(card.rows)
    return [f"Columns from the left: {columns}", f"Rows from below: {rows}", *_written(paths)]


def _keep(options: argparse.Namespace) -> list[str]:
    if options.keep is None or options.name is None:
        raise InputError("Of a card one field is kept: give --keep B3, or another one, and --name.")
    folder = own_folder()
    content = kept_machine(Path(options.card), options.keep, options.name)
    if (folder / f"{options.name}.json").exists():
        raise InputError(
            f"There is a machine {options.name} of your own: give another --name, or delete its file."
        )
    paths = write_files(folder, {f"{options.name}.json": content})
    return [*_written(paths), f"Use it as --machine {options.name}; in FreeCAD it is among the machines."]


def _written(paths: tuple[Path, ...]) -> list[str]:
    return [f"Wrote {path}" for path in paths]
