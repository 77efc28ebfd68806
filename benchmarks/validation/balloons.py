# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole balloons against closed forms, quadrature and published values."""

from __future__ import annotations

from functools import cache

import numpy as np
from drawn_shapes import corners_of
from solver_cases import (
    PRESSURE,
    circle,
    crown,
    film,
    panel,
    radii,
    silhouette_radii,
)
from validation.axisymmetric import profile
from validation.report import Row, Section, paragraphs, section, table

from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.panels.panel import Panel
from BalloonWorkbench.core.solver.element.dkt import gradients
from BalloonWorkbench.core.solver.element.kinematics import deformation_gradients, green_strains
from BalloonWorkbench.core.solver.element.membrane import tension_field
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats

VERTICES = 1500
RING_BAND = 0.1  # m, of a ring of radius 1 m

#: E t / (p a): volume, rim radius, thickness, tension at the pole for a = 1, p = 1, nu = 0.3
DISC = {
    50: (1.25549, 0.76951, 0.94940, 0.904),
    100: (1.23836, 0.76643, 0.93635, 1.030),
    200: (1.22915, 0.76475, 0.92817, 1.178),
    500: (1.22315, 0.76364, 0.92181, 1.411),
    1000: (1.22098, 0.76323, 0.91899, 1.619),
    10000: (1.21882, 0.76282, 0.91510, 2.56),
}
RING_VOLUME, RING_RADIUS, RING_THICKNESS = 0.3359562, 0.8498107, 0.2971177


@cache
def balloon(
    shape: str, k: float, *, band: float = 0.0, vertices: int = VERTICES, backend: str = "native"
) -> Inflation:
    """A shape of the tests at E t / (p 1 m) = k."""
    return inflate(panel(shape, vertices), film(k, seal_width=band), PRESSURE, backend=backend)


def meshed(outline: Outline, vertices: int = VERTICES) -> Panel:
    """An outline's panel with about so many vertices."""
    return triangulate(outline, size_for(outline, vertices))


def disc() -> Section:
    """Section 1: the Mylar balloon."""
    rows = []
    for k, (volume, rim, thickness, pole) in DISC.items():
        found = balloon("disc", k)
        radius = np.linalg.norm(found.panel.rest_positions[found.panel.triangles].mean(axis=1), axis=1)
        cap = found.tensions[radius < 0.15, 0].mean() / PRESSURE
        rows += [
            Row(f"k = {k}: V / a^3", found.volume, volume, 0.003),
            Row("rim of the silhouette / a", float(silhouette_radii(found).mean()), rim, 0.005, 5),
            Row("mean rim / a", float(radii(found, 0).mean()), rim, 0.01, 5),
            Row("thickness / a", 2.0 * float(found.positions[:, 2].max()), thickness, 0.01, 5),
            Row("greatest tension / (p a)", found.tensions.max() / PRESSURE, pole, 0.03, 4),
            Row("mean tension of the cap s < 0.15 a", float(cap), profile(k).cap_tension(0.15), 0.03, 4),
        ]
    stiff = balloon("disc", 10000)
    radius = float(silhouette_radii(stiff).mean())
    distance = np.linalg.norm(stiff.positions[:, :2], axis=1)
    near = np.abs(distance - 0.5 * radius) < 0.04
    height = np.polyval(np.polyfit(distance[near], stiff.positions[near, 2], 2), 0.5 * radius)
    rows.append(Row("k = 10000: height at half the radius / a", float(height), 0.424726, 0.01))
    own = [
        (
            f"{k}",
            f"{one.volume:.6f}",
            f"{one.radius[-1]:.6f}",
            f"{one.thickness:.6f}",
            f"{one.tension[0]:.4f}",
        )
        for k, one in ((k, profile(k)) for k in DISC)
    ]
    more = paragraphs(
        """The references are axisymmetric relaxed films. The same from a second derivation, the energy of
        the profile alone minimised on 4 000 nodes (`benchmarks/validation/axisymmetric.py`):"""
    )
    return section(
        "1. Two discs: the Mylar balloon",
        f"Flat radius a = 1, about {VERTICES} vertices, no sealed band, nu = 0.3, k = E t / (p a).",
        rows,
        more + "\n" + table(("k", "V / a^3", "rim / a", "thickness / a", "tension / (p a)"), own),
    )


