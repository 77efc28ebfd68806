# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids in STEP, IGES and BREP files on the command line, read by FreeCAD."""

from __future__ import annotations

import pickle
import shutil
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from BalloonWorkbench.cli.freecad_process import FreecadProcess, has_freecad

if TYPE_CHECKING:
    from BalloonWorkbench.core.bag_design.source import ReadSolid
    from BalloonWorkbench.core.targets.target import Division


def solid_reader() -> ReadSolid | None:
    """What reads a solid; None without FreeCAD."""
    return _read if has_freecad() else None


def _read(path: str, panels: int) -> Division:
    """The panels of the solid in a file. Raises InputError, MissingPackageError, ProgramFault."""
    reading = FreecadProcess(__name__, "reading the solid", path, panels)
    try:
        division: Division = pickle.loads(reading.content())
    finally:
        reading.stop()
    return division


def make(path: str, panels: int) -> bytes:
    """In FreeCAD's process: the panels of the solid, packed."""
    from BalloonWorkbench.app.drawings.solid import division_of

    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder, "solid" + Path(path).suffix.lower())  # FreeCAD reads no name in every coding
        shutil.copy(path, plain)
        return pickle.dumps(division_of(str(plain), panels))
