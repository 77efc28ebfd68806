# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is in a file: an outline comes out of it, or a sentence that says what to do; soon, in bounds.

BALLOON_FILES sets how many files are tried (`make fuzz`: 10 000).
"""

from __future__ import annotations

import os
import re
import resource
import time
from pathlib import Path

import broken_files
import numpy as np

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.outline.read import read_drawing

COUNT = int(os.environ.get("BALLOON_FILES", "500"))
SECONDS = 6.0  # of processor time
MEGABYTES = 1500

_ADVICE = re.compile(
    r"\b(Save|Choose|Use|Write|Check|Make|Simplify|Leave|Give|Draw|Close|Part|Join|Remove|Install|Enlarge|"
    r"bring|keep|part|join|close|separate|remove|enlarge|leave|choose|draw|give|make|use|move)\b"
)


def tried(path: Path) -> Drawing | None:
    """The shapes in a file, the largest one meshed; None where that was refused in words that help."""
    try:
        drawing, _ = read_drawing(path, 0.1)
        triangulate(drawing.largest, size_for(drawing.largest, 100))
    except BalloonError as error:
        assert _ADVICE.search(str(error)), f"no advice: {error}"
        assert "\n" not in str(error)
        return None
    return drawing


def test_no_file_does_more_than_complain(tmp_path: Path) -> None:
    read, slow = 0, {}
    for number in range(COUNT):
        ending, content = broken_files.file(number)
        path = tmp_path / f"case {number}.{ending}"
        path.write_bytes(content)
        began = time.process_time()
        try:
            drawing = tried(path)
        except BaseException as error:
            error.add_note(f"file number {number}, {ending}, {len(content)} bytes: {content[:300]!r}")
            raise
        path.unlink()
        if time.process_time() - began > SECONDS:
            slow[number] = time.process_time() - began
        if drawing is not None:
            read += 1
            assert all(np.isfinite(loop).all() for part in drawing.parts for loop in part.loops), number
            assert max(drawing.size) < 100.1, number
    assert not slow
    assert 0.02 * COUNT < read < 0.7 * COUNT
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024 < MEGABYTES
