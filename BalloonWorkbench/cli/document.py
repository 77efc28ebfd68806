# SPDX-License-Identifier: LGPL-2.1-or-later
"""balloon.FCStd from the command line, made by FreeCAD."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from BalloonWorkbench.cli.console import readable
from BalloonWorkbench.cli.freecad_process import FreecadProcess, has_freecad

NAME = "balloon.FCStd"


@contextmanager
def document(
    drawing: str, settings: Any, designs: Any, width: float | None, height: float | None
) -> Iterator[FreecadProcess | None]:
    """The document of balloons, begun at once, to be waited for at the end; None without FreeCAD.

    width, height  of the drawing [m], as they were asked for
    """
    if not has_freecad():
        yield None
        return
    begun = FreecadProcess(__name__, "making the document", drawing, settings, designs, width, height)
    try:
        yield begun
    finally:
        begun.stop()


def make(drawing: str, settings: Any, designs: Any, width: float | None, height: float | None) -> bytes:
    """In FreeCAD's process: the content of the document."""
    from BalloonWorkbench.app.document.fcstd import fcstd_bytes

    with tempfile.TemporaryDirectory() as folder:
        return bytes(fcstd_bytes(_named(drawing, folder), settings, designs, width=width, height=height))


def _named(drawing: str, folder: str) -> str:
    """The drawing under a name that FreeCAD can write down: itself, or a copy."""
    name = readable(drawing)
    return drawing if name == drawing else shutil.copy(drawing, str(Path(folder, Path(name).name)))
