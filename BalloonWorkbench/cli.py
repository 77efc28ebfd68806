# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python -m BalloonWorkbench design INPUT --width 300mm --out DIR."""

from __future__ import annotations

import argparse
import importlib.util
import json
import math
import sys
from collections.abc import Sequence
from typing import Any, NoReturn, TextIO

from BalloonWorkbench import __version__, cli_making, cli_pattern
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.export.fabricate import checked_files
from BalloonWorkbench.core.export.machine import machine, machines
from BalloonWorkbench.core.export.machine_pdf import TILES
from BalloonWorkbench.core.export.results import FORMATS
from BalloonWorkbench.core.film.filling import DEFAULT_GAS, Filling, gas, gases
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import DEFAULT_FILM, custom_film, film, films, with_grain
from BalloonWorkbench.core.job import (
    DEFAULT_PRESSURE,
    Balloon,
    Settings,
    files,
    inflation_files,
    make_balloon,
)
from BalloonWorkbench.core.outline.raster import opencv
from BalloonWorkbench.core.outline.symmetry import AUTO, CHOICES
from BalloonWorkbench.core.solver.backend import SOLVERS
from BalloonWorkbench.core.solver.model import BENDING_FLOOR, Model
from BalloonWorkbench.core.units import (
    parse_length,
    parse_mass,
    parse_pressure,
    parse_temperature,
    parse_volume,
)

DOCUMENT = "balloon.FCStd"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command; 0 when all files are written, 2 with one line on stderr when something is wrong."""
    try:
        options = _parser().parse_args(arguments)
        return _run(options)
    except BalloonError as error:
        sys.stderr.write(f"balloon: {' '.join(str(error).split())}\n")
        return 2
    except KeyboardInterrupt:
        sys.stderr.write("\nballoon: stopped; no file was written.\n")
        return 130


class _Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are one line."""

    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message}. See --help.")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="python -m BalloonWorkbench", description="Designs balloons from film.")
    parser.add_argument("--version", action="version", version=__version__)
    commands = parser.add_subparsers(dest="command", required=True, parser_class=_Parser)
    for name, purpose in (
        ("design", "correct the pattern until the inflated silhouette is the drawing"),
        ("inflate", "inflate the outline as it is; it is the pattern"),
    ):
        command = commands.add_parser(name, help=purpose, description=f"{purpose[0].upper()}{purpose[1:]}.")
        command.add_argument(
            "input", metavar="INPUT", help="PNG, JPEG or BMP picture, or SVG, DXF or JSON outline"
        )
        command.add_argument("--out", metavar="DIR", required=True, help="folder for the files")
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
        cli_making.add_making(command)
        cli_pattern.add_pattern(command)
        _add_simulation(command)
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
        help=f"least bending stiffness in p w^3, w the typical width (default {BENDING_FLOOR:g})",
    )
    group.add_argument(
        "--two-panels", action="store_true", help="both panels, instead of one and its mirror image"
    )


def _run(options: argparse.Namespace) -> int:
    width, height = _length(options.width), _length(options.height)
    settings = _settings(options)
    chosen = [machine(name) for name in options.machine]  # a mistake shows before the work
    make = cli_making.checked(options, _decode())
    line = _StatusLine(sys.stderr)
    try:
        balloon = make_balloon(
            options.input, settings, width=width, height=height, decode=_decode(), progress=line.show
        )
        line.show(1.0, "writing files")
        contents = files(balloon, options.results)
        if options.frames is not None:
            contents.update(inflation_files(balloon, options.frames, line.show))
        made, remarks = checked_files(balloon.sheet, chosen, options.tiled)
        contents.update(made)
        made, told = make(balloon, chosen, line.show)
        contents.update(made)
        if settings.goal is not None:
            width = balloon.drawing.size[0]
        if importlib.util.find_spec("FreeCAD") is not None:
            contents[DOCUMENT] = _document(options.input, balloon, width, height)
    finally:
        line.clear()
    _write(options.out, contents, balloon, remarks, told)
    return 0


def _settings(options: argparse.Namespace) -> Settings:
    return Settings(
        _film(options),
        parse_pressure(options.pressure),
        _length(options.mesh_size),
        options.solver,
        options.command == "design",
        volume=None if options.gas_volume is None else parse_volume(options.gas_volume),
        model=Model(
            not options.plain_shell, not options.no_bending, options.bending_floor, options.two_panels
        ),
        symmetry=options.symmetry,
        goal=_goal(options),
        filling=Filling(
            gas(options.gas),
            None if options.gas_temperature is None else parse_temperature(options.gas_temperature),
            parse_temperature(options.air_temperature),
            parse_length(options.altitude),
        ),
        passage=cli_pattern.passage(options),
        wanted=cli_pattern.wanted(options),
    )


def _length(text: str | None) -> float | None:
    return None if text is None else parse_length(text)


