# SPDX-License-Identifier: LGPL-2.1-or-later
"""The size that a volume or a lift needs: closed forms of the disc, data of the party trade, few designs."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawn_shapes import NAMED, corners_of, polar

from BalloonWorkbench.cli import command_line
from BalloonWorkbench.core.correction.fit import Method, fit, inflate_outline
from BalloonWorkbench.core.design.design import Design
from BalloonWorkbench.core.design.size_goal import (
    LARGEST,
    TOLERANCE,
    Buoyancy,
    DesignAtSize,
    Scaling,
    SizeGoal,
    design_to_size,
    foretold,
    scaling_of,
)
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.film.filling import Filling, gas
from BalloonWorkbench.core.film.film import Film
from BalloonWorkbench.core.film.library import custom_film, film
from BalloonWorkbench.core.job import Settings, design_outline
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.tracing.picture import read_picture
from BalloonWorkbench.core.types import Progress, no_progress

PICTURES = Path(__file__).parents[3] / "resources" / "examples" / "pictures"
INCH, FOOT = 0.0254, 0.3048
#: Two discs of film that does not stretch: rim 1/A of the flat radius a, volume (2 pi/3) a^3/A^2.
A = 1.311028777146
# stiff enough to be inextensible: E t / (p L) is about 10 000
STIFF = replace(custom_film(2.4e10, 0.3, 25e-6, 0.035), seal_width=0.0)
DISC = Outline(polar(0.15, np.linspace(0.0, 2.0 * np.pi, 240, endpoint=False)))


class Counted:
    """A way of designing that keeps what it made."""

    def __init__(self, work: Callable[..., Design], film: Film, pressure: float, share: float = 18.0) -> None:
        self.work, self.film, self.pressure, self.share = work, film, pressure, share
        self.made: list[Design] = []

    def __call__(self, outline: Outline, *, start: Design | None, progress: Progress) -> Design:
        edge = max(outline.size) / self.share
        extra = {"method": Method(start=start)} if self.work is fit else {}
        self.made.append(self.work(outline, self.film, self.pressure, mesh_size=edge, **extra))
        return self.made[-1]


def bordered(width: float) -> Callable[[Outline], float]:
    """Area of film with a border round a disc."""
    return lambda seam: float(np.pi * (np.sqrt(seam.area / np.pi) + width) ** 2)


HELIUM = Buoyancy(1.0375, 0.035, bordered(0.007))


def radius_for(lift: float, buoyancy: Buoyancy, border: float) -> float:
    """Of the flat disc, by hand: the largest root of l (2 pi/3) a^3/A^2 - 2 d pi (a + border)^2 = lift."""
    weight = 2.0 * np.pi * buoyancy.density
    cubic = buoyancy.lightness * 2.0 * np.pi / 3.0 / A**2
    roots = np.roots([cubic, -weight, -weight * 2.0 * border, -weight * border**2 - lift])
    return float(max(root.real for root in roots if abs(root.imag) < 1e-9))


@pytest.mark.parametrize("litres", [1.0, 40.0])
def test_a_flat_disc_of_a_volume_has_the_radius_of_the_closed_form(litres: float) -> None:
    work = Counted(inflate_outline, STIFF, 300.0)
    goal = SizeGoal(volume=1e-3 * litres)
    design = design_to_size(work, DISC, goal, HELIUM, corrected=False)
    assert design.inflation.volume == pytest.approx(1e-3 * litres, rel=TOLERANCE)
    radius = (1e-3 * litres * 1.5 / np.pi * A**2) ** (1.0 / 3.0)
    assert 0.5 * design.target.size[0] == pytest.approx(radius, rel=5e-3)
    assert len(work.made) <= 2


def test_a_disc_drawn_gets_its_radius_through_the_correction() -> None:
    """V = (2 pi/3) A r^3, r as it is seen."""
    work = Counted(fit, film("mylar"), 300.0, 26.0)
    design = design_to_size(work, DISC, SizeGoal(volume=0.01), HELIUM)
    assert 0.5 * design.target.size[0] == pytest.approx((0.01 * 1.5 / np.pi / A) ** (1.0 / 3.0), rel=6e-3)
    assert len(work.made) <= 2
    assert design.reached


@pytest.mark.parametrize("grams", [0.0, 5.0, 500.0])
def test_a_flat_disc_of_a_lift_has_the_radius_of_the_closed_form(grams: float) -> None:
    work = Counted(inflate_outline, STIFF, 300.0)
    design = design_to_size(work, DISC, SizeGoal(lift=1e-3 * grams), HELIUM, corrected=False)
    assert 0.5 * design.target.size[0] == pytest.approx(radius_for(1e-3 * grams, HELIUM, 0.007), rel=0.012)
    assert len(work.made) <= 3
    scaling = scaling_of(design, HELIUM)
    missed = abs(scaling.lift_at(1.0, HELIUM) - 1e-3 * grams)
    assert missed <= max(TOLERANCE * 1e-3 * grams, 1e-3 * HELIUM.lightness * scaling.volume)


def test_one_design_tells_from_which_size_on_it_floats() -> None:
    scaling = scaling_of(inflate_outline(DISC, STIFF, 300.0, mesh_size=0.014), HELIUM)
    assert scaling.lift_at(1.0, HELIUM) < 0.0
    scale = scaling.floating(HELIUM)
    assert scale is not None
    assert 0.15 * scale == pytest.approx(radius_for(0.0, HELIUM, 0.007), rel=0.01)
    assert scaling.lift_at(1.001 * scale, HELIUM) > 0.0 > scaling.lift_at(0.999 * scale, HELIUM)


def trade_foil() -> tuple[Film, Buoyancy]:
    """Foil of 32 g/m2 (the trade says 31 to 32), sealed to its edge, helium at 20 degrees."""
    foil = replace(film("mylar"), areal_density=0.032)
    return foil, Buoyancy(Filling().lightness(2000.0), 0.032, lambda seam: seam.area)


@pytest.mark.parametrize(("inches", "feet"), [(18.0, 0.5), (24.0, 1.2)])
def test_volumes_of_the_trade_give_its_sizes(inches: float, feet: float) -> None:
    """Party balloons are sold by the width of the flat film; their volumes are good to 10 %, so 3.3 %."""
    foil, buoyancy = trade_foil()
    work = Counted(inflate_outline, foil, 2000.0)
    design = design_to_size(work, DISC, SizeGoal(volume=feet * FOOT**3), buoyancy, corrected=False)
    assert design.pattern.size[0] == pytest.approx(inches * INCH, rel=0.033)


def test_the_lift_of_an_18_inch_balloon_gives_18_inches() -> None:
    """4.2 g, good to 10 %: by d(lift)/d(size) of the closed form that is 1.9 % of the size."""
    foil, buoyancy = trade_foil()
    work = Counted(inflate_outline, foil, 2000.0)
    design = design_to_size(work, DISC, SizeGoal(lift=4.2e-3), buoyancy, corrected=False)
    assert design.pattern.size[0] == pytest.approx(18.0 * INCH, rel=0.019)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["star"])
def test_pictures_meet_their_goal_in_few_designs_and_the_later_ones_are_short(name: str) -> None:
    drawing = read_picture(PICTURES / f"{name}.png", 0.3, None)
    work = Counted(fit, film("mylar"), 2000.0)
    design = design_to_size(work, drawing, SizeGoal(volume=0.02), HELIUM)
    assert design.inflation.volume == pytest.approx(0.02, rel=TOLERANCE)
    assert len(work.made) <= 3
    assert design.passes == sum(made.passes for made in work.made)
    assert work.made[-1].passes < work.made[0].passes
    assert design.residual.mean < 0.005 * max(design.target.size)


def test_the_size_drawn_does_not_matter() -> None:
    """A drawing of 3 m and one of 3 mm give the same balloon."""
    sizes = []
    for scale in (0.01, 10.0):
        work = Counted(inflate_outline, film("mylar"), 2000.0)
        drawing = Outline(scale * DISC.outer)
        made = design_to_size(work, drawing, SizeGoal(volume=0.01), HELIUM, corrected=False)
        sizes.append(made.target.size)
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-9)


def test_the_forecast_is_that_of_the_closed_forms() -> None:
    """V of a disc drawn (2 pi/3) A r^3, of the flat disc (2 pi/3) r^3/A^2; of a strip w wide pi w^2/4 and
    w^2/pi for each of its length."""
    strip = corners_of((0.0, 0.0), (20.0, 0.0), (20.0, 0.1), (0.0, 0.1))
    for corrected, disc, tube in ((True, A, 0.25 * np.pi), (False, A**-2, 1.0 / np.pi)):
        assert foretold(DISC, corrected).volume == pytest.approx(2.0 * np.pi / 3.0 * disc * 0.15**3, rel=0.11)
        assert foretold(strip, corrected).volume == pytest.approx(tube * 0.1**2 * 20.0, rel=0.11)


class Never:
    """A way of designing that must not be used."""

    def __call__(self, outline: Outline, *, start: Design | None, progress: Progress) -> Design:
        raise AssertionError("designed although the goal makes no sense")


@pytest.mark.parametrize(
    ("goal", "buoyancy", "text"),
    [
        (SizeGoal(), HELIUM, "either"),
        (SizeGoal(0.01, 0.01), HELIUM, "either"),
        (SizeGoal(volume=0.0), HELIUM, "10l"),
        (SizeGoal(volume=float("nan")), HELIUM, "10l"),
        (SizeGoal(volume=1e9), HELIUM, "20 m"),
        (SizeGoal(volume=1e-12), HELIUM, "10 mm"),
        (SizeGoal(lift=-0.001), HELIUM, "5g"),
        (SizeGoal(lift=1e6), HELIUM, "lighter film or gas"),
        (SizeGoal(lift=0.0), replace(HELIUM, lightness=-0.1), "never floats"),
        (SizeGoal(lift=0.0), replace(HELIUM, density=40.0), "20 m large, this balloon would lack"),
    ],
)
def test_goals_out_of_reach_are_refused_with_advice(goal: SizeGoal, buoyancy: Buoyancy, text: str) -> None:
    never: DesignAtSize = Never()
    with pytest.raises(InputError, match=text):
        design_to_size(never, DISC, goal, buoyancy)


def test_a_film_too_heavy_to_float_below_the_largest_size_says_so() -> None:
    scaling = Scaling(0.3, 0.01, 0.1, 0.02)
    assert scaling.floating(replace(HELIUM, density=40.0)) is None
    scale = scaling.floating(replace(HELIUM, density=1.0))
    assert scale is not None and scale * 0.3 < LARGEST


def test_a_missed_goal_is_told() -> None:
    """A work whose volume jumps about never meets it."""
    design = fit(NAMED["disc"], film("mylar"), 2000.0, mesh_size=0.06)
    factors = iter([1.0, 1.3, 0.7, 1.3, 0.7])

    def work(outline: Outline, *, start: Design | None, progress: Progress) -> Design:
        volume = next(factors) * 0.01
        return replace(design, target=outline, inflation=replace(design.inflation, volume=volume))

    told = design_to_size(work, NAMED["disc"], SizeGoal(volume=0.02), HELIUM).warnings
    assert any("off its goal" in text for text in told)


def test_a_volume_to_inflate_to_and_a_goal_exclude_each_other() -> None:
    settings = Settings(volume=0.01, goal=SizeGoal(volume=0.01))
    with pytest.raises(InputError, match="exclude"):
        design_outline(DISC, settings, no_progress)


def report_of(words: list[str], out: Path) -> dict:  # type: ignore[type-arg]
    assert command_line.main([*words, "--out", str(out)]) == 0
    return dict(json.loads((out / "report.json").read_text()))


def test_goals_on_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    square = tmp_path / "square.json"
    square.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    words = ["inflate", str(square), "--mesh-size", "40mm"]
    volume = report_of([*words, "--target-volume", "20"], tmp_path / "v")
    assert volume["inflated"]["volume_m3"] == pytest.approx(0.02, rel=TOLERANCE)
    # teabag: 0.2027 of the cube of its side
    assert volume["input"]["width_mm"] == pytest.approx(1e3 * (0.02 / 0.2027) ** (1.0 / 3.0), rel=0.015)
    assert volume["goal"] == {"volume_m3": 0.02, "lift_g": None}
    words += ["--gas", "hydrogen", "--altitude", "500m"]
    lift = report_of([*words, "--target-lift", "0.05N"], tmp_path / "l")
    assert lift["lift"]["lift_g"] == pytest.approx(1e3 * 0.05 / 9.80665, rel=TOLERANCE)
    assert lift["lift"]["gas"] == "hydrogen"
    assert lift["lift"]["floats"] is True
    assert "carries 5.1 g" in capsys.readouterr().out
    width = lift["input"]["width_mm"]
    again = report_of([*words, "--width", f"{width:.3f}mm"], tmp_path / "w")
    assert again["lift"]["weight_g"] == pytest.approx(lift["lift"]["weight_g"], rel=1e-3)


def test_weight_is_that_of_the_film_that_is_cut(tmp_path: Path) -> None:
    """Of a square with a weld of 5 mm and 2 mm beyond it, and a neck of about 30 mm by 24 mm."""
    square = tmp_path / "square.json"
    square.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [200, 0], [200, 200], [0, 200]]}))
    told = report_of(["inflate", str(square), "--mesh-size", "25mm"], tmp_path / "out")["lift"]
    area = 0.214**2 + 0.030 * 0.024
    assert told["weight_g"] == pytest.approx(2e3 * area * film("mylar").areal_density, rel=0.015)
    helium = Filling(gas("helium")).lightness(2000.0)
    assert told["lift_g"] == pytest.approx(1e3 * helium * 0.2027 * 0.2**3 - told["weight_g"], abs=0.05)
    assert told["floats"] is False
    assert told["floats_from_width_mm"] > 200.0


def test_the_other_shapes_of_a_drawing_follow_the_largest(tmp_path: Path) -> None:
    """Two squares, one twice as wide as the other; a weld of one width would stiffen the small one more."""
    squares = tmp_path / "squares.json"
    parts = [
        {"outer": [[0, 0], [200, 0], [200, 200], [0, 200]]},
        {"outer": [[300, 0], [400, 0], [400, 100], [300, 100]]},
    ]
    squares.write_text(json.dumps({"unit": "mm", "parts": parts}))
    words = ["inflate", str(squares), "--mesh-size", "30mm", "--target-volume", "8"]
    words += ["--weld-rigidity", "0.001"]
    large, small = report_of(words, tmp_path / "out")["parts"]
    assert large["inflated"]["volume_m3"] == pytest.approx(0.008, rel=TOLERANCE)
    assert small["outline"]["width_mm"] == pytest.approx(0.5 * large["outline"]["width_mm"])
    assert small["inflated"]["volume_m3"] == pytest.approx(0.001, rel=0.03)


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (["--target-volume", "10", "--width", "300mm"], "--width"),
        (["--target-volume", "10", "--target-lift", "5"], "not allowed"),
        (["--target-volume", "much"], "much"),
        (["--target-lift", "5 miles"], "miles"),
        (["--target-lift", "5", "--gas", "neon"], "neon"),
        (["--target-lift", "5", "--gas", "warm-air", "--gas-temperature", "10C"], "never floats"),
        (["--target-lift", "5", "--air-temperature", "20X"], "20X"),
        (["--target-lift", "5", "--altitude", "30000m"], "altitude"),
        (["--target-volume", "10", "--gas-volume", "10l"], "exclude"),
        (["--width", "300mm", "--symmetry", "perhaps"], "perhaps"),
    ],
)
def test_bad_goals_end_with_one_line(
    words: list[str], named: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    star = str(PICTURES / "star.png")
    assert (
        command_line.main(["design", star, *words, "--mesh-size", "60mm", "--out", str(tmp_path / "out")])
        == 2
    )
    complaint = capsys.readouterr().err
    assert complaint.count("\n") == 1
    assert named in complaint
    assert not (tmp_path / "out").exists()
