# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the coach says beside what the simulation shows.

What makes a finding true is measured on the inflated mesh at a place, by means of its own:

    thin_arm      thinner than two seals or a fifth of the balloon, along the middle of the arm
    choked_neck   less room across than a tube of film of 1.5 times the intake's width
    flat_tip      no place as thick as two seals within 7 % of the size
    notch         mean tension within a thirtieth of the size at least 3 times the median
    warping_ring  both panels simulated, started twisted: the seam leaves its plane by 8 % of the size
    creasing_ring with 3 % of the weld's stiffness the outline moves by 1 % of the size, and at most 0.7
                  times as far with a weld twice as wide
    flat_shape    V / A^1.5 below 0.4 of the disc's
    hidden_intake necks with less room than the intake part it from more than half of the film
    delicate_intake  within 15 % of the size of the place nothing is 0.3 times as thick as the balloon
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
import shapely
from drawn_flaws import Flawed
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import cKDTree

from BalloonWorkbench.core.advice.advise import advise
from BalloonWorkbench.core.advice.findings import Advice, Finding
from BalloonWorkbench.core.correction.fit import fit
from BalloonWorkbench.core.design.compare import laid_over, residual
from BalloonWorkbench.core.design.silhouette import silhouette
from BalloonWorkbench.core.film.library import film
from BalloonWorkbench.core.geometry.triangulation import signed_areas
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.intake.places import intake_of
from BalloonWorkbench.core.solver.inflate import inflate
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.solver.model import Model
from BalloonWorkbench.core.types import Floats

FILM = film("mylar")
PRESSURE = 2000.0
VERTICES = 500
SEALS = 2.0 * FILM.seal_width
INTAKE_WIDTH = intake_of(PatternOptions()).width
DISC = 1.218524 / np.pi**1.5
TWIST = 0.3


