# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions whose unit is another than that of the property: FreeCAD takes their number in silence."""

import pytest

from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create

UNITS = {
    "area": "20 mm * 30 mm",
    "length": "2 * 150 mm",
    "volume": "3 l",
    "pressure": "2 kPa + 1 kPa",
    "angle": "30 deg",
    "plain": "2 * 150",
    "force": "3 N",
}


@pytest.fixture
def sheet(doc):
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    for row, (name, text) in enumerate(UNITS.items(), start=1):
        sheet.set(f"A{row}", f"={text}")
        sheet.setAlias(f"A{row}", f"{name}_")
    doc.recompute()
    return sheet


@pytest.mark.parametrize("given", UNITS)
def test_a_length_takes_lengths_and_plain_numbers(doc, sheet, given):
    body = create.make(doc, "Tetra", "Bag").outline
    body.Ready = "Tetrahedron"
    doc.recompute()
    body.setExpression("Edge", f"Sheet.{given}_")
    doc.recompute()
    if given in ("length", "plain"):
        assert body.Status == status.READY
        assert body.Edge.Value == pytest.approx(300.0)
    else:
        assert not status.is_ready(body)
        for word in ("Edge", body.Label, f"Sheet.{given}_", "is a length"):
            assert word in body.Status
        # it comes back by itself
        body.setExpression("Edge", None)
        body.Edge = 300
        doc.recompute()
        assert body.Status == status.READY


@pytest.mark.parametrize("given", UNITS)
def test_a_pressure_takes_pressures_and_plain_numbers(doc, sheet, given):
    made = create.make(doc, "Tetra", "Bag")
    made.balloon.setExpression("Pressure", f"Sheet.{given}_")
    doc.recompute()
    said = "its expression" in made.balloon.Status
    assert said == (given not in ("pressure", "plain")), made.balloon.Status
