# SPDX-License-Identifier: LGPL-2.1-or-later
"""Goals against balloons by formula, whose best one is known, with runners that solve nothing."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.errors import BalloonError, ExportError, InputError
from BalloonWorkbench.core.studies.folder import StudyFolder
from BalloonWorkbench.core.studies.job import Finished, Job
from BalloonWorkbench.core.studies.kinds.goal import COBYLA, OPTUNA, read_goal
from BalloonWorkbench.core.studies.kinds.goal_study import GoalStudy, goal_lines, goal_study, run_goal
from BalloonWorkbench.core.studies.kinds.search import MOST_TRIALS, best, search
from BalloonWorkbench.core.studies.study import Row
from BalloonWorkbench.core.units import parse_length

WEIGHT = {"mylar": 0.035, "pe": 0.05, "pvc": 0.4}  # kg/m2
PRICE = {"mylar": 1.5, "pe": 0.2, "pvc": 6.0}
CHEAPEST = {
    "minimize": "film_cost",
    "over": {"width": ["100mm", "900mm"], "material": ["mylar", "pe", "pvc"]},
    "limits": {"lift": ">= 20 g"},
}


def balloon(width: float, film: str, pressure: float = 2000.0) -> dict[str, Any]:
    """The report of a balloon that holds 0.2 w^3 and has 2.5 w^2 of film, with the noise of a mesh."""
    noise = 1.0 + 1e-3 * math.sin(1e5 * width)
    volume, area = 0.2 * width**3 * noise, 2.5 * width**2
    return {
        "inflated": {"volume_m3": volume, "width_mm": 1e3 * width},
        "pressure_Pa": pressure,
        "maker": {
            "film_area_m2": area,
            "film_cost": PRICE[film] * area,
            "floating": [{"lift_g": 1e3 * (1.0 * volume - WEIGHT[film] * area)}],
            "strength": {"safe_pressure_Pa": 800.0 / width},
        },
        "solve": {"converged": True},
        "warnings": [],
    }


@dataclass
class ByFormula:
    """A runner that knows its balloons; fails: balloons of that film cannot be made."""

    fails: str = ""
    breaks_after: float = math.inf
    done: list[str] = field(default_factory=list)

    def run(self, jobs: Iterable[Job], place: Path) -> Generator[Finished, None, None]:
        folder = StudyFolder(place)
        for job in jobs:
            if len(self.done) >= self.breaks_after:
                yield Finished(job.key, "The disk is full.", kept=False, ends=True)
                return
            self.done.append(job.key)
            values = dict(each.lstrip("-").split("=") for each in job.request["arguments"][2:])
            film = values.get("material", "mylar")
            if film == self.fails:
                folder.keep_failure(job.key, "It cannot be made.")
                yield Finished(job.key, "It cannot be made.")
                continue
            width = 1e-3 * float(values["width"].removesuffix("mm"))
            pressure = 1e3 * float(values.get("pressure", "2kPa").removesuffix("kPa"))
            report = balloon(width, film, pressure)
            folder.keep(job.key, {"report.json": json.dumps(report).encode()})
            yield Finished(job.key)


def study_with(goal: Mapping[str, Any], folder: Path) -> GoalStudy:
    (folder / "a.png").write_text("a")
    return goal_study({"goal": goal}, {"input": "a.png"}, folder)


def width_of_lift(film: str, lift: float) -> float:
    """At which a balloon carries a lift [kg]."""
    low, high = 0.1, 5.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        short = 0.2 * middle**3 - 2.5 * WEIGHT[film] * middle**2 < lift
        low, high = (middle, high) if short else (low, middle)
    return high


def test_the_cheapest_balloon_that_carries_a_lift(tmp_path: Path) -> None:
    """Of each film the smallest that does, and of these the cheapest."""
    study = study_with(CHEAPEST, tmp_path)
    sought = run_goal(study, tmp_path / "out", ByFormula())
    assert sought.reached
    assert sought.best is not None and sought.best.results is not None
    costs = {film: PRICE[film] * 2.5 * width_of_lift(film, 0.02) ** 2 for film in ("mylar", "pe")}
    assert sought.best.values["material"] == min(costs, key=lambda film: costs[film]) == "pe"
    assert sought.best.results["film_cost"] == pytest.approx(costs["pe"], rel=0.02)
    assert sought.best.results["lift_g"] >= 20.0
    assert goal_lines(study, sought)[0].startswith(
        f"Best of {len(sought.trials)} balloons: material pe, width 7"
    )
    assert "It is filled to 2 kPa, its safe pressure is 1" in goal_lines(study, sought)[-1]


def test_samples_find_the_deepest_valley() -> None:
    """Downhill from the middle ends in the near one; the same samples come each time."""
    pytest.importorskip("optuna")
    over = {"over": {"width": ["1 m", "2 m"]}}

    def price(values: Row) -> dict[str, float]:
        width = parse_length(str(values["width"]))
        return {"film_cost": min((width - 1.55) ** 2 + 0.1, 25.0 * (width - 1.08) ** 2)}

    ways = {
        way: read_goal({"minimize": "film_cost", **over, "search": way}, Path()) for way in (COBYLA, OPTUNA)
    }
    trials = {way: search(goal, {}, price) for way, goal in ways.items()}
    found = {way: best(goal, trials[way]) for way, goal in ways.items()}
    widths = {way: parse_length(str(top.values["width"])) for way, top in found.items() if top is not None}
    assert widths[COBYLA] == pytest.approx(1.55, abs=0.01)
    assert widths[OPTUNA] == pytest.approx(1.08, abs=0.05)
    assert search(ways[OPTUNA], {}, price) == trials[OPTUNA]


def test_every_balloon_is_a_row_and_none_is_made_twice(tmp_path: Path) -> None:
    study, out = study_with(CHEAPEST, tmp_path), tmp_path / "out"
    first = ByFormula()
    sought = run_goal(study, out, first)
    with (out / "table.csv").open(newline="", encoding="utf-8") as text:
        rows = [*csv.DictReader(text)]
    assert len(rows) == len(sought.trials) == len(first.done) == len(set(first.done))
    assert len(rows) <= 3 * MOST_TRIALS
    assert [row["material"] for row in rows] == sorted(row["material"] for row in rows)
    before = (out / "table.csv").read_bytes(), (out / "goal.json").read_bytes()
    again = ByFormula()
    run_goal(study, out, again)
    assert not again.done
    assert ((out / "table.csv").read_bytes(), (out / "goal.json").read_bytes()) == before


def test_a_search_that_was_broken_off_goes_on(tmp_path: Path) -> None:
    study, out = study_with(CHEAPEST, tmp_path), tmp_path / "out"
    with pytest.raises(ExportError, match="disk is full"):
        run_goal(study, out, ByFormula(breaks_after=5))
    rest = ByFormula()
    run_goal(study, out, rest)
    whole = ByFormula()
    run_goal(study, tmp_path / "other", whole)
    assert len(rest.done) == len(whole.done) - 5
    assert (out / "table.csv").read_bytes() == (tmp_path / "other" / "table.csv").read_bytes()


def test_an_unreachable_goal_tells_the_nearest(tmp_path: Path) -> None:
    study = study_with(
        {**CHEAPEST, "over": {"width": ["100mm", "300mm"], "material": ["pe", "mylar"]}}, tmp_path
    )
    sought = run_goal(study, tmp_path / "out", ByFormula())
    assert not sought.reached
    assert sought.best is not None
    assert sought.best.values["material"] == "mylar"
    told = json.loads((tmp_path / "out" / "goal.json").read_text())
    assert (told["reached"], told["limits"]) == (False, ["lift_g at least 20"])
    assert "is within the limits; the nearest: " in goal_lines(study, sought)[0]
    assert "lift_g at least 20 but " in goal_lines(study, sought)[0]


def test_the_largest_volume_with_a_safe_pressure(tmp_path: Path) -> None:
    """800 Pa m / w is at least 4 kPa up to 200 mm."""
    goal = {
        "maximize": "volume",
        "over": {"width": ["50mm", "900mm"]},
        "limits": {"safe_pressure": ">= 4 kPa"},
    }
    study = study_with(goal, tmp_path)
    sought = run_goal(study, tmp_path / "out", ByFormula())
    assert not any("fill it less" in line for line in goal_lines(study, sought))
    assert sought.reached
    assert sought.best is not None and sought.best.results is not None
    assert sought.best.results["width_mm"] == pytest.approx(200.0, rel=0.02)
    assert sought.best.results["safe_pressure_Pa"] >= 4000.0


def test_a_wanted_lift_is_met(tmp_path: Path) -> None:
    goal = {"reach": {"lift": "20 g"}, "over": {"width": ["300mm", "1200mm"]}}
    sought = run_goal(study_with(goal, tmp_path), tmp_path / "out", ByFormula())
    assert sought.best is not None and sought.best.results is not None
    assert sought.best.results["lift_g"] == pytest.approx(20.0, abs=1.0)


def test_two_values_at_once(tmp_path: Path) -> None:
    """The least film whose width and pressure are both bounded; the corner of two limits."""
    goal = {
        "minimize": "film_area",
        "over": {"width": ["100mm", "900mm"], "pressure": ["1kPa", "5kPa"]},
        "limits": {"width": ">= 300 mm", "pressure": [">= 2 kPa", "<= 3 kPa"]},
    }
    sought = run_goal(study_with(goal, tmp_path), tmp_path / "out", ByFormula())
    assert sought.reached
    assert sought.best is not None and sought.best.results is not None
    assert sought.best.results["width_mm"] == pytest.approx(300.0, rel=0.02)


def test_a_best_balloon_at_an_end_of_a_range_says_so(tmp_path: Path) -> None:
    study = study_with({"maximize": "volume", "over": {"width": ["100mm", "900mm"]}}, tmp_path)
    sought = run_goal(study, tmp_path / "out", ByFormula())
    assert any("at an end of its range" in line for line in goal_lines(study, sought))


def test_balloons_that_cannot_be_made_are_left_behind(tmp_path: Path) -> None:
    study = study_with(CHEAPEST, tmp_path)
    sought = run_goal(study, tmp_path / "out", ByFormula(fails="pe"))
    assert sought.best is not None
    assert sought.best.values["material"] == "mylar"
    only = study_with({**CHEAPEST, "over": {"width": ["100mm", "900mm"], "material": ["pe"]}}, tmp_path)
    none = run_goal(only, tmp_path / "none", ByFormula(fails="pe"))
    assert none.best is None
    assert "could be made" in goal_lines(only, none)[0]


def test_films_alone_are_each_tried_once(tmp_path: Path) -> None:
    goal = {"minimize": "film_cost", "over": {"material": ["mylar", "pe", "pvc"]}}
    study = goal_study({"goal": goal}, {"input": "a.png", "width": "600mm"}, tmp_path)
    (tmp_path / "a.png").write_text("a")
    runner = ByFormula()
    sought = run_goal(study, tmp_path / "out", runner)
    assert len(runner.done) == 3
    assert sought.best is not None
    assert sought.best.values == {"material": "pe"}


def test_a_search_asks_for_the_same_balloons_each_time() -> None:
    goal = read_goal({**CHEAPEST, "over": {"width": ["100mm", "900mm"]}}, Path())

    def tried() -> list[Any]:
        return [
            each.values
            for each in search(
                goal, {}, lambda values: {"film_cost": float(str(values["width"])[:-2]), "lift_g": 21.0}
            )
        ]

    assert tried() == tried()


@pytest.mark.parametrize(
    ("goal", "sentence"),
    [
        ([], "no JSON object"),
        ({"over": {"width": ["1m", "2m"]}}, "one of minimize"),
        ({**CHEAPEST, "maximize": "volume"}, "one of minimize"),
        ({**CHEAPEST, "colour": 1}, "no 'colour'"),
        ({**CHEAPEST, "search": "luck"}, "no way to search"),
        ({**CHEAPEST, "minimize": "price"}, "no result 'price'"),
        ({"reach": "lift", "over": {"width": ["1m", "2m"]}}, "one result and its value"),
        ({"reach": {"lift": "2 kPa"}, "over": {"width": ["1m", "2m"]}}, "no(t a mass| value for lift_g)"),
        ({"minimize": "film_cost"}, "what may be chosen"),
        ({**CHEAPEST, "over": {}}, "what may be chosen"),
        ({**CHEAPEST, "over": {"breadth": ["1m", "2m"]}}, "no column"),
        ({**CHEAPEST, "over": {"width": ["2m", "1m"]}}, "no room"),
        ({**CHEAPEST, "over": {"width": ["1kPa", "2kPa"]}}, "not a length"),
        ({**CHEAPEST, "over": {"gores": [1, 5000]}}, "combinations"),
        ({**CHEAPEST, "limits": {"lift": "20 g"}}, "no limit"),
        ({**CHEAPEST, "limits": {"lift": ">= 20 m"}}, "no(t a mass| value for lift_g)"),
        ({**CHEAPEST, "limits": {"lift": ">= nan"}}, "no(t a mass| value for lift_g)"),
        ({**CHEAPEST, "limits": {"wieght_kg": "<= 20"}}, "no result 'wieght_kg'"),
        ({**CHEAPEST, "limits": {"lift": [">= 20 g", "<= 10 g"]}}, "exclude each other"),
        ({**CHEAPEST, "limits": ["lift"]}, "cannot be read"),
    ],
)
def test_a_senseless_goal_is_told_in_a_sentence(goal: Any, sentence: str, tmp_path: Path) -> None:
    with pytest.raises(BalloonError, match=sentence) as refused:
        read_goal(goal, tmp_path)
    assert "\n" not in str(refused.value)


def test_a_goal_without_an_input_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no inputs"):
        goal_study({"goal": CHEAPEST}, {}, tmp_path)


def test_a_search_that_is_interrupted_ends(tmp_path: Path) -> None:
    """As by Ctrl+C while a balloon is made: all searches and the runner end, and what was made stays."""
    runner = ByFormula()

    def interrupt(done: int, _of: int, _last: Finished | None) -> None:
        if done == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_goal(study_with(CHEAPEST, tmp_path), tmp_path / "out", runner, interrupt)
    assert len([*(tmp_path / "out").rglob("report.json")]) >= 4
