# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pattern correction over the example pictures and generated outlines."""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
from drawn_shapes import generated
from validation import figures
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.design.fit import fit
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.picture import read_picture

PICTURES = Path(__file__).resolve().parents[2] / "resources" / "examples" / "pictures"
PRESSURE = 2000.0
GENERATED = 20
SHOWN = 6
_KINDS = ("smooth", "star", "spiky", "thin", "with holes")


def correction(images: Path) -> Section:
    """Error, passes and seconds of every outline; the worst ones as pictures."""
    rows, done, refused = [], [], 0
    for name, outline in _outlines():
        began = time.process_time()
        try:
            design = fit(outline, film("mylar"), PRESSURE)
        except BalloonError as error:
            refused += 1
            rows.append((name, f"refused: {error}", "", "", "", "", ""))
            continue
        seconds = time.process_time() - began
        size, error = max(outline.size), design.residual
        done.append((error.mean / size, seconds, name, design))
        rows.append(
            (
                name,
                f"{100 * error.mean / size:.3f} %",
                f"{100 * error.p95 / size:.2f} %",
                f"{100 * error.max / size:.2f} %",
                str(design.passes),
                f"{seconds:.1f}",
                "yes" if design.reached else "**no**",
            )
        )
    means, seconds = np.array([(one[0], one[1]) for one in done]).T
    passes = np.array([one[3].passes for one in done])
    worst = sorted(done, key=lambda one: -one[0])[:SHOWN]
    figures.designs(
        [(f"{name}: {100 * mean:.2f} %", design) for mean, _, name, design in worst],
        images / "validation-correction.svg",
    )
    text = paragraphs(
        f"""The pattern of a balloon of 0.3 m that shall look like the drawing, film "mylar",
        {PRESSURE / 1e3:g} kPa, mesh as chosen by itself: the example pictures, and {GENERATED} generated
        outlines. Errors are two-way distances between drawing and inflated silhouette, in per cent of the
        larger dimension: the mean, the 95th percentile and the greatest. Reached means a mean below 1 %.

        Median of the mean errors {100 * np.median(means):.3f} %, worst {100 * means.max():.3f} %; median
        of the passes {np.median(passes):.0f}, most {passes.max()}; median {np.median(seconds):.1f}
        processor seconds, most {seconds.max():.1f}; {sum(one[3].reached for one in done)} of {len(rows)}
        reached, {refused} refused."""
    )
    text += "\n" + table(
        ("outline", "mean", "95 %", "greatest", "passes", "processor seconds", "reached"), rows
    )
    text += "\n" + paragraphs("The worst ones: drawing grey, inflated silhouette red, pattern blue.")
    text += "\n![The worst corrections](images/validation-correction.svg)\n"
    return Section("Pattern correction", text)


def _outlines() -> list[tuple[str, Outline]]:
    pictures = [(path.stem, read_picture(path, 0.3, None)) for path in sorted(PICTURES.glob("*.png"))]
    made = [(f"generated {seed}, {_KINDS[seed % 5]}", generated(seed)) for seed in range(GENERATED)]
    return pictures + made