def tube() -> Section:
    """Sections 2 and 5: long tube and rectangle 1 x 3."""
    short = balloon("rectangle", 10000)
    outline = corners_of((-3.0, -0.5), (3.0, -0.5), (3.0, 0.5), (-3.0, 0.5))
    long = inflate(meshed(outline, 2 * VERTICES), film(10000), PRESSURE, backend="native")
    x, y = long.panel.rest_positions.T
    middle = np.abs(x) < 1.5
    rim = middle & (np.abs(y) > 0.5 - 1e-9)
    section_area = (long.volume - short.volume) / 3.0
    end = 0.5 * (3.0 / np.pi - short.volume)
    flat = long.panel.rest_positions[long.panel.triangles]
    shape, areas = gradients(flat)
    strains = green_strains(deformation_gradients(long.positions, long.panel.triangles, shape))
    hoop = film(10000).membrane_stiffness * tension_field(strains, 0.3).stress[:, 1]
    inner = np.abs(flat.mean(axis=1)[:, 0]) < 1.5
    force = float(np.average(hoop[inner], weights=areas[inner]))
    rows = [
        Row("thickness / w", 2.0 * float(long.positions[middle, 2].max()), 2.0 / np.pi, 0.005),
        Row("width / w", 2.0 * float(np.abs(long.positions[rim, 1]).mean()), 2.0 / np.pi, 0.01),
        Row("cross-section / w^2", section_area, 1.0 / np.pi, 0.003),
        Row("membrane force / (p w)", force / PRESSURE, 1.0 / np.pi, 0.015),
        Row("volume that an end costs / w^3", end, 0.0595, None, 3),
        Row("rectangle 1 x 3: V", short.volume, 0.8358, 0.002),
        Row(
            "rectangle 1 x 3: thickness of the middle",
            2.0 * float(short.positions[:, 2].max()),
            0.636,
            0.005,
            4,
        ),
    ]
    return section(
        "2 and 5. Long tube, and rectangle 1 x 3",
        """A strip of width w = 1 and length 6, k = E t / (p w) = 10 000; the cross-section is what 3 w
        more of length hold. The cost of an end is a small difference of large volumes.""",
        rows,
    )


def ring() -> Section:
    """Section 3: two annuli."""
    rows: list[Row] = []
    for k, asked in ((10000, 1.0), (1000, 0.0)):
        found, free = balloon("ring", k, band=RING_BAND), profile(k, 0.5)
        outer = float(silhouette_radii(found).mean())
        inner = float(radii(found, 1).mean())
        if asked:
            rows += [
                Row(f"k = {k}, against k -> inf: V", found.volume, RING_VOLUME, 0.005),
                Row("thickness at the crown", crown(found), RING_THICKNESS, 0.005),
                Row("outer radius of the silhouette", outer, RING_RADIUS, 0.003),
                Row("inner rim", inner, 0.5, 0.002),
            ]
        rows += [
            Row(f"k = {k}, against the profile of that k: V", found.volume, free.volume),
            Row("thickness at the crown", crown(found), free.thickness),
            Row("outer radius of the silhouette", outer, float(free.radius[-1])),
            Row("inner rim", inner, float(free.radius[0])),
        ]
    loose = balloon("ring", 1000)
    return section(
        "3. Two annuli: the ring",
        f"""Flat radii 1/2 and 1, k = E t / (p b), about {VERTICES} vertices, with a sealed band of
        {RING_BAND:g} b: a closed curved tube is unstable, and without a band the hole kinks and the
        volume grows (at k = 1000 to {loose.volume:.4f}, with radii of the hole between
        {radii(loose, 1).min():.2f} and {radii(loose, 1).max():.2f}).

        The closed reference is that of a film that does not stretch. The ring is more elastic than a
        disc: its profile at k = 1000 holds {100 * (profile(1000, 0.5).volume / RING_VOLUME - 1):.2f} %
        more. So the error of the mesh is the one against the profile of the same k.""",
        rows,
    )


