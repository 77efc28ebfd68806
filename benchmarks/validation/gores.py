# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of gores, as they are cut, against the profiles that they are to have."""

from __future__ import annotations

import time

from profiles import PROFILES, airship
from validation.report import Row, Section, section, table

from BalloonWorkbench.core.bag_design.bag_design import BagDesign
from BalloonWorkbench.core.bag_design.gore_count import expected_error
from BalloonWorkbench.core.bag_design.gore_fit import RisingPressure, fit_gores, inflate_gores
from BalloonWorkbench.core.bodies.natural_shape import natural_shape
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.polyline import length, signed_area

_PRESSURE = 1000.0  # Pa


def gores() -> Section:
    """Spheres of few and many gores, other bodies of eight, a model airship, the natural shape."""
    lines = [_line("sphere", count) for count in (4, 6, 8, 12, 16, 24)]
    lines += [_line(name, 8) for name in PROFILES if name != "sphere"]
    head = ("body", "gores", "plain %", "corrected %", "95 % below, %", "largest %", "n² x corrected %")
    return section(
        "Bodies of gores",
        "Distance of the film of the gores from the body of revolution, in parts of the diagonal of its box:"
        " mean before and after the correction, of the pattern meshed anew; the part that 95 % of the film do"
        " not exceed, and the largest; the mean times the square of the number of gores, which for spheres is"
        " to be 16 % at most; and the law by which the program proposes their number. Polyester film of 25 µm"
        " at 1 kPa. Beside a disc the gores are flared, so that its bulge does not draw the rim in; their"
        " corners fold there, which is the largest distance. A lens half as thick as wide is no shape that"
        " film can take.",
        [*_airship(), _natural()],
        table((*head, "by the law %", "seam over middle %", "simulations", "s"), lines),
    )


def _error(design: BagDesign) -> float:
    assert design.residual is not None
    return design.residual.mean / design.size


def _line(name: str, count: int) -> tuple[str, ...]:
    profile, mylar = PROFILES[name](), film("mylar")
    plain = inflate_gores(profile, count, mylar, _PRESSURE)
    began = time.process_time()
    design = fit_gores(profile, count, mylar, _PRESSURE)
    seconds = time.process_time() - began
    error, law = _error(design), expected_error(profile, count)
    assert design.residual is not None
    most, largest = design.residual.p95 / design.size, design.residual.max / design.size
    shares = (_error(plain), error, most, largest, count**2 * error, law, design.apart / design.size)
    return (
        name,
        str(count),
        *(f"{100.0 * share:.3f}" for share in shares),
        str(design.passes),
        f"{seconds:.1f}",
    )


def _airship() -> list[Row]:
    """Six gores of polyethylene, 2.1 m x 0.73 m: its builder had 0.53 m3, and 31 g a gore with its weld."""
    sheet = film("pe")
    design = fit_gores(airship(), 6, sheet, 300.0)
    flat = design.bag.panels[0].outer
    welds = 2.0 * length(flat[: len(flat) // 2 + 1]) * sheet.seal_width
    weight = 1e3 * sheet.areal_density * (signed_area(flat) + welds)
    return [
        Row("model airship: 1 + mean distance / diagonal", 1.0 + _error(design), 1.0, 0.005),
        Row("model airship: volume, m3", design.inflation.volume, 0.53, 0.03, 4),
        Row("model airship: a gore, g", weight, 31.0, 0.05, 3),
    ]


def _natural() -> Row:
    """Twelve gores 10 m long, held below, no pressure there, corrected."""
    profile = natural_shape(10.0)
    design = fit_gores(profile, 12, film("pe"), RisingPressure(0.0, 2.0))
    return Row("natural shape, 12 gores: V / L^3", design.inflation.volume / 1e3, 0.126055, 0.01)
