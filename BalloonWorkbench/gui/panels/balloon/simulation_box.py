# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the panel about the simulation: how fine, what is given, which solver, what is simulated."""

from __future__ import annotations

from BalloonWorkbench.app.balloon import PROPERTIES
from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage


class SimulationBox(PropertyPage):
    """Edits how a balloon is simulated; nobody has to."""

    def __init__(self, balloon):
        super().__init__(balloon)
        for item in PROPERTIES:
            if item.label and item.page == "Solver":
                self.form.add(item)
