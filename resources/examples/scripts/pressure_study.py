# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cushion at three pressures: the table has volume, tension and the safe pressure of each."""

import FreeCAD as App
import Part

import BalloonWorkbench

CORNERS = (0, 0), (240, 0), (240, 160), (0, 160)
doc = App.newDocument("PressureStudy")
outline = doc.addObject("Part::Feature", "Cushion")
outline.Shape = Part.makePolygon([App.Vector(*corner) for corner in (*CORNERS, CORNERS[0])])
made = BalloonWorkbench.from_sketch(doc, outline, film="tpu-nylon", mesh_size="16 mm")
study = BalloonWorkbench.study(made, {"Pressure": ["5 kPa", "10 kPa", "20 kPa"]})
