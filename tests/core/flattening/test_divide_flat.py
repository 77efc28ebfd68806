# SPDX-License-Identifier: LGPL-2.1-or-later
"""Few panels of a body with legs cross themselves when laid flat: it gets more, and says so."""

from __future__ import annotations

from pathlib import Path

import pytest
from solids import ball, box

from BalloonWorkbench.core.bags.check_bag import check_bag
from BalloonWorkbench.core.errors import AssemblyError, InputError
from BalloonWorkbench.core.flattening import divide_flat as place
from BalloonWorkbench.core.flattening.bag_of import bag_of
from BalloonWorkbench.core.flattening.divide_flat import divide_flat
from BalloonWorkbench.core.flattening.flatten import flatten
from BalloonWorkbench.core.segmentation.divide import divide
from BalloonWorkbench.core.targets.read_target import read_target
from BalloonWorkbench.core.targets.target import Target

SPOT = Path(__file__).parents[2] / "resources" / "meshes" / "spot.obj"


def spot() -> Target:
    return read_target(SPOT, width=0.3)


@pytest.mark.slow
def test_more_panels_where_so_few_cross_themselves() -> None:
    with pytest.raises(AssemblyError, match="folded over"):
        check_bag(bag_of(few := divide(spot(), 12), flatten(few)).bag)
    made = divide_flat(spot(), 12)
    assert len(made.names) > 12
    check_bag(bag_of(made, flatten(made)).bag)
    assert any("With 12 panels" in note for note in made.target.notes)


def test_as_many_as_wanted_where_they_lie_flat() -> None:
    made = divide_flat(ball(), 6)
    assert len(made.names) == 6
    assert made.target.notes == divide(ball(), 6).target.notes


@pytest.mark.slow
def test_where_no_number_will_do_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(place, "_lies_flat", lambda _division: False)
    monkeypatch.setattr(place, "_MORE", 1)
    with pytest.raises(InputError, match="With 2 to 4 panels some would cross themselves"):
        divide_flat(box((1.0, 2.0, 4.0)), 2)
