# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file of a film with what was fitted of it, as a film of the user's own."""

from __future__ import annotations

import json

from BalloonWorkbench.core.as_made.comparison_report import fit_data
from BalloonWorkbench.core.as_made.film_fit import FilmFit
from BalloonWorkbench.core.film.library import film_data

_ENDING = "-as-made"


def fitted_film_file(name: str, fit: FilmFit, photo: str) -> dict[str, bytes]:
    """Content of a film file by its name: that of a known film, or of a file, with stretch and shrinkage.

    photo  name of the picture, which the file names as the source
    Raises InputError for a film that there is not.
    """
    data = film_data(name)
    own = data["name"].removesuffix(_ENDING) + _ENDING
    data |= {
        "name": own,
        "title": f"{data['title'].removesuffix(' (as made)')} (as made)",
        "as_made": {**fit_data(fit), "source": f"fitted to the photograph {photo}"},
    }
    return {f"{own}.json": (json.dumps(data, indent=2, ensure_ascii=False) + "\n").encode(errors="replace")}
