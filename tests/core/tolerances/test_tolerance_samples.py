# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study of tolerances declares, and the samples that follow from it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.tolerances.samples import FIELDS_ALONE, Sample, read_tolerances
from BalloonWorkbench.core.tolerances.spread import ALONG, ErrorSource, Spread

DECLARED = {
    "cut": {"normal": "0.2mm", "per": "edge"},
    "weld": {"uniform": "0.5mm", "per": "whole"},
    "thickness": {"uniform": "10%"},
    "pressure": {"normal": "100Pa"},
    "temperature": {"normal": "9F"},
}


def proper(data: Any, count: int, seed: int = 1) -> list[Sample]:
    return [each for each in read_tolerances(data, count, seed).samples() if each.name.isdigit()]


def test_spreads_are_read_in_their_units() -> None:
    assert read_tolerances(DECLARED).spreads == {
        ErrorSource.CUT: Spread("normal", 2e-4, along=ALONG),
        ErrorSource.WELD: Spread("uniform", 5e-4),
        ErrorSource.THICKNESS: Spread("uniform", 0.1, relative=True),
        ErrorSource.PRESSURE: Spread("normal", 100.0),
        ErrorSource.TEMPERATURE: Spread("normal", 5.0),
    }


def test_samples_have_the_spread_that_was_declared() -> None:
    samples = proper(DECLARED, 256)
    weld = np.array([each.deviations[ErrorSource.WELD] for each in samples])
    pressure = np.array([each.deviations[ErrorSource.PRESSURE] for each in samples])
    assert np.sort(weld) == pytest.approx(np.linspace(-5e-4, 5e-4, 256), abs=1e-5)
    assert pressure.mean() == pytest.approx(0.0, abs=2.0)
    assert pressure.std() == pytest.approx(100.0, rel=0.03)
    assert abs(np.corrcoef(weld, pressure)[0, 1]) < 0.02


def test_more_samples_begin_with_the_same_ones() -> None:
    """So that a study that is made larger finds those that are there."""
    assert proper(DECLARED, 100)[:30] == proper(DECLARED, 30)
    assert proper(DECLARED, 30) != proper(DECLARED, 30, seed=2)


def test_each_factor_strays_by_itself_too() -> None:
    samples = list(read_tolerances(DECLARED, 100).samples())
    assert samples[0] == Sample("nominal")
    alone = [each for each in samples if each.alone is ErrorSource.PRESSURE]
    assert [each.deviations[ErrorSource.PRESSURE] for each in alone] == pytest.approx(
        [-164.485, 164.485], abs=1e-3
    )
    along = [each for each in samples if each.alone is ErrorSource.CUT]
    assert [each.fields for each in along] == [{ErrorSource.CUT: n} for n in range(1, FIELDS_ALONE + 1)]
    assert len(samples) == 1 + 100 + 4 * 2 + FIELDS_ALONE


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        ({}, "says what strays"),
        ([], "says what strays"),
        ({"glue": {"normal": "1mm"}}, 'called "glue"'),
        ({"cut": "0.2mm"}, "write one such as"),
        ({"cut": {"normal": "-0.2mm"}}, "above 0"),
        ({"cut": {"normal": "0mm"}}, "above 0"),
        ({"cut": {"normal": "0.2"}}, "with its unit"),
        ({"cut": {"normal": 0.2}}, "with its unit"),
        ({"cut": {"normal": "2kPa"}}, "with its unit"),
        ({"cut": {"normal": "2%"}}, "with its unit"),
        ({"cut": {"normal": "nanmm"}}, "with its unit"),
        ({"cut": {"normal": "1mm", "uniform": "1mm"}}, "either"),
        ({"cut": {"per": "edge"}}, "either"),
        ({"cut": {"normal": "1mm", "per": "corner"}}, "per 'corner'"),
        ({"cut": {"normal": "1mm", "along": "0mm"}}, "above 0"),
        ({"cut": {"normal": "1mm", "along": "far"}}, "not a length"),
        ({"cut": {"normal": "1mm", "per": "whole", "along": "5mm"}}, "leave"),
        ({"cut": {"triangle": "1mm"}}, "triangle"),
        ({"thickness": {"normal": "10%", "per": "edge"}}, "per"),
        ({"thickness": {"normal": "30%"}}, "leaves nothing"),
        ({"thickness": {"uniform": "100%"}}, "leaves nothing"),
        ({"pressure": {"normal": "3mm"}}, "with its unit"),
        ({"temperature": {"normal": "10%"}}, "with its unit"),
        ({"strength": {"normal": "3MPa"}}, "with its unit"),
        ({1: {"normal": "1mm"}}, 'called "1"'),
    ],
)
def test_what_makes_no_sense_is_told_in_a_sentence(data: Any, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence) as refused:
        read_tolerances(data)
    assert str(refused.value).endswith((".", "'."))
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("count", [0, -3, 10_000_000, 1.5, "many", True, None])
def test_a_senseless_number_of_samples_is_refused(count: Any) -> None:
    with pytest.raises(InputError, match="1 to 100000 samples"):
        read_tolerances(DECLARED, count)


@pytest.mark.parametrize("seed", [-1, 0.5, "a", True])
def test_a_senseless_seed_is_refused(seed: Any) -> None:
    with pytest.raises(InputError, match="seed"):
        read_tolerances(DECLARED, 10, seed)
