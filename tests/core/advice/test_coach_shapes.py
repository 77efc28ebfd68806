# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coach has an answer for any shape: holes, arms, necks and notches in every combination.

BALLOON_COACHED sets how many shapes of other sizes are tried as well (`make fuzz`: 300).
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from contextlib import suppress
from itertools import product

import numpy as np
import pytest
import shapely
from drawn_shapes import corners_of, generated, oriented, polar

from BalloonWorkbench.core.advice.advise import advise, advise_design
from BalloonWorkbench.core.advice.as_data import finding_data, finding_from, repair_text
from BalloonWorkbench.core.advice.findings import Advice
from BalloonWorkbench.core.advice.places import rim_near, whole
from BalloonWorkbench.core.advice.repairs import repaired
from BalloonWorkbench.core.correction.fit import fit, inflate_outline
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.errors import MeshError, OutlineError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.validity import check

FILM = film("mylar")
COUNT = int(os.environ.get("BALLOON_COACHED", "1"))
#: Each pair of a number of holes, of arms, with and without a neck and a notch, in as few shapes.
PAIRS = [(holes, arms, (holes + arms // 2) % 2 == 0, holes % 4 < 2) for holes in range(5) for arms in (0, 2)]
#: Each feature once with and once without; the pairs with `make fuzz`.
FEATURES = PAIRS if COUNT > 10 else [pair for pair in PAIRS if pair[:2] in ((0, 0), (2, 2))]
ALL = list(product(range(5), range(3), (False, True), (False, True)))
TURN = np.linspace(0.0, 2.0 * np.pi, 120, endpoint=False)


def combined(holes: int, arms: int, neck: bool, notch: bool, seed: int = 0) -> Outline:
    """A body of 200 mm with holes, one of them a ring handle's, thin arms, a room behind a neck, a slot.

    Seeds above 0 give other sizes.
    """
    random = np.random.default_rng(seed)

    def about(size: float) -> float:
        return size * (1.0 if seed == 0 else float(random.uniform(0.6, 1.5)))

    area = shapely.Polygon(polar(0.1 * (1.0 + about(0.05) * np.cos(3.0 * TURN)), TURN))
    for end in [(-0.06 - about(0.1), 0.03), (-0.06 - about(0.1), -0.05)][:arms]:
        area = area.union(shapely.LineString([(0.0, 0.0), end]).buffer(0.5 * about(0.009), quad_segs=4))
    if neck:
        area = area.union(shapely.LineString([(0.0, 0.0), (0.2, 0.0)]).buffer(0.5 * about(0.007)))
        area = area.union(shapely.Point(0.2, 0.0).buffer(about(0.04)))
    if notch:
        half = 0.5 * about(0.02)
        area = area.difference(shapely.Polygon([(0.0, 0.035), (-half, 0.2), (half, 0.2)]))
    if holes > 1:
        handle = shapely.Point(-0.02, -0.115)
        area = area.union(handle.buffer(0.04)).difference(handle.buffer(0.04 - about(0.008)))
    for x, y, corners in [(0.06, 0.04, 3), (-0.055, 0.035, 16), (0.04, -0.055, 2)][: holes - (holes > 1)]:
        area = area.difference(shapely.Point(x, y).buffer(about(0.012), quad_segs=corners))
    largest = max(shapely.get_parts(area), key=lambda part: part.area)
    rings = tuple(oriented(np.array(ring.coords)[:-1], False) for ring in largest.interiors)
    return Outline(oriented(np.array(largest.exterior.coords)[:-1]), rings)


def sound(outline: Outline, advice: Advice) -> None:
    """Each finding is in words and numbers that can be shown, and lies on the shape."""
    film_area = whole(outline).buffer(1e-3 * max(outline.size))
    for finding in advice.findings:
        assert not re.search(r"\b(nan|inf)\b", finding.text), finding.text
        assert np.isfinite([*finding.place, finding.measured, finding.limit]).all(), finding
        if finding.rule not in ("warping_ring", "creasing_ring"):  # their place is the middle of the hole
            assert film_area.covers(shapely.Point(finding.place)), finding
        for line in finding.extent:
            assert line.shape[1:] == (2,), finding
            assert np.isfinite(line).all(), finding
        assert finding_from(finding_data(finding)).text == finding.text


def mended(outline: Outline, advice: Advice) -> Outline:
    """The shape after repairs in turn, the worst of each rule (`make fuzz`: all).

    Each that is offered can be made; made twice it is refused or gives a shape once more.
    """
    all_made = outline
    first = {finding.rule: finding for finding in reversed(advice.findings)}
    for finding in advice.findings if COUNT > 10 else first.values():
        if finding.repair is None:
            continue
        assert repair_text(finding.repair)
        after = repaired(outline, finding.repair)
        assert len(after.holes) == len(outline.holes)
        with suppress(OutlineError):
            check(repaired(after, finding.repair))
        with suppress(OutlineError):  # an earlier repair may have changed that part
            all_made = repaired(all_made, finding.repair)
    return check(all_made)


def coached(outline: Outline, fitted: bool) -> None:
    """All rules, findings and repairs, and the coach once more on the mended shape."""
    advice = advise(outline, FILM, fitted=fitted)
    sound(outline, advice)
    after = mended(outline, advice)
    sound(after, advise(after, FILM, fitted=fitted))


@pytest.mark.slow
@pytest.mark.parametrize("features", FEATURES)
def test_features_beside_each_other_have_an_answer(features: tuple[int, int, bool, bool]) -> None:
    coached(combined(*features), fitted=features[2])


@pytest.mark.parametrize("seed", range(1, 1 + COUNT))
def test_other_sizes_have_an_answer(seed: int) -> None:
    for outline in (combined(*ALL[17 * seed % len(ALL)], seed), generated(seed)):
        with suppress(MeshError):  # too thin to be meshed
            coached(outline, fitted=seed % 2 == 0)


@pytest.mark.slow
@pytest.mark.parametrize(("design", "mesh_size"), [(inflate_outline, 0.013), (fit, 0.018)])
def test_measured_findings_have_an_answer(design: Callable[..., Design], mesh_size: float) -> None:
    """A ring handle, a neck and a slot, inflated as drawn and fitted on a coarse mesh."""
    outline = combined(2, 0, True, True)
    sound(outline, advise_design(design(outline, FILM, 2000.0, mesh_size=mesh_size), FILM))


def test_rim_of_loops_with_different_numbers_of_points() -> None:
    """A square of 300 mm with a square hole of 100 mm: a box on the right side of the hole has that alone."""
    outline = Outline(
        corners_of((0.0, 0.0), (0.3, 0.0), (0.3, 0.3), (0.15, 0.3), (0.0, 0.3)).outer,
        (oriented(np.array([(0.1, 0.1), (0.2, 0.1), (0.2, 0.2), (0.1, 0.2)]), False),),
    )
    (line,) = rim_near(outline, shapely.box(0.19, 0.12, 0.21, 0.18), 1e-9)
    assert np.ptp(line, axis=0) == pytest.approx([0.0, 0.06], abs=1e-8)
    assert line[:, 0] == pytest.approx(0.2)
