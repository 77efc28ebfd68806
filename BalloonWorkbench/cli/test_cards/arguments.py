# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command test-card takes."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from BalloonWorkbench.core.options.making import ToolOptions
from BalloonWorkbench.core.options.option import Kind, options_of
from BalloonWorkbench.core.options.typed import KINDS

TEST_CARD = "test-card"


def add_test_card(command: argparse.ArgumentParser) -> None:
    """Add its arguments to a parser: those of the tool take several values, with commas between them."""
    command.add_argument(
        "card",
        metavar="CARD",
        nargs="?",
        help="the test-card.json of a card that was made, of which --keep keeps",
    )
    command.add_argument("--machine", metavar="NAME", help="a machine that reads G-code, or its .json file")
    command.add_argument("--bed", metavar="WIDTH[xHEIGHT]", help="how large it is, such as 220mmx220mm")
    command.add_argument("--out", metavar="DIR", help="folder for the files")
    tool = command.add_argument_group("tool, one or two of these with several values, such as 200,300,400")
    for option in options_of(ToolOptions):
        name, read, _ = KINDS[option.kind]
        if option.kind is Kind.CHOICE:
            tool.add_argument(
                option.flag_name, dest=option.name, choices=list(option.titles), help=option.text
            )
            continue
        text = option.text.replace("%", "%%")
        kind = _several(read, name)
        tool.add_argument(
            option.flag_name, dest=option.name, type=kind, metavar=option.metavar or name, help=text
        )
    kept = command.add_argument_group("what came out")
    kept.add_argument("--keep", metavar="FIELD", help="the best field of the card, such as B3")
    kept.add_argument("--name", metavar="NAME", help="of the machine file of your own that gets its settings")


def _several(read: Callable[[str], Any], name: str) -> Callable[[str], list[Any]]:
    def values(text: str) -> list[Any]:
        return [read(part.strip()) for part in text.split(",")]

    values.__name__ = name  # as which argparse complains
    return values
