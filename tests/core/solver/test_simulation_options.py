# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the simulation from the settings and the command line to the balloon and its report."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.cli.settings import settings_of
from BalloonWorkbench.core.errors import Cancelled, InputError, MeshError
from BalloonWorkbench.core.film.library import film, with_grain
from BalloonWorkbench.core.job import Settings, design_outline, make_balloon
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.outline.symmetry import exact_mirror
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.solver.volume_load import search_pressure
from BalloonWorkbench.core.units import pressure_text

SQUARE = {"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}
RECTANGLE = np.array([[0.0, 0.0], [0.2, 0.0], [0.2, 0.15], [0.0, 0.15]])
COARSE = Settings(film=film("pe"), mesh_size=0.015, correct=False)


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory):
    """The report of a square inflated with options of the command line, without the files."""
    drawing = tmp_path_factory.mktemp("in") / "square.json"
    drawing.write_text(json.dumps(SQUARE))

    @cache
    def report(*words: str) -> dict[str, Any]:
        options = command_line.parser().parse_args(
            ["inflate", str(drawing), "--out", "out", "--mesh-size", "16mm", *words]
        )
        return make_balloon(drawing, settings_of(options)).report

    return report


def refused(tmp_path: Path, capsys: pytest.CaptureFixture[str], *words: str) -> str:
    drawing, out = tmp_path / "square.json", tmp_path / "out"
    drawing.write_text(json.dumps(SQUARE))
    assert command_line.main(["inflate", str(drawing), "--mesh-size", "25mm", "--out", str(out), *words]) == 2
    assert not out.exists()
    complaint = capsys.readouterr().err
    assert complaint.count("\n") == 1
    return complaint


def test_usual_options_are_not_mentioned(run) -> None:
    report = run()
    assert report["solve"]["integrator"] == "quasi-static Newton"
    assert report["solve"]["options"] == {}
    assert report["load"] == {"kind": "pressure", "target_volume_m3": None}
    assert report["material"]["grain"] is None
    shares = report["inflated"]["area_shares"]
    assert sum(shares.values()) == pytest.approx(1.0)
    # film that hardly stretches covers a pillow with wrinkles
    assert shares["wrinkled"] > 0.5
    # one tension strains the film by tension / (E t), a second one across takes some of that back
    film_stiffness = report["material"]["E_Pa"] * report["material"]["thickness_m"]
    tension = report["inflated"]["max_tension_N_per_m"]
    assert 0.6 * tension / film_stiffness < report["inflated"]["max_strain"] < 1.01 * tension / film_stiffness


@pytest.mark.parametrize(
    ("words", "options"),
    [
        (("--plain-shell",), {"tension_field": False}),
        (("--no-bending",), {"bending": False}),
        (("--bending-floor", "1e-4"), {"bending_floor": 1e-4}),
        (("--two-panels",), {"two_panels": True}),
    ],
)
def test_option_reaches_the_solver_and_the_report(run, words, options) -> None:
    usual = run()
    report = run(*words)
    assert report["solve"]["options"] == options
    volumes = [told["inflated"]["volume_m3"] for told in (usual, report)]
    assert volumes[0] != volumes[1]
    assert volumes[1] < 0.97 * volumes[0] if "tension_field" in options else volumes[1] > 0.97 * volumes[0]
    if "bending" in options:
        assert report["solve"]["flexural_rigidity_N_m"] == 0.0
    if "bending_floor" in options:
        ratio = report["solve"]["flexural_rigidity_N_m"] / (1e-4 * report["pressure_Pa"] * 0.2**3)
        assert ratio == pytest.approx(1.0)


def test_newmark_on_the_command_line(run) -> None:
    usual = run()
    report = run("--solver", "newmark")
    assert (report["backend"], report["solve"]["integrator"]) == ("newmark", "Newmark in time")
    assert report["inflated"]["volume_m3"] == pytest.approx(usual["inflated"]["volume_m3"], rel=1e-3)


def test_volume_on_the_command_line(run) -> None:
    report = run("--gas-volume", "1.7 l")
    assert report["load"] == {"kind": "volume", "target_volume_m3": 1.7e-3}
    assert report["inflated"]["volume_m3"] == pytest.approx(1.7e-3, rel=1e-3)
    again = run("--pressure", str(report["pressure_Pa"]))
    assert again["inflated"]["volume_m3"] == pytest.approx(1.7e-3, rel=1e-3)


def test_grain_on_the_command_line(run) -> None:
    soft = run("--material", "pe", "--young-across", "5e7")
    turned = run("--material", "pe", "--young-across", "5e7", "--grain", "90")
    assert soft["material"]["grain"] == {"E_across_Pa": 5e7, "angle_deg": 0.0}
    assert turned["material"]["grain"]["angle_deg"] == pytest.approx(90.0)
    inflated, other = soft["inflated"], turned["inflated"]
    assert inflated["volume_m3"] > run("--material", "pe")["inflated"]["volume_m3"]
    assert abs(inflated["height_mm"] - inflated["width_mm"]) > 1.0  # of a square
    assert other["width_mm"] == pytest.approx(inflated["height_mm"], rel=2e-3)
    assert other["height_mm"] == pytest.approx(inflated["width_mm"], rel=2e-3)