def _goal(options: argparse.Namespace) -> SizeGoal | None:
    if options.target_volume is None and options.target_lift is None:
        return None
    if options.width is not None or options.height is not None:
        raise InputError("A target decides the size: leave out --width and --height.")
    if options.target_volume is not None:
        return SizeGoal(volume=parse_volume(options.target_volume, "l"))
    return SizeGoal(lift=parse_mass(options.target_lift, "g"))


def _film(options: argparse.Namespace) -> Film:
    own = (options.young, options.poisson, options.thickness)
    if all(value is None for value in own):
        plain = film(options.material or DEFAULT_FILM)
    elif options.material is not None or any(value is None for value in own):
        raise InputError("Give either --material, or all of --young, --poisson and --thickness.")
    else:
        plain = custom_film(*own)
    if options.young_across is not None:
        return with_grain(plain, options.young_across, math.radians(options.grain or 0.0))
    if options.grain is not None:
        raise InputError("Only a film with another stiffness across has a grain: give --young-across too.")
    return plain


def _decode() -> Any:
    """Qt's picture reader where OpenCV is missing; None means OpenCV."""
    if opencv() is not None:
        return None
    try:
        from BalloonWorkbench.app import qt_picture
    except ImportError:
        return None  # the reader of pictures says what to install
    return qt_picture.decode


def _document(drawing: str, balloon: Balloon, width: float | None, height: float | None) -> bytes:
    from BalloonWorkbench.app.document import fcstd_bytes

    return fcstd_bytes(drawing, balloon.settings, balloon.designs, width=width, height=height)


def _write(
    folder: str, contents: dict[str, bytes], balloon: Balloon, remarks: Sequence[str], made: Sequence[str]
) -> None:
    from BalloonWorkbench.core.export.files import write_files

    paths = write_files(folder, contents)
    report = json.loads(contents["report.json"])  # as written: it also tells what was left out
    lines = []
    for part in report["parts"]:
        inflated, error = part["inflated"], part["design"]["silhouette_error_mm"]
        size = f"{inflated['width_mm']:.0f} x {inflated['height_mm']:.0f} x {inflated['thickness_mm']:.0f} mm"
        lines.append(f"Balloon {size}, {1e3 * inflated['volume_m3']:.2f} l, solver {report['backend']}")
        if balloon.settings.volume is not None:
            lines.append(f"Pressure {part['pressure_Pa']:.4g} Pa")
        if balloon.settings.correct:
            lines.append(
                f"Silhouette {error['mean']:.2f} mm off the drawing on average, {error['max']:.1f} mm at most"
            )
        lines.append(_lift_line(part["lift"]))
        lines.append(_making_line(part["maker"]))
    lines += [f"Note: {warning}" for warning in report["warnings"]]
    lines += [_advice_line(finding) for part in report["parts"] for finding in part["advice"]]
    lines += [f"Check: {remark}" for remark in remarks]
    lines += made
    lines += [f"Wrote {path}" for path in paths]
    sys.stdout.write("\n".join(lines) + "\n")


def _lift_line(lift: dict[str, Any]) -> str:
    weight, gas_name = f"Weight {lift['weight_g']:.3g} g", lift["gas"]
    if lift["floats"]:
        return f"{weight}; filled with {gas_name} it carries {lift['lift_g']:.3g} g"
    if lift["floats_from_width_mm"] is None:
        return f"{weight}; it does not float with {gas_name}"
    return f"{weight}; filled with {gas_name} it floats from {lift['floats_from_width_mm']:.0f} mm width on"


def _making_line(maker: dict[str, Any]) -> str:
    """What it takes, and how much pressure it bears."""
    strong = maker["strength"]
    told = f"Film {1e4 * maker['film_area_m2']:.0f} cm2"
    if maker["roll_length_mm"] is not None:
        told += f" from {maker['roll_length_mm']:.0f} mm of a {maker['roll_width_mm']:.0f} mm roll"
    told += f", weld {maker['seam_length_mm']:.0f} mm"
    if strong["safe_pressure_Pa"] is None:
        return told
    return told + f"; {strong['weakest']} safe to {1e-3 * strong['safe_pressure_Pa']:.2g} kPa"


def _advice_line(finding: dict[str, Any]) -> str:
    x, y = finding["at_mm"]
    return f"Advice, {finding['severity']}, at ({x:.0f}, {y:.0f}) mm: {finding['text']}"


class _StatusLine:
    """Progress on a terminal: one line that is written over; nothing elsewhere."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream if stream.isatty() else None

    def show(self, fraction: float, text: str) -> bool:
        """Show the progress; never asks to stop."""
        if self._stream is not None:
            self._stream.write(f"\r\033[K{100.0 * fraction:3.0f} %  {text}")
            self._stream.flush()
        return True

    def clear(self) -> None:
        """Leave an empty line behind."""
        if self._stream is not None:
            self._stream.write("\r\033[K")
            self._stream.flush()
