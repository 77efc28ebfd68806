# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two ways: settings in, the files of a card out; the best field in, a machine of the user's own out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.machines.machine import machine
from BalloonWorkbench.core.machines.own.keep import keep_machines, machine_data
from BalloonWorkbench.core.test_cards.card import SettingsCard, make_card
from BalloonWorkbench.core.test_cards.files import card_files
from BalloonWorkbench.core.test_cards.keep import kept_machine


def write_card(
    name: str, tried: Mapping[str, Sequence[Any]], folder: str | Path, bed: str | None = None
) -> tuple[SettingsCard, tuple[Path, ...]]:
    """Make the card of a machine and write its files into a folder; tried as for `make_card`, bed as for
    `machine`. Raises BalloonError, and writes nothing then.
    """
    check_folder(folder)
    card = make_card(machine(name, bed), tried)
    return card, write_files(folder, card_files(card, machine_data(name)))


def keep_field(card: str | Path, field: str, name: str) -> Path:
    """Keep what a field of a card tried as a machine of the user's own of that name; returns its file.

    Raises what `kept_machine` and `keep_machines` raise.
    """
    return keep_machines([("", kept_machine(Path(card), field, name))])[0]
