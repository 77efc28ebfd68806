# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coach's findings before the design, against the simulation of generated shapes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from coach_study import FILM, PRESSURE, SEALS, VERTICES, Score, Truth, compared, new_scores
from drawn_flaws import KINDS, Flawed, flawed
from validation import figures
from validation.correction import PICTURES
from validation.report import Section, paragraphs, table

from BalloonWorkbench.core.advice.advise import advise
from BalloonWorkbench.core.advice.findings import Advice, Finding
from BalloonWorkbench.core.advice.repairs import repaired
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.tracing.picture import read_picture

FIRST, SHAPES = 2000, 240  # seeds
FITTED = 200  # of these once more, with the pattern corrected
#: What makes a finding of a rule true in the simulation.
TRUE_WHEN = {
    "thin_arm": f"in its middle thinner than two seals ({1e3 * SEALS:.0f} mm) or a fifth of the balloon",
    "choked_neck": "less room across than in a tube of 15 mm of film, 1.5 times the intake's",
    "flat_tip": "nothing within 7 % of the size is as thick as two seals",
    "notch": "mean tension within 1/30 of the size at least 3 times the median",
    "warping_ring": "both panels simulated: the seam leaves its plane by 8 % of the size",
    "creasing_ring": "with 3 % of its weld's stiffness the outline moves by 1 % of the size, less than 0.7 of"
    " that with a weld twice as wide",
    "flat_shape": "V / A^1.5 below 0.4 of a disc's",
    "hidden_intake": "necks with less room than the intake part it from more than half of the film",
}


@dataclass
class _Mended:
    """Repairs of one rule: tried, and with the simulated measure better, and good afterwards."""

    tried: int = 0
    better: int = 0
    gone: int = 0
    changes: list[float] = field(default_factory=list)

    @property
    def row(self) -> tuple[str, ...]:
        """Of the table."""
        better, gone = (f"{100 * count / self.tried:.0f} %" for count in (self.better, self.gone))
        return str(self.tried), better, gone, f"{np.median(self.changes):.2f}"


@dataclass
class _Study:
    """Findings on the first so many shapes, and what was predicted over what is simulated."""

    shapes: int
    scores: dict[str, Score] = field(default_factory=new_scores)
    relative_volume: list[float] = field(default_factory=list)
    thickest: list[float] = field(default_factory=list)
    warps: list[float] = field(default_factory=list)
    refused: int = 0

    def cases(self, fitted: bool) -> Iterator[tuple[Flawed, Truth, Advice]]:
        """Each shape that was not refused; fitted: with the pattern corrected."""
        for seed in range(FIRST, FIRST + self.shapes):
            case = flawed(seed)
            try:
                advice, truth = compared(case, self.scores, fitted=fitted)
            except BalloonError:
                self.refused += 1
                continue
            self.relative_volume.append(advice.relative_volume / truth.relative_volume())
            self.thickest.append(float(advice.map.thickness.max() / truth.thick.max()))
            self.warps += [one.measured / truth.warp for one in advice.findings if one.rule == "warping_ring"]
            yield case, truth, advice


