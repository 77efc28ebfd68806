# SPDX-License-Identifier: LGPL-2.1-or-later
"""A letter with a side band, so that its strokes keep their width; from an outline by its corners."""

import FreeCAD as App
import Part

import BalloonWorkbench

CORNERS = (0, 0), (180, 0), (180, 70), (70, 70), (70, 300), (0, 300)
doc = App.newDocument("Letter")
outline = doc.addObject("Part::Feature", "L")
outline.Shape = Part.makePolygon([App.Vector(*corner) for corner in (*CORNERS, CORNERS[0])])
made = BalloonWorkbench.from_sketch(doc, outline, band="50 mm", mesh_size="20 mm")
