# SPDX-License-Identifier: LGPL-2.1-or-later
"""A photograph of the inflated balloon over that of a document, and the film that was fitted with it."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.engine import bag_result, film_result
from BalloonWorkbench.app.properties import film
from BalloonWorkbench.core.errors import InputError

_READ, _COMPARED = 0.1, 0.3  # of the progress


def comparing(parts, photo, scale: str, rim=None, fit: bool = False):
    """A function of a progress that compares, the core's Compared; it does not touch the document.

    scale  as the command compare takes it: "x1,y1,x2,y2,300mm", "812,300mm" (pixels and length) or "fit"
    rim    how far weld and film reach beyond the seam in the photograph [mm], or a text; None as the pattern
    fit    also what the film has stretched, and how far the weld drew the seam in
    Raises InputError for a balloon of many panels, one that is not up to date, and for what makes no sense.
    """
    from BalloonWorkbench.app import balloon, pattern
    from BalloonWorkbench.app.drawings.drawing_file import decoder
    from BalloonWorkbench.core.as_made.compare_job import compare_balloon, rim_of
    from BalloonWorkbench.core.as_made.photo_scale import parse_photo_scale
    from BalloonWorkbench.core.as_made.photograph import read_photograph
    from BalloonWorkbench.core.checkpoint import stoppable

    if bag_result.has_many_panels(parts.balloon):
        raise InputError(
            "Only balloons of two equal panels are compared with a photograph: compare the panels of others"
            " one by one, with the command compare and its --flat."
        )
    for obj in (parts.balloon, parts.pattern):
        if not status.is_ready(obj):
            raise InputError(
                f"{obj.Label} is not up to date. {status.problem(obj)} Repair that and recompute."
            )
    measured = parse_photo_scale(scale)
    made = film_result.design(parts.balloon), pattern.build(parts.pattern)
    usual = rim_of(film.read(parts.balloon), pattern.values(parts.pattern))
    beyond = usual if rim is None else _rim(rim)
    settings = balloon.request(parts.balloon).settings

    def compare(progress):
        with stoppable(lambda _part, _text: progress(_READ, "")):
            progress(0.0, "reading the photograph")
            shape = read_photograph(photo, measured, decoder())
            inflate = partial(_inflated, settings, progress) if fit else None
            return compare_balloon(shape, [made], beyond, inflate)

    return compare


def usual_rim(parts) -> float:
    """How far weld and film reach beyond the seam of a pattern [mm]."""
    from BalloonWorkbench.app import pattern
    from BalloonWorkbench.core.as_made.compare_job import rim_of
    from BalloonWorkbench.core.units import to_mm

    return to_mm(rim_of(film.read(parts.balloon), pattern.values(parts.pattern)))


def write(compared, folder) -> list[Path]:
    """Write the picture and the figures of a comparison into a folder; returns the files."""
    from BalloonWorkbench.core.as_made.compare_job import compared_files
    from BalloonWorkbench.core.files.write import write_files

    return list(write_files(folder, compared_files(compared)))


def fitted_film(balloon) -> Path:
    """The file to which `keep_film` keeps what was fitted of a balloon's film.

    Raises InputError for one of numbers of its own, which has no file.
    """
    if balloon.Film == film.CUSTOM:
        raise InputError(
            "A fitted film is kept beside the numbers of a known one: choose the balloon's film in its panel."
        )
    return film.own_folder() / f"{balloon.Film.removesuffix('-as-made')}-as-made.json"


def keep_film(balloon, compared, photo, replace: bool = False) -> Path:
    """Keep the film that was fitted among the user's own; returns its file.

    One that is there gets the mean of all its photographs, unless it is to be replaced. Raises InputError as
    `fitted_film` does, and for a file that is no film.
    """
    from BalloonWorkbench.core.as_made.fitted_film import fitted_film_file
    from BalloonWorkbench.core.files.write import write_files

    target = fitted_film(balloon)
    own = film.own_folder() / f"{balloon.Film.removesuffix('-as-made') if replace else balloon.Film}.json"
    own = target if target.exists() and not replace else own
    name = str(own) if own.is_file() else own.stem
    (path,) = write_files(target.parent, fitted_film_file(name, compared.fit, Path(photo).name))
    return path


def _rim(value) -> float:
    """A number of mm or a text, in metres; InputError for what is no rim."""
    from BalloonWorkbench.core.units import from_mm, parse_length

    text = str(value).strip()
    rim = parse_length(text if text[-1:].isalpha() or text[-1:] == '"' else f"{text}mm")
    if not 0.0 <= rim <= from_mm(1e3):
        raise InputError("The rim is the width of the weld and of the film beside it: give 0 to 1 m.")
    return rim


def _inflated(settings, progress, seam, pressure: float):
    """The balloon of another pattern, as the settings say."""
    from BalloonWorkbench.core.correction.fit import inflate_outline
    from BalloonWorkbench.core.types import part_of

    return inflate_outline(
        seam,
        settings.film,
        pressure,
        mesh_size=settings.mesh_size,
        backend=settings.backend,
        model=settings.model,
        progress=part_of(progress, _COMPARED, 1.0),
    )
