# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be given on the command line."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from typing import Any, NoReturn

from BalloonWorkbench import __version__
from BalloonWorkbench.cli import making, pattern
from BalloonWorkbench.cli.bed import add_bed
from BalloonWorkbench.cli.console import UNSHOWN, complain, show
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import DEFAULT_GAS, gases
from BalloonWorkbench.core.film.library import DEFAULT_FILM, films
from BalloonWorkbench.core.job import DEFAULT_PRESSURE
from BalloonWorkbench.core.language.speech import language_named, short_names, users_language
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.writers.pdf import TILES
from BalloonWorkbench.core.outline.symmetry import AUTO, CHOICES
from BalloonWorkbench.core.results.result_files import FORMATS
from BalloonWorkbench.core.solver.backend import SOLVERS
from BalloonWorkbench.core.solver.model import BENDING_FLOOR
from BalloonWorkbench.core.tracing.segment import DRAWN_AS

#: The command that designs nothing.
FETCH = "fetch-solver"


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
    name = known.parse_known_args(arguments)[0].language
    return users_language(os.environ) if name is None else language_named(name)


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
    known.add_argument("--version", action="version", version=__version__)
    commands = known.add_subparsers(dest="command", required=True, parser_class=_Parser)
    for command in (
        _add_parser(commands, "design", "correct the pattern until the inflated silhouette is the drawing"),
        _add_parser(commands, "inflate", "inflate the outline as it is; it is the pattern"),
    ):
        command.add_argument(
            "input", metavar="INPUT", help="PNG, JPEG or BMP picture, or SVG, DXF or JSON outline"
        )
        command.add_argument("--out", metavar="DIR", required=True, help="folder for the files")
        _add_language(command)
        _add_size(command)
        load = command.add_mutually_exclusive_group()
        load.add_argument(
            "--pressure", metavar="PRESSURE", default=str(DEFAULT_PRESSURE), help="such as 2kPa (the default)"
        )
        load.add_argument(
            "--gas-volume",
            metavar="VOLUME",
            help="of gas that is filled in, such as 5l, instead of a pressure, which is found",
        )
        command.add_argument(
            "--material", metavar="NAME", help=f"one of {', '.join(films())} (default {DEFAULT_FILM})"
        )
        command.add_argument(
            "--young", metavar="E", type=float, help="Young's modulus of a film of your own [Pa]"
        )
        command.add_argument("--poisson", metavar="NU", type=float, help="its Poisson's ratio")
        command.add_argument("--thickness", metavar="T", type=float, help="its thickness [m]")
        command.add_argument(
            "--young-across",
            metavar="E",
            type=float,
            help="modulus across the grain, for films with one [Pa]",
        )
        command.add_argument(
            "--grain", metavar="DEGREES", type=float, help="the grain's angle from the x axis (default 0)"
        )
        command.add_argument(
            "--mesh-size", metavar="LENGTH", help="edge length of the triangles, such as 6mm"
        )
        command.add_argument(
            "--results", choices=FORMATS, help="also write what each triangle does, for ParaView or NumPy"
        )
        command.add_argument(
            "--frames", metavar="N", type=int, help="also write so many frames of the inflation, for ParaView"
        )
        _add_machines(command)
        making.add_making(command)
        pattern.add_pattern(command)
        _add_simulation(command)
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


def _add_machines(command: argparse.ArgumentParser) -> None:
    """Options for files that go straight to a machine."""
    command.add_argument(
        "--machine",
        metavar="NAME",
        action="append",
        default=[],
        help=f"also write what it reads: {', '.join(machines())}, or a .json file; may be repeated",
    )
    add_bed(command)
    command.add_argument(
        "--tiled",
        metavar="PAPER",
        choices=TILES,
        help="also write a PDF to print on several A4, A3 or Letter",
    )


def _add_size(command: argparse.ArgumentParser) -> None:
    """What decides the size: lengths of the drawing, or what the balloon has to hold or to carry."""
    command.add_argument("--width", metavar="LENGTH", help="of the drawing, such as 300mm or 12in")
    command.add_argument(
        "--height", metavar="LENGTH", help="of the drawing; with --width it fits inside both"
    )
    goal = command.add_mutually_exclusive_group()
    goal.add_argument(
        "--target-volume",
        metavar="LITRES",
        help="instead of a width: make it so large that it holds this, such as 10 or 0.5ft3",
    )
    goal.add_argument(
        "--target-lift",
        metavar="GRAMS",
        help="instead of a width: make it so large that it carries this besides itself, such as 5 or 0.1N",
    )
    command.add_argument(
        "--gas",
        metavar="NAME",
        default=DEFAULT_GAS,
        help=f"that fills it: {', '.join(gases())} (default {DEFAULT_GAS})",
    )
    command.add_argument(
        "--gas-temperature", metavar="T", help="such as 80C; by default that of the air, 80C for warm-air"
    )
    command.add_argument("--air-temperature", metavar="T", default="20C", help="around it (default 20C)")
    command.add_argument("--altitude", metavar="LENGTH", default="0m", help="above the sea (default 0m)")
    command.add_argument(
        "--drawn-as",
        choices=DRAWN_AS,
        default=AUTO,
        help="how a picture is read: a filled shape, whose holes stay, or a pen drawing, whose lines are"
        " filled inside; auto (the default) goes by its lines",
    )
    command.add_argument(
        "--symmetry",
        choices=CHOICES,
        default=AUTO,
        help="auto (the default) evens out a picture that is nearly mirror symmetric, force any drawing",
    )


def _add_simulation(command: argparse.ArgumentParser) -> None:
    """Options for comparisons."""
    group = command.add_argument_group("simulation")
    solver = group.add_mutually_exclusive_group()
    solver.add_argument(
        "--solver",
        choices=SOLVERS,
        help="native (the usual one) and numpy are one method; newmark follows the inflation in time, slowly",
    )
    solver.add_argument(
        "--no-native", action="store_const", const="numpy", dest="solver", help="same as --solver numpy"
    )
    group.add_argument(
        "--plain-shell", action="store_true", help="film that carries compression instead of wrinkling"
    )
    group.add_argument("--no-bending", action="store_true", help="film without bending stiffness")
    group.add_argument(
        "--bending-floor",
        metavar="D",
        type=float,
        default=BENDING_FLOOR,
        help=f"least bending stiffness in p w^3, w the typical width (default {BENDING_FLOOR})",
    )
    group.add_argument(
        "--two-panels", action="store_true", help="both panels, instead of one and its mirror image"
    )
