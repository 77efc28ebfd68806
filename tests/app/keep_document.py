# SPDX-License-Identifier: LGPL-2.1-or-later
"""Save a document for tests/resources/documents, as this release and this FreeCAD write it:

    tools/in-freecad.sh build/keep freecadcmd -c "exec(open('tests/app/keep_document.py').read())"

Each release adds one, and all of them must open for good (test_older_documents.py).
"""

import sys
from pathlib import Path

import FreeCAD as App

sys.path.append("tests/app")

import sketches

import BalloonWorkbench
from BalloonWorkbench.app.document import create

NAME = f"{BalloonWorkbench.__version__}-freecad-{'.'.join(App.Version()[:2])}.FCStd"

document = App.newDocument("Kept")
document.Label = "Kept"
parts = create.balloon_from_sketch(document, sketches.rectangle(document), mesh_size=16, material="mylar")
parts.balloon.Pressure = "3 kPa"
parts.pattern.Allowance = 3
document.recompute()
document.saveAs(str(Path("tests/resources/documents", NAME).resolve()))