class Truth:
    """The simulated balloon of an outline: fitted to it, or with the outline as its pattern."""

    def __init__(self, case: Flawed, fitted: bool = False) -> None:
        self.case = case
        mesh_size = size_for(case.outline, VERTICES)
        if fitted:
            self.balloon = fit(case.outline, FILM, PRESSURE, mesh_size=1.2 * mesh_size).inflation
        else:
            self.balloon = inflate(triangulate(case.outline, mesh_size), FILM, PRESSURE)
        self.panel = self.balloon.panel
        self.size = max(case.outline.size)
        self.flat = self.balloon.positions[:, :2] if fitted else self.panel.rest_positions
        self.thick = 2.0 * self.balloon.positions[:, 2]
        self.at = LinearNDInterpolator(self.flat, self.balloon.positions)
        self.areas = signed_areas(self.panel.rest_positions, self.panel.triangles)
        self.centres = self.flat[self.panel.triangles].mean(axis=1)
        tension = self.balloon.tensions[:, 0]
        order = np.argsort(tension)
        share = np.cumsum(self.areas[order])
        self.tension = tension / tension[order][np.searchsorted(share, 0.5 * share[-1])]
        self.film = shapely.Polygon(case.outline.outer, list(case.outline.holes))

    def thickness(self, points: Floats) -> float:
        """Median along a line [m]."""
        return float(np.nanmedian(2.0 * self.at(points)[:, 2]))

    def tube(self, place: Floats) -> float:
        """Flat width of the tube with the room of the narrowest section through a place [m]."""
        lines = []
        for angle in np.radians(np.arange(0.0, 180.0, 3.0)):
            ray = self.size * np.array([np.cos(angle), np.sin(angle)])
            cuts = shapely.LineString([place - ray, place + ray]).intersection(self.film)
            lines.append(min(shapely.get_parts(cuts), key=lambda one: one.distance(shapely.Point(place))))
        start, end = shapely.get_coordinates(min(lines, key=lambda one: one.length))[[0, -1]]
        points = self.at(start + np.linspace(0.002, 0.998, 101)[:, None] * (end - start))
        points = points[np.isfinite(points[:, 0])]
        step = np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1)
        return float(np.sqrt(np.pi * ((points[1:, 2] + points[:-1, 2]) @ step)))

    def flat_length(self, apex: Floats) -> float:
        """Distance from a tip to the first place as thick as two seals, relative to the size."""
        away, angle = np.meshgrid(np.linspace(0.0, 0.4, 201), np.radians(np.arange(0.0, 360.0, 5.0)))
        fan = apex + self.size * away[..., None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        thick = np.nan_to_num(2.0 * self.at(fan)[..., 2]) >= SEALS
        return float(away[thick].min()) if thick.any() else 1.0

    def peak(self, place: Floats) -> float:
        """Mean tension near a place over the median."""
        near = np.linalg.norm(self.centres - place, axis=1) < self.size / 30.0
        if not near.any():
            near[np.argmin(np.linalg.norm(self.centres - place, axis=1))] = True
        return float(self.tension[near] @ self.areas[near] / self.areas[near].sum())

    def peaks(self) -> Iterator[Floats]:
        """Places of the outer rim with a tension peak, the highest first, each with its surroundings."""
        rim = self.flat[self.panel.loops[0]]
        values = np.array([self.peak(place) for place in rim])
        left = values >= 3.0
        while left.any():
            best = int(np.argmax(np.where(left, values, 0.0)))
            yield rim[best]
            left &= np.linalg.norm(rim - rim[best], axis=1) > self.size / 12.0

    @cached_property
    def warp(self) -> float:
        """Height of the seam of both panels, started as one saddle or the other, relative to the size.

        Of two states at rest that with more air is the one with less energy.
        """
        rest, rim = self.panel.rest_positions, np.concatenate(self.panel.loops)
        turned = replace(self.panel, rest_positions=rest @ np.array([[1.0, 1.0], [-1.0, 1.0]]) / np.sqrt(2.0))
        model = Model(two_panels=True, twist=TWIST)
        both = [inflate(panel, FILM, PRESSURE, model=model) for panel in (self.panel, turned)]
        rounder = max(both, key=lambda one: one.volume)
        return float(np.ptp(rounder.positions[rim, 2]) / self.size)

    @cached_property
    def creased(self) -> tuple[float, float]:
        """Largest distance to the outline of the balloon, relative to the size, of those whose weld keeps 3 %
        of its stiffness: one as wide, one twice as wide, from the flat film or from the kinked balloon."""
        rim = np.concatenate(self.panel.loops)

        def moved(balloon: Inflation) -> float:
            laid = laid_over(balloon, self.balloon.positions[rim, :2])
            return float(residual(silhouette(self.balloon), silhouette(laid)).max / self.size)

        weak, wide = (
            replace(FILM, seal_width=times * FILM.seal_width, weld_rigidity=0.03 * FILM.weld_rigidity)
            for times in (1.0, 2.0)
        )
        kinked = inflate(self.panel, weak, PRESSURE)
        wider = [inflate(self.panel, wide, PRESSURE, start=start) for start in (None, kinked)]
        return moved(kinked), max(moved(one) for one in wider)

    def relative_volume(self) -> float:
        """V / A^1.5 relative to a disc's."""
        return float(self.balloon.volume / self.areas.sum() ** 1.5 / DISC)

    def entered(self) -> float:
        """Part of the film that the intake opens into before a neck narrower than it."""
        loop = self.case.outline.outer
        centre = np.asarray(self.film.centroid.coords[0])
        at = shapely.Point(loop[np.argmax(np.linalg.norm(loop - centre, axis=1))])
        rooms = self.film
        for rule, line in self.case.sites:
            if rule == "choked_neck" and self.tube(line[0]) < INTAKE_WIDTH:
                rooms = rooms.difference(shapely.box(line[0, 0] - 1e-5, -1.0, line[0, 0] + 1e-5, 1.0))
        entered = min(shapely.get_parts(rooms), key=at.distance)
        return float(entered.area / self.film.area)

    def thickest_near(self, place: Floats) -> float:
        """Greatest thickness within 15 % of the size of a place, over the balloon's."""
        near = np.linalg.norm(self.flat - place, axis=1) < 0.15 * self.size
        return float(self.thick[near].max() / self.thick.max()) if near.any() else 0.0

    def holds(self, rule: str, place: Floats) -> bool:
        """Whether the simulation shows at a place (k, 2) what a rule says."""
        where = place[0]
        measured: dict[str, Callable[[], bool]] = {
            "thin_arm": lambda: self.thickness(place) < max(SEALS, 0.2 * self.thick.max()),
            "choked_neck": lambda: self.tube(where) < 1.5 * INTAKE_WIDTH,
            "flat_tip": lambda: self.flat_length(where) > 0.07,
            "notch": lambda: self.peak(where) >= 3.0,
            "warping_ring": lambda: self.warp > 0.08,
            "creasing_ring": lambda: self.creased[0] > 0.01 and self.creased[1] < 0.7 * self.creased[0],
            "flat_shape": lambda: self.relative_volume() < 0.4,
            "hidden_intake": lambda: self.entered() < 0.5,
            "delicate_intake": lambda: self.thickest_near(where) < 0.3,
        }
        return measured[rule]()


@dataclass
class Score:
    """Counts of one rule."""

    right: int = 0
    wrong: int = 0
    found: int = 0
    missed: int = 0
    stray: list[str] = field(default_factory=list)

    @property
    def precision(self) -> float:
        """Part of the findings that the simulation confirms."""
        return self.right / max(self.right + self.wrong, 1)

    @property
    def recall(self) -> float:
        """Part of the places where the simulation shows it that are found."""
        return self.found / max(self.found + self.missed, 1)


def compared(
    case: Flawed, scores: dict[str, Score], name: str = "", fitted: bool = False
) -> tuple[Advice, Truth]:
    """Advice on a shape before its design, counted against what its simulation shows."""
    truth = Truth(case, fitted)
    advice = advise(case.outline, FILM, fitted=fitted)
    count(case, truth, advice, scores, name)
    return advice, truth


def count(case: Flawed, truth: Truth, advice: Advice, scores: dict[str, Score], name: str = "") -> None:
    """Count right and wrong findings, and places found and missed."""
    for finding in advice.findings:
        score = scores[finding.rule]
        if truth.holds(finding.rule, np.array([finding.place])):
            score.right += 1
        else:
            score.wrong += 1
            score.stray.append(f"{name} wrong at {finding.place}: {finding.text}")
    whole = np.zeros((1, 2))
    sites = [*case.sites, *(("notch", place[None]) for place in truth.peaks())]
    sites += [(rule, whole) for rule in ("flat_shape", "hidden_intake")]
    for rule, line in sites:
        if not truth.holds(rule, line):
            continue
        if any(finding.rule == rule and _near(finding, line, truth.size) for finding in advice.findings):
            scores[rule].found += 1
        else:
            scores[rule].missed += 1
            scores[rule].stray.append(f"{name} missed at {line.mean(axis=0)}")


def _near(finding: Finding, line: Floats, size: float) -> bool:
    if finding.rule in ("flat_shape", "hidden_intake", "delicate_intake", "warping_ring", "creasing_ring"):
        return True
    return float(cKDTree(line).query(finding.place)[0]) < size / 15.0


def new_scores() -> dict[str, Score]:
    """A score for each rule that comes up."""
    return defaultdict(Score)
