# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD restores a document's objects only when it knows their classes already.
import BalloonWorkbench.app.balloon
import BalloonWorkbench.app.gored_body
import BalloonWorkbench.app.group
import BalloonWorkbench.app.outline
import BalloonWorkbench.app.pattern  # noqa: F401
from BalloonWorkbench.app.document import revive
from BalloonWorkbench.app.properties import material

material.register()
revive.watch()
