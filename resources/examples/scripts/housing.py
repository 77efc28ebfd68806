# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid with round edges, followed by twelve panels."""

import FreeCAD as App

import BalloonWorkbench

doc = App.newDocument("Housing")
block = doc.addObject("Part::Box", "Block")
block.Length, block.Width, block.Height = 240, 160, 120
doc.recompute()
solid = doc.addObject("Part::Fillet", "Housing")
solid.Base = block
solid.Edges = [(number, 45, 45) for number in range(1, 13)]
doc.recompute()
made = BalloonWorkbench.from_body(doc, solid, panels=12, mesh_size="22 mm")
block.Visibility = solid.Visibility = False