def square() -> Section:
    """Section 4: the teabag."""
    rows = []
    for k, volume in ((100, 0.204377), (1000, 0.202864), (10000, 0.202664)):
        rows.append(Row(f"k = {k}: V", balloon("square", k).volume, volume, 0.005))
    found = balloon("square", 10000)
    flat = found.panel.rest_positions
    corners = np.argsort(-np.linalg.norm(flat, axis=1), kind="stable")[:4]
    tips = found.positions[corners, :2] - found.positions[corners, :2].mean(axis=0)
    rows += [
        Row("k = 10000, against k -> inf: V", found.volume, 0.2027, 0.005),
        Row("thickness", 2.0 * float(found.positions[:, 2].max()), 0.504, 0.004 / 0.504, 4),
        Row("corner", float(np.abs(tips).mean()), 0.4575, 0.0005 / 0.4575, 4),
    ]
    plain = []
    for vertices in (400, 800, 1500):
        both = [
            inflate(
                panel("square", vertices),
                film(1000),
                PRESSURE,
                backend="native",
                model=Model(tension_field=relaxed),
            ).volume
            for relaxed in (True, False)
        ]
        plain.append((str(len(panel("square", vertices).rest_positions)), *(f"{one:.4f}" for one in both)))
    more = paragraphs("What a plain shell, which carries compression, would find at k = 1000:")
    return section(
        "4. Square pillow",
        f"Side 1, k = E t / (p side), about {VERTICES} vertices, no sealed band.",
        rows,
        more + "\n" + table(("vertices", "tension field", "plain shell"), plain),
    )


def airbag() -> Section:
    """Section 6: Contri & Schrefler 1988."""
    half = 0.6 / np.sqrt(2.0)
    outline = corners_of((-half, -half), (half, -half), (half, half), (-half, half))
    bag = inflate(meshed(outline), Film("airbag", 588e6, 0.4, 0.6e-3, 0.7, 0.0), 5000.0, backend="native")
    flat = bag.panel.rest_positions
    corners = np.argsort(-np.linalg.norm(flat, axis=1), kind="stable")[:4]
    tips: Floats = bag.positions[corners, :2] - bag.positions[corners, :2].mean(axis=0)
    near = np.linalg.norm(flat[bag.panel.triangles].mean(axis=1), axis=1) < 0.05
    rows = [
        Row("height of the centre, m (derived)", float(bag.positions[:, 2].max()), 0.2163, 0.003, 4),
        Row(
            "the same, published (Jarasjarungkiat et al. 2009)",
            float(bag.positions[:, 2].max()),
            0.21665,
            None,
            4,
        ),
        Row(
            "corner moves along the diagonal, m",
            0.6 - float(np.linalg.norm(tips, axis=1).mean()),
            0.0494,
            0.04,
            3,
        ),
        Row("volume, m3", bag.volume, 0.1250, 0.002, 4),
        Row(
            "stress at the centre, MPa (3.8 to 3.98)",
            float(bag.tensions[near, 0].mean()) / 0.6e3,
            3.89,
            0.0231,
            3,
        ),
    ]
    return section(
        "6. Elastic airbag",
        """Flat square with a diagonal of 1.2 m, t = 0.6 mm, E = 588 MPa, nu = 0.4, p = 5 kPa (Contri and
        Schrefler 1988). The tip of the corner moves on as the mesh is refined.""",
        rows,
    )


def relative_volume() -> Section:
    """Section 12: V / A^1.5."""
    hexagon = circle(1.0, 6)
    triangle = circle(1.0, 3)
    shapes = {
        "disc": (Outline(circle(1.0)), 0.2188),
        "hexagon": (Outline(hexagon), 0.213),
        "square": (corners_of((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)), 0.2027),
        "equilateral triangle": (Outline(triangle), 0.181),
    }
    rows = []
    for name, (outline, reference) in shapes.items():
        found = inflate(meshed(outline), film(10000), PRESSURE, backend="native")
        rows.append(Row(f"{name}: V / A^1.5", found.volume / outline.area**1.5, reference, 0.01, 4))
    return section("12. Puffiness", "V / A^1.5 with A the flat area of one panel, k = 10 000.", rows)


def solvers() -> Section:
    """Native against NumPy."""
    rows = []
    for shape, k, band in (
        ("disc", 500, 0.0),
        ("square", 1000, 0.0),
        ("rectangle", 10000, 0.0),
        ("ring", 1000, 0.1),
    ):
        one, other = (balloon(shape, k, band=band, backend=name) for name in ("native", "numpy"))
        rows.append(Row(f"{shape}: V", one.volume, other.volume, 1e-6, 9))
    return section(
        "Native against NumPy", "The found value is the native solver's, the reference NumPy's.", rows
    )
