# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example documents that come with the workbench; tools/make_examples.py makes them."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path
from typing import NamedTuple

import FreeCAD as App

import BalloonWorkbench
from BalloonWorkbench.app.properties.property_table import QT_TRANSLATE_NOOP

FOLDER = Path(BalloonWorkbench.__file__).resolve().parent.parent / "resources" / "examples"


class Example(NamedTuple):
    """One document: the name of its file, what it is called, and what there is to see."""

    name: str
    title: str
    tooltip: str

    @property
    def path(self) -> Path:
        """Where it is."""
        return FOLDER / f"{self.name}.FCStd"


EXAMPLES = (
    Example(
        "painted-fish",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Painted fish"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Made with brush and pen: double-click the Outline to paint on"
        ),
    ),
    Example(
        "parametric-heart",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Heart from a spreadsheet"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "A sketch with dimensions: change a cell of the spreadsheet, and all follows"
        ),
    ),
    Example(
        "letter",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Letter"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Arcs in a sketch, as they hang over a party table"),
    ),
    Example(
        "ring",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Ring"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Two circles: change their diameters in the sketch"),
    ),
    Example(
        "airship",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Airship"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Six gores from half an outline in a sketch: change their number"
        ),
    ),
    Example(
        "banded-letter",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Letter with a side band"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Front, back and a band between them: change its width"),
    ),
    Example(
        "pouch",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Pouch"),
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Panels with gussets, whose sizes come from a spreadsheet"),
    ),
    Example(
        "housing",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Filleted housing"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Twelve panels that follow a solid: change its sizes in the spreadsheet"
        ),
    ),
    Example(
        "spot",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Spot in 16 panels"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "A cow from a mesh, by Keenan Crane: change the number of panels"
        ),
    ),
    Example(
        "bottle",
        QT_TRANSLATE_NOOP("BalloonWorkbench", "Bottle"),
        QT_TRANSLATE_NOOP(
            "BalloonWorkbench", "Eight panels for a solid with fillets: change its section or their number"
        ),
    ),
)


def open_copy(example: Example):
    """A new document with an example in it; it has no file yet, so that saving asks for one."""
    # from a path of its own: FreeCAD remembers which document was opened from where, and does not notice that
    # it has no file any more. The same path would give it once more, as edited, or crash when it was closed
    with tempfile.TemporaryDirectory() as folder:
        doc = App.openDocument(shutil.copy(example.path, folder))
    doc.FileName = ""
    return doc
