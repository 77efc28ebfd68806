# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a design's outline may move if its weld creases: against independent inflations of its pattern."""

from __future__ import annotations

import io
import json
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from drawn_shapes import NAMED

from BalloonWorkbench.core.correction.fit import fit, inflate_outline
from BalloonWorkbench.core.design import weld_range
from BalloonWorkbench.core.design.compare import far_stretches, laid_over, misfit, residual
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.fairing import faired_seam
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.design.weld_range import with_weld_range
from BalloonWorkbench.core.errors import Cancelled, MeshError
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.nearest import nearest_on_loops
from BalloonWorkbench.core.job import Settings, design_outline
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pictures.preview import preview_png
from BalloonWorkbench.core.reports import report
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model

FILM = film("mylar")
MESH = 0.016  # m


@cache
def designed(name: str) -> Design:
    return design_outline(NAMED[name], Settings(film=FILM, mesh_size=MESH))


def size(design: Design) -> float:
    return max(design.target.size)


def inflated(design: Design, weld: str, mesh: float) -> Inflation:
    """The written pattern, inflated from flat on another mesh and laid over the design's balloon."""
    panel = triangulate(faired_seam(design.pattern), mesh)
    balloon = inflate(panel, FILM, 2000.0, model=Model(weld=weld))
    line = design.inflation.panel
    flat = [line.rest_positions[loop] for loop in line.loops]
    nearest = nearest_on_loops(flat, panel.rest_positions[np.concatenate(panel.loops)])
    starts = design.inflation.positions[np.concatenate(line.loops), :2]
    ends = np.concatenate([np.roll(design.inflation.positions[loop, :2], -1, axis=0) for loop in line.loops])
    share = nearest.share[:, None]
    return laid_over(balloon, (1.0 - share) * starts[nearest.edge] + share * ends[nearest.edge])


def test_a_ring_may_move_farther_than_a_disc() -> None:
    """A closed tube kinks without the stiffness of its weld; the rim of a disc only scallops."""
    ring, disc = (designed(name).weld_range for name in ("ring", "disc"))
    assert ring is not None and disc is not None
    assert ring.residual.mean > 1.2 * disc.residual.mean
    assert ring.residual.p95 > 1.5 * disc.residual.p95
    assert ring.residual.max > 2.0 * disc.residual.max
    length, around = (
        sum(one.end - one.start for one in creases if one.loop == 0)
        for creases in (ring.creases, disc.creases)
    )
    assert length > around


@pytest.mark.parametrize("mesh", [0.7 * MESH, MESH])
def test_numbers_are_those_of_the_pattern_with_a_weld_that_crumples(mesh: float) -> None:
    design = designed("heart")
    assert design.weld_range is not None
    anew = residual(design.target, silhouette(inflated(design, "crumpled", mesh)))
    told = design.weld_range.residual
    assert told.mean == pytest.approx(anew.mean, rel=0.25, abs=3e-4 * 0.3)
    assert told.p95 == pytest.approx(anew.p95, rel=0.25, abs=1e-3 * 0.3)
    assert told.max == pytest.approx(anew.max, rel=0.25, abs=2e-3 * 0.3)
    assert told.mean > 1.5 * design.residual.mean


def test_creases_are_where_the_weld_moves_the_outline() -> None:
    design = designed("heart")
    assert design.weld_range is not None
    smooth, creased = (silhouette(inflated(design, weld, MESH)) for weld in ("elastic", "crumpled"))
    worst = design.weld_range.creases[0]
    apart = misfit(smooth, creased)
    assert worst.max == pytest.approx(far_stretches(smooth, apart)[0].max, rel=0.25)
    assert float(nearest_on_loops(smooth.loops, worst.place[None]).distance[0]) < 0.005 * size(design)
    assert [stretch.max for stretch in design.weld_range.creases] == sorted(
        (stretch.max for stretch in design.weld_range.creases), reverse=True
    )


