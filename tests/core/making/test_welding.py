# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hours of welding follow from way and handling, and say on which basis."""

from __future__ import annotations

import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.making.trade_figures import making
from BalloonWorkbench.core.making.welding import welding_time


def test_way_and_handling_add_up() -> None:
    time = welding_time(60.0, 12, 0.5, 5.0)
    assert time.hours == pytest.approx(3.0)
    assert time.sentence() == "It takes 3 h at 0.5 m/min and 5 min for each seam."


def test_what_is_assumed_is_told() -> None:
    time = welding_time(120.0, 0)
    assert time.hours == pytest.approx(2.0)
    assert "at 1 m/min" in time.sentence()
    assert any("assumed" in source and "Welding" in source for source in making().sources)


@pytest.mark.parametrize(("speed", "handling"), [(0.0, 1.0), (-1.0, 1.0), (float("nan"), 1.0), (1.0, -1.0)])
def test_no_time_runs_backwards(speed: float, handling: float) -> None:
    with pytest.raises(InputError, match="speed of welding"):
        welding_time(1.0, 1, speed, handling)