def test_everything_at_once_as_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    drawing, out = tmp_path / "square.json", tmp_path / "out"
    drawing.write_text(json.dumps(SQUARE))
    words = ["inflate", str(drawing), "--out", str(out), "--mesh-size", "25mm", "--gas-volume", "1.7 l"]
    words += ["--no-bending", "--results", "npz", "--frames", "3"]
    assert command_line.main(words) == 0
    report = json.loads((out / "report.json").read_text())
    assert f"Pressure: {pressure_text(report['pressure_Pa'])}\n" in capsys.readouterr().out
    with np.load(out / "results.npz") as found:
        assert len(found["triangles"]) == 2 * report["mesh"]["triangles"]
        assert found["thickness_mm"].max() == pytest.approx(report["inflated"]["thickness_mm"])
    names = sorted(path.name for path in out.glob("inflation*"))
    assert names == ["inflation-1.vtu", "inflation-2.vtu", "inflation-3.vtu", "inflation.pvd"]


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (("--gas-volume", "much"), "much"),
        (("--gas-volume", "1 l"), " l at any pressure"),
        (("--gas-volume", "50 l"), " l at any pressure"),
        (("--gas-volume", "2 l", "--pressure", "2kPa"), "--pressure"),
        (("--solver", "magic"), "magic"),
        (("--solver", "native", "--no-native"), "--no-native"),
        (("--grain", "30"), "--young-across"),
        (("--young-across", "1e13"), "across"),
        (("--young-across", "4e10"), "turn the grain"),
        (("--young-across", "3e9", "--grain", "nan"), "angle"),
        (("--young-across", "3e9", "--grain", "30", "--two-panels"), "grain"),
        (("--bending-floor", "-1"), "floor"),
        (("--bending-floor", "nan"), "floor"),
        (("--results", "stl"), "stl"),
        (("--frames", "1"), "two frames"),
    ],
)
def test_senseless_options_are_refused(tmp_path: Path, capsys, words, named) -> None:
    assert named in refused(tmp_path, capsys, *words)


def test_endless_triangles_are_refused_in_words() -> None:
    with pytest.raises(MeshError, match="too coarse"):
        design_outline(Outline(RECTANGLE), replace(COARSE, correct=True, mesh_size=1e200))


def test_grain_is_within_what_a_film_can_have() -> None:
    base = film("pe")
    grained = with_grain(base, 0.5 * base.young_modulus, math.radians(20.0))
    assert replace(grained, young_modulus_across=None, grain_angle=0.0) == base
    limit = base.young_modulus / base.poisson_ratio**2
    with_grain(base, 0.98 * limit)
    with pytest.raises(InputError, match="turn the grain"):
        with_grain(base, limit)


def test_whole_turns_of_a_grain_change_nothing() -> None:
    def kept(angle: float) -> float:
        return with_grain(film("pe"), 2e8, math.radians(angle)).grain_angle

    assert kept(-300.0) == math.radians(-300.0)
    assert math.degrees(kept(760.0)) == pytest.approx(40.0)
    assert abs(kept(1e308)) < math.tau  # once it overflowed where panels are laid on film


@pytest.mark.slow
def test_design_to_a_volume_still_looks_like_the_drawing() -> None:
    """At a higher pressure the same silhouette needs a smaller pattern."""
    outline = Outline(RECTANGLE)
    settings = replace(COARSE, correct=True)
    usual = design_outline(outline, settings)
    wanted = 1.04 * usual.inflation.volume
    fuller = design_outline(outline, replace(settings, volume=wanted))
    assert fuller.inflation.volume == pytest.approx(wanted, rel=1e-3)
    assert fuller.inflation.report.pressure > usual.inflation.report.pressure
    assert fuller.residual.mean < 0.01 * 0.2
    assert fuller.pattern.area < usual.pattern.area
    assert fuller.seconds > fuller.inflation.report.seconds


def test_design_to_a_volume_can_be_stopped() -> None:
    texts: list[str] = []

    def stop(fraction: float, text: str) -> bool:
        texts.append(text)
        assert 0.0 <= fraction <= 1.0
        return not text.startswith("trial 2")

    settings = replace(COARSE, volume=1.1e-3)
    with pytest.raises(Cancelled):
        design_outline(Outline(RECTANGLE), settings, stop)
    assert texts[0].startswith("trial 1, ")


def test_both_panels_stay_together_in_a_design() -> None:
    design = design_outline(Outline(RECTANGLE + 0.3), replace(COARSE, model=Model(two_panels=True)))
    inflation = design.inflation
    assert inflation.lower is not None
    seam = inflation.panel.loops[0]
    np.testing.assert_allclose(inflation.lower[seam], inflation.positions[seam], atol=1e-12)
    assert design.silhouette.outer.mean(axis=0) == pytest.approx([0.4, 0.375], abs=2e-3)


@pytest.mark.parametrize("volume", [1.05, 1.3, 1.9])
def test_pressure_of_a_known_law_is_found(volume: float) -> None:
    """V = 1 + 2 p / u, the law of a stiff film; few trials."""
    tried: list[float] = []

    def solve(pressure: float) -> float:
        tried.append(pressure)
        return 1.0 + 2.0 * pressure / 5e4

    found = search_pressure(volume, 5e4, solve, lambda value: value)
    assert found == pytest.approx(volume, rel=1e-4)
    assert tried[-1] == pytest.approx((volume - 1.0) * 2.5e4, rel=0.01)
    assert len(tried) <= 9


def test_a_grain_aslant_makes_an_aslant_pattern() -> None:
    """Of a rectangle, which looks the same in a mirror."""
    grained = with_grain(film("pe"), 0.2 * film("pe").young_modulus, math.radians(30.0))
    plain, aslant = (
        design_outline(Outline(RECTANGLE), replace(COARSE, film=one, correct=True))
        for one in (film("pe"), grained)
    )
    assert exact_mirror(plain.pattern) is not None
    assert exact_mirror(aslant.pattern) is None
    assert aslant.residual.mean < 0.01 * 0.2
