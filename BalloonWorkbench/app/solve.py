# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a balloon object asks of the engine, free of the document: it may be solved in another thread."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass

import numpy as np

from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.types import Progress, no_progress


@dataclass(frozen=True)
class Request:
    """One balloon to be designed; SI units, None where the engine chooses."""

    outline: Outline
    film: Film
    pressure: float
    mesh_size: float | None
    backend: str | None
    correct: bool

    def key(self) -> str:
        """The same for the same balloon: what a result is labelled with.

        Numbers that went through a file or another unit differ in their last digits; those are left out.
        """
        film = self.film
        numbers = [film.young_modulus, film.poisson_ratio, film.thickness, film.seal_width, self.pressure]
        values = [
            *(f"{number:.9g}" for number in numbers),
            self.mesh_size and f"{self.mesh_size:.9g}",
            self.backend,
            self.correct,
            [len(loop) for loop in self.outline.loops],
        ]
        digest = hashlib.sha256(json.dumps(values).encode())
        for loop in self.outline.loops:
            digest.update((np.round(loop, 9) + 0.0).tobytes())  # + 0.0: no negative zeros
        return digest.hexdigest()

    def solve(self, progress: Progress = no_progress) -> Design:
        """The balloon and its pattern; BalloonError when there is none, Cancelled when progress says stop."""
        from BalloonWorkbench.core.design.fit import fit, inflate_outline

        work = fit if self.correct else inflate_outline
        return work(
            self.outline,
            self.film,
            self.pressure,
            mesh_size=self.mesh_size,
            backend=self.backend,
            progress=progress,
        )
