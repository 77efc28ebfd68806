# SPDX-License-Identifier: LGPL-2.1-or-later
"""A ring: a hole needs no more than a second circle."""

import FreeCAD as App
import Part

import BalloonWorkbench

doc = App.newDocument("Ring")
plate = doc.addObject("Part::Feature", "Plate")
plate.Shape = Part.Face([Part.Wire(Part.makeCircle(radius)) for radius in (150, 70)])
made = BalloonWorkbench.from_sketch(doc, plate, film="mylar", notches=8, mesh_size="14 mm")
plate.Visibility = False