def test_a_sentence_tells_place_and_amount() -> None:
    ring, star = designed("ring"), designed("star")
    (sentence,) = (text for text in ring.warnings if text.startswith("If the weld creases"))
    away, x, y = re.findall(r"-?[\d.]+", sentence)[:3]
    assert ring.weld_range is not None
    worst = ring.weld_range.creases[0]
    assert float(away) == pytest.approx(1e3 * worst.max, rel=0.05)
    assert (float(x), float(y)) == pytest.approx(tuple(1e3 * worst.place), abs=0.06)
    assert star.weld_range is not None and not star.weld_range.creases
    assert not [text for text in star.warnings if "weld creases" in text]


def test_the_report_has_its_numbers() -> None:
    design = designed("ring")
    source = report.Source("ring.json", "json", design.target)
    data = json.loads(json.dumps(report.build(source, FILM, design)))["design"]["weld_range"]
    assert set(data) == {"silhouette_error_mm", "relative_error", "creases", "converged"}
    assert design.weld_range is not None
    assert data["silhouette_error_mm"]["max"] == pytest.approx(1e3 * design.weld_range.residual.max)
    assert data["relative_error"] == pytest.approx(design.weld_range.residual.mean / size(design))
    assert set(data["creases"][0]) == {"loop", "start_mm", "end_mm", "at_mm", "mean_mm", "max_mm"}
    assert len(data["creases"]) == len(design.weld_range.creases)
    plain = replace(design, weld_range=None)
    assert report.build(source, FILM, plain)["design"]["weld_range"] is None


def test_the_preview_shows_creases() -> None:
    from matplotlib.image import imread

    def violet(design: Design) -> int:
        picture = imread(io.BytesIO(preview_png([design], [build_pattern(design.pattern, 0.005)])))
        red, green, blue = (picture[..., part] for part in range(3))
        return np.count_nonzero((red < 0.5) & (green < 0.35) & (blue > 0.65))

    ring = designed("ring")
    assert violet(ring) > violet(replace(ring, weld_range=None)) + 500


@pytest.mark.parametrize("unlike", ["crumpled", "both panels", "no weld", "as drawn", "plain shell"])
def test_only_of_a_corrected_pattern_whose_weld_is_elastic(unlike: str) -> None:
    models = {
        "crumpled": Model(weld="crumpled"),
        "both panels": Model(two_panels=True),
        "plain shell": Model(tension_field=False),
    }
    plain = replace(FILM, seal_width=0.0) if unlike == "no weld" else FILM
    design = inflate_outline(NAMED["disc"], plain, 2000.0, mesh_size=0.04, model=models.get(unlike))
    design = replace(design, passes=0 if unlike == "as drawn" else 1)
    assert with_weld_range(design, plain) is design


def test_progress_rises_to_its_end_and_can_stop_it() -> None:
    seen: list[float] = []

    def watch(fraction: float, text: str) -> bool:
        seen.append(fraction)
        texts.add(text.partition(":")[0])
        return not stopping or not text.startswith("if the weld creases")

    texts: set[str] = set()
    stopping = False
    settings = Settings(film=FILM, mesh_size=0.03)
    design_outline(NAMED["disc"], settings, watch)
    assert seen == sorted(seen)
    assert 0.9 < seen[-1] <= 1.0
    assert "if the weld creases" in texts
    stopping = True
    with pytest.raises(Cancelled):
        design_outline(NAMED["disc"], settings, watch)


def test_what_cannot_be_simulated_is_left_out_with_a_note(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(outline: Outline, size: float) -> None:
        raise MeshError("Too thin.")

    design = fit(NAMED["disc"], FILM, 2000.0, mesh_size=0.03)
    monkeypatch.setattr(weld_range, "triangulate", refuse)
    without = with_weld_range(design, FILM)
    assert without.weld_range is None
    assert without.warnings[len(design.warnings) :] == (
        "How far the outline moves if the weld creases could not be simulated. Too thin.",
    )


def test_a_last_good_state_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def unsettled(*arguments: object, **options: object) -> Inflation:
        balloon = inflate(*arguments, **options)  # type: ignore[arg-type]
        return replace(balloon, report=replace(balloon.report, converged=False))

    design = fit(NAMED["disc"], FILM, 2000.0, mesh_size=0.03)
    monkeypatch.setattr(weld_range, "inflate", unsettled)
    found = with_weld_range(design, FILM)
    assert found.weld_range is not None and not found.weld_range.converged
    assert "did not come to rest" in found.warnings[-1]
