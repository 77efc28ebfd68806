# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: python -m BalloonWorkbench design INPUT --width 300mm --out DIR."""

from __future__ import annotations

import argparse
import importlib.util
import json
import math
import sys
from collections.abc import Sequence
from typing import Any, TextIO

from BalloonWorkbench import cli_making, cli_pattern
from BalloonWorkbench.cli_options import parser
from BalloonWorkbench.core.design.size_goal import SizeGoal
from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.export.fabricate import checked_files
from BalloonWorkbench.core.export.machine import machine
from BalloonWorkbench.core.film.filling import Filling, gas
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import DEFAULT_FILM, custom_film, film, with_grain
from BalloonWorkbench.core.job import (
    Balloon,
    Settings,
    files,
    inflation_files,
    make_balloon,
)
from BalloonWorkbench.core.outline.raster import opencv
from BalloonWorkbench.core.solver.model import Model
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
        options = parser().parse_args(arguments)
        return _run(options)
    except BalloonError as error:
        sys.stderr.write(f"balloon: {' '.join(str(error).split())}\n")
        return 2
    except KeyboardInterrupt:
        sys.stderr.write("\nballoon: stopped; no file was written.\n")
        return 130


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
        drawn_as=options.drawn_as,
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
