# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pouch with gussets: flat panels by their sizes, sealed edge to edge."""

import FreeCAD as App

import BalloonWorkbench

doc = App.newDocument("Pouch")
made = BalloonWorkbench.from_panels(
    doc, "Pouch", width="200 mm", height="300 mm", depth="100 mm", film="pe", mesh_size="20 mm"
)
