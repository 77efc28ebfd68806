# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command compare: a photograph of a balloon beside its simulation, a scanned panel beside its cut."""

from __future__ import annotations

import argparse
import sys
from functools import partial
from pathlib import Path

from BalloonWorkbench.cli import console
from BalloonWorkbench.cli.settings import balloon_of, picture_reader, settings_of
from BalloonWorkbench.core.as_made.compare_job import (
    Compared,
    compare_balloon,
    compare_cut,
    compared_files,
    rim_of,
)
from BalloonWorkbench.core.as_made.comparison_report import comparison_lines
from BalloonWorkbench.core.as_made.fitted_film import fitted_film_file
from BalloonWorkbench.core.as_made.photo_scale import parse_photo_scale
from BalloonWorkbench.core.as_made.photograph import SeenShape, read_photograph
from BalloonWorkbench.core.correction.fit import inflate_outline
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.write import check_folder, write_files
from BalloonWorkbench.core.job import Balloon, Settings
from BalloonWorkbench.core.options.film import DEFAULT_FILM
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.targets.form import has_many_panels
from BalloonWorkbench.core.types import Progress, Say, no_progress, part_of
from BalloonWorkbench.core.units import from_mm

_FITTED = 0.6  # of the progress, when the balloon is worked out that the film is fitted with
_MOST_RIM = 1e3  # mm


def run(options: argparse.Namespace, say: Say) -> int:
    """Do what the options say; the exit code. Raises BalloonError, before the work where that can be."""
    scale = parse_photo_scale(options.scale)
    check_folder(options.out)
    line = console.StatusLine(sys.stderr)
    try:
        shape = read_photograph(options.photo, scale, picture_reader())
        compared, files = (_flat if options.flat else _inflated)(options, shape, partial(_show, line, say))
        contents = compared_files(compared) | files
    finally:
        line.clear()
    paths = write_files(options.out, contents)
    lines = [say(text) for text in comparison_lines(compared.comparison, compared.fit)]
    lines += [say(f"Wrote {path}") for path in paths]
    problem = console.show("\n".join(lines) + "\n")
    return 0 if problem is None else console.UNSHOWN


def _show(line: console.StatusLine, say: Say, fraction: float, text: str) -> bool:
    return line.show(fraction, say(text))


def _flat(
    options: argparse.Namespace, shape: SeenShape, _progress: Progress = no_progress
) -> tuple[Compared, dict[str, bytes]]:
    """A scanned panel, and no other files."""
    if options.fit or options.rim is not None or options.uncorrected:
        raise InputError("A flat panel has no pressure and no rim: leave out --fit, --rim and --uncorrected.")
    return compare_cut(shape, options.input), {}


def _inflated(
    options: argparse.Namespace, shape: SeenShape, progress: Progress
) -> tuple[Compared, dict[str, bytes]]:
    """An inflated balloon, and the file of its film where that is fitted."""
    settings = settings_of(options)
    if has_many_panels(options.input, settings.body, settings.side_band):
        raise InputError(
            "Only balloons of two equal panels are compared with a photograph: compare the panels of others"
            " one by one with --flat."
        )
    rim = rim_of(settings.film, settings.pattern) if options.rim is None else options.rim
    if not 0.0 <= rim <= from_mm(_MOST_RIM):
        raise InputError("--rim is the width of the weld and of the film beside it: give 0 to 1 m.")
    name = options.material or DEFAULT_FILM
    if options.fit and options.young is not None:
        raise InputError("A fitted film is written beside the numbers of a known one: give it by --material.")
    size = options.width, options.height
    first = part_of(progress, 0.0, _FITTED if options.fit else 1.0)
    balloon = balloon_of(options, settings, size, progress=first)
    assert isinstance(balloon, Balloon)  # two equal panels
    made = [(part.design, part.pattern) for part in balloon.parts]
    inflate = partial(_inflate, settings, part_of(progress, _FITTED, 1.0)) if options.fit else None
    compared = compare_balloon(shape, made, rim, inflate)
    if compared.fit is None:
        return compared, {}
    return compared, fitted_film_file(name, compared.fit, Path(options.photo).name)


def _inflate(settings: Settings, progress: Progress, seam: Outline, pressure: float) -> Design:
    """The balloon of another pattern, as the settings say."""
    return inflate_outline(
        seam,
        settings.film,
        pressure,
        mesh_size=settings.mesh_size,
        backend=settings.backend,
        model=settings.model,
        progress=progress,
    )
