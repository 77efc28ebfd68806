# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file of a film with what was fitted of it from photographs, as a film of the user's own."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from BalloonWorkbench.core.as_made.comparison_report import fit_data
from BalloonWorkbench.core.as_made.film_fit import FilmFit
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.library import film_data

_ENDING = "-as-made"
#: A value, and its standard deviation.
_FITTED = (("stretch", "stretch_error"), ("weld_shrinkage_mm", "weld_shrinkage_error_mm"))


def fitted_film_file(name: str, fit: FilmFit, photo: str) -> dict[str, bytes]:
    """Content of a film file by its name: that of a known film, or of a file, with stretch and shrinkage.

    A file that has some of other photographs gets the mean of all, see `mean_of`.

    photo  name of the picture, which the file names as the source; it takes the place of an earlier one of
           that name
    Raises InputError for a film that there is not, or whose as_made nobody can read.
    """
    data = film_data(name)
    photographs = {**_photographs(data.get("as_made", {}), name), photo: fit_data(fit)}
    own = data["name"].removesuffix(_ENDING) + _ENDING
    data |= {
        "name": own,
        "title": f"{data['title'].removesuffix(' (as made)')} (as made)",
        "as_made": {
            **mean_of([*photographs.values()]),
            "source": f"fitted to {', '.join(photographs)}",
            "photographs": photographs,
        },
    }
    return {f"{own}.json": (json.dumps(data, indent=2, ensure_ascii=False) + "\n").encode(errors="replace")}


def mean_of(fits: list[dict[str, Any]]) -> dict[str, Any]:
    """The weighed mean of fits as `fit_data` has them, each by its error; of those whose shape tells stretch
    and shrinkage apart, where there are any.

    Where they differ by more than their errors say, the error is that of their scatter (Birge's ratio,
    Phys. Rev. 40, 207, 1932).
    """
    apart = [fit for fit in fits if fit["told_apart"]]
    used = apart or fits
    values: dict[str, Any] = {}
    for name, error in _FITTED:
        numbers, errors = np.array([(fit[name], fit[error]) for fit in used]).T
        weights = np.maximum(errors, 1e-12) ** -2.0
        mean = float(weights @ numbers / weights.sum())
        values[name] = mean
        scatter = float(weights @ (numbers - mean) ** 2) / max(len(used) - 1, 1)
        values[error] = float(np.sqrt(max(scatter, 1.0) / weights.sum()))
    left = float(np.mean([fit["left_mm"] for fit in used]))
    return {**values, "told_apart": bool(apart), "left_mm": left}


def _photographs(as_made: Any, name: str) -> dict[str, Any]:
    """What a film's file has of photographs, by their names."""
    known = as_made.get("photographs", {}) if isinstance(as_made, Mapping) else None
    if not isinstance(known, dict) or not all(map(_is_fit, known.values())):
        raise InputError(f'The "as_made" of the film {name} cannot be read: delete it from the file.')
    return known


def _is_fit(data: Any) -> bool:
    numbers = [*(name for pair in _FITTED for name in pair), "left_mm"]
    return (
        isinstance(data, Mapping)
        and isinstance(data.get("told_apart"), bool)
        and all(isinstance(data.get(name), (int, float)) and np.isfinite(data[name]) for name in numbers)
    )
