# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be given on the command line: that of core/options, and what only a command has."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from functools import partial
from typing import Any, NoReturn, TypeVar

from BalloonWorkbench import __version__
from BalloonWorkbench.cli.compare.arguments import COMPARE, WITHOUT, add_compare
from BalloonWorkbench.cli.console import UNSHOWN, complain, show
from BalloonWorkbench.cli.studies.arguments import STUDY, add_study
from BalloonWorkbench.cli.test_cards.arguments import TEST_CARD, add_test_card
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.language.speech import chosen_language, short_names
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.options.option import Kind, Option, options_of
from BalloonWorkbench.core.options.table import options
from BalloonWorkbench.core.options.typed import KINDS, NONE

#: The command that designs nothing.
FETCH = "fetch-solver"
#: Of these kinds 0 lets the engine find the value, as in documents.
_MAY_BE_0 = (Kind.LENGTH, Kind.PRESSURE)

_Declared = TypeVar("_Declared")


class _Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are one line."""

    def error(self, message: str) -> NoReturn:
        raise InputError(f"The options cannot be used ({message}). See --help.")

    def _print_message(self, message: str, file: Any = None) -> None:
        """The help and the version, which are all that it prints."""
        problem = show(message)
        if problem is not None:
            complain(f"This cannot be shown ({problem.strerror}).")
            self.exit(UNSHOWN)


def language_of(arguments: Sequence[str] | None) -> str:
    """The language that the arguments name, else that of the environment; known before all others are read.

    InputError for one that there is not.
    """
    known = _Parser(add_help=False, allow_abbrev=False)
    _add_language(known)
    return chosen_language(known.parse_known_args(arguments)[0].language, os.environ)


def _add_language(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--language",
        metavar="NAME",
        help=f"of all that is told, and of the assembly sheet: {', '.join(short_names())}; by default that of"
        " LC_ALL, LC_MESSAGES or LANG",
    )


def parser() -> argparse.ArgumentParser:
    """What the command line understands; InputError for anything else."""
    known = _Parser(prog="python -m BalloonWorkbench", description="Designs balloons from film.")
    known.add_argument("--version", action="version", version=str(__version__))
    commands = known.add_subparsers(dest="command", required=True, parser_class=_Parser)
    for command in (
        _add_parser(commands, "design", "correct the pattern until the inflated silhouette is the drawing"),
        _add_parser(commands, "inflate", "inflate the outline as it is; it is the pattern"),
    ):
        command.add_argument(
            "input",
            metavar="INPUT",
            help="PNG, JPEG or BMP picture, SVG, DXF or JSON outline, or STL, OBJ, PLY or 3MF body",
        )
        command.add_argument("--out", metavar="DIR", required=True, help="folder for the files")
        _add_language(command)
        _add_options(command)
    compare = _add_parser(commands, COMPARE, "lay a photograph of a balloon, or a scanned panel, over it")
    add_compare(compare)
    _add_language(compare)
    _add_options(compare, WITHOUT)
    study = _add_parser(commands, STUDY, "make many balloons, from a table of options or a grid")
    add_study(study)
    _add_language(study)
    card = _add_parser(commands, TEST_CARD, "try settings of a tool on a card, and keep the best")
    add_test_card(card)
    _add_language(card)
    commands.add_parser(
        FETCH,
        help="fetch the native solver from the network, where the workbench came without it",
        description="Fetches the native solver of this version, checks its SHA-256 and puts it in its place.",
    )
    return known


def _add_parser(commands: Any, name: str, purpose: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name, help=purpose, description=f"{purpose[0].upper()}{purpose[1:]}."
    )
    return parser


def _add_options(command: argparse.ArgumentParser, without: Sequence[type] = ()) -> None:
    """All that core/options declares for the command line, by topic; without those of some dataclasses."""
    places: dict[str, Any] = {}
    left_out = {option.key for declaring in without for option in options_of(declaring)}
    for option in options():
        if not option.flag_name or option.key in left_out:
            continue
        if option.topic not in places:
            places[option.topic] = command.add_argument_group(option.topic.lower())
        place = places[option.topic]
        if option.rivals and option.rivals not in places:
            places[option.rivals] = place.add_mutually_exclusive_group()
        place = places[option.rivals or option.topic]
        place.add_argument(option.flag_name, dest=option.key, **_argument(option))
    places["solver"].add_argument(
        "--no-native", action="store_const", const="numpy", dest="solver", help="same as --solver numpy"
    )


def _argument(option: Option) -> dict[str, Any]:
    """How argparse reads an option."""
    arguments: dict[str, Any] = {"help": help_text(option).replace("%", "%%"), "default": option.default}
    if isinstance(option.default, bool):
        return arguments | {"action": "store_false" if option.default else "store_true"}
    name, read, _ = KINDS[option.kind]
    arguments["type"] = partial(read, plain=option.plain) if option.plain else read
    if isinstance(option.default, tuple):
        arguments |= {"action": "append", "default": []}
    if option.kind is Kind.CHOICE and not option.metavar:
        none = [NONE] if option.switch else []
        return arguments | {"choices": [*(value for value in option.titles if value is not None), *none]}
    if option.switch:
        arguments |= {"nargs": "?", "const": True}
    return arguments | {"metavar": option.metavar or name}


def metavar(option: Option) -> str:
    """What is typed after an option: its kind of value, or what may be chosen."""
    arguments = _argument(option)
    choices = (
        "{" + ",".join(arguments["choices"]) + "}" if "choices" in arguments else arguments.get("metavar", "")
    )
    return f"[{choices}]" if "nargs" in arguments else choices


def help_text(option: Option) -> str:
    """A line about an option on the command line, with what may be chosen and the default."""
    text = option.typed or option.text
    if option.kind is Kind.CHOICE and option.metavar:
        known = machines() if option.name == "machine" else option.titles  # the user may have others
        text += f": {', '.join(known)}"
    if isinstance(option.default, (bool, tuple)) or option.default in (None, ""):
        return text
    return f"{text} (default {KINDS[option.kind][2](option.default).replace(' ', '')})"


def typed(arguments: argparse.Namespace, declaring: type[_Declared]) -> _Declared:
    """The options of a dataclass as they were typed."""
    values: dict[str, Any] = {}
    for option in options_of(declaring):  # type: ignore[arg-type]  # mypy does not see that a class has a hash
        if not option.flag_name:
            continue
        value = getattr(arguments, option.key)
        if option.switch:
            values[option.switch] = value not in (None, NONE)
            value = option.default if value == NONE or value is True else value
        if value == 0.0 and option.default is None and option.kind in _MAY_BE_0 and not option.rivals:
            value = None
        values[option.name] = value
    return declaring(**values)