def coach(images: Path) -> Section:
    """Precision and recall of each rule, and what the repairs do."""
    mended: dict[str, _Mended] = defaultdict(_Mended)
    drawn, fitted = _Study(SHAPES), _Study(FITTED)
    for case, truth, advice in drawn.cases(fitted=False):
        _mend(case, truth, advice, mended)
    for _ in fitted.cases(fitted=True):
        pass
    text = paragraphs(
        f"""{SHAPES} generated outlines of 0.3 m ({", ".join(KINDS)}, in equal parts), film "mylar" at
        {PRESSURE / 1e3:g} kPa, each its own pattern. The coach inflates it once, coarsely, and
        with holes once more as two panels; the simulation has
        about {VERTICES} vertices. Whether a finding is true is measured on the inflated mesh at the
        finding's place, by code of its own (`tests/core/coach_study.py`). Recall counts the places where
        the generator drew such a part, or for notches all places of the outer rim, and the simulation shows
        the flaw. {drawn.refused} outlines were refused.

        Predicted over simulated: relative volume {_spread(drawn.relative_volume)}, greatest thickness
        {_spread(drawn.thickest)}, height of rings that warp {_spread(drawn.warps)}."""
    )
    text += "\n" + table(
        ("rule", "true when", "findings", "precision", "places", "recall"),
        [_row(rule, drawn.scores[rule]) for rule in TRUE_WHEN],
    )
    text += "\n" + paragraphs(
        f"""{FITTED} of them once more, with the pattern corrected until the balloon looks like the outline.
        The one constant of the coach, by how much that tightens notches, comes from these.
        Predicted over simulated: relative volume {_spread(fitted.relative_volume)}, greatest thickness
        {_spread(fitted.thickest)}, height of rings that warp {_spread(fitted.warps)}."""
    )
    text += "\n" + table(
        ("rule", "findings", "precision", "places", "recall"),
        [(rule, *_row(rule, fitted.scores[rule])[2:]) for rule in TRUE_WHEN],
    )
    text += "\n" + paragraphs(
        """The first repair of each rule on each outline, simulated again: how often the measure improves, how
        often it is within the limit afterwards, and the median of the measure after over before."""
    )
    text += "\n" + table(
        ("repair of", "tried", "better", "within the limit", "measure after / before"),
        [(rule, *one.row) for rule, one in sorted(mended.items())],
    )
    text += "\n" + paragraphs(
        """The example pictures before the design, dark where the balloon will be thick: hints blue,
        warnings orange, serious findings red."""
    )
    figures.advice(_pictures(), images / "validation-coach.png")
    return Section("Coach", text + "\n![Advice on the example pictures](images/validation-coach.png)\n")


def _pictures() -> list[tuple[str, Outline, Advice]]:
    outlines = [(path.stem, read_picture(path, 0.3, None)) for path in sorted(PICTURES.glob("*.png"))]
    said = [(name, outline, advise(outline, FILM)) for name, outline in outlines]
    return [
        (f"{name}: {100 * advice.relative_volume:.0f} %", outline, advice) for name, outline, advice in said
    ]


def _row(rule: str, score: Score) -> tuple[str, ...]:
    findings, places = score.right + score.wrong, score.found + score.missed
    return (
        rule,
        TRUE_WHEN[rule],
        str(findings),
        f"{100 * score.precision:.0f} %" if findings else "",
        str(places),
        f"{100 * score.recall:.0f} %" if places else "",
    )


def _spread(values: list[float]) -> str:
    return f"{np.mean(values):.3f} with a standard deviation of {np.std(values):.3f}"


def _mend(case: Flawed, truth: Truth, advice: Advice, mended: dict[str, _Mended]) -> None:
    """Make the first repair of each rule and simulate again."""
    seen = set()
    for finding in advice.findings:
        if finding.repair is None or finding.rule in seen or finding.repair.kind.is_of_intake:
            continue
        seen.add(finding.rule)
        after = Truth(Flawed(repaired(case.outline, finding.repair), case.sites))
        before_value, value = _measure(truth, finding), _measure(after, finding)
        one = mended[finding.rule]
        one.tried += 1
        larger_is_better = finding.rule in ("thin_arm", "choked_neck")
        one.better += value > before_value if larger_is_better else value < before_value
        one.gone += value >= finding.limit if larger_is_better else value <= finding.limit
        one.changes.append(value / max(before_value, 1e-9))


def _measure(truth: Truth, finding: Finding) -> float:
    place = np.array(finding.place)
    if finding.rule == "thin_arm":
        return truth.thickness(place[None])
    if finding.rule == "choked_neck":
        return truth.tube(place)
    if finding.rule == "flat_tip":
        return truth.flat_length(_rim_near(truth, place))
    return truth.peak(_rim_near(truth, place))


def _rim_near(truth: Truth, place: np.ndarray) -> np.ndarray:
    rim = truth.flat[truth.panel.loops[0]]
    return rim[np.argmin(np.linalg.norm(rim - place, axis=1))]
