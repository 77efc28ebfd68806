# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pumpkin: twelve gores of the natural shape, in which film is taut along the seams alone."""

import FreeCAD as App

import BalloonWorkbench

doc = App.newDocument("Pumpkin")
made = BalloonWorkbench.from_profile(
    doc, gore_length="1 m", gores=12, film="pe", pressure="200 Pa", mesh_size="50 mm"
)
