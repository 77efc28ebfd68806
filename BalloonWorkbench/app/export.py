# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writing a pattern object as a file for the cutter."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app import status
from BalloonWorkbench.core.errors import ExportError

FORMATS = ("dxf", "svg")


def export_pattern(pattern_obj, target) -> Path:
    """Write the pattern to a file, in the format of its ending, or into a folder as DXF; returns the file.

    Raises ExportError for another ending, a pattern that is not up to date, a place that cannot be written.
    """
    from BalloonWorkbench.app.pattern import build
    from BalloonWorkbench.core.export.dxf import dxf_bytes
    from BalloonWorkbench.core.export.files import write_files
    from BalloonWorkbench.core.export.svg import svg_bytes

    path = Path(target)
    if path.is_dir():
        path = path / "pattern.dxf"
    kind = path.suffix.lower().lstrip(".")
    if kind not in FORMATS:
        raise ExportError(f"{path.name} is neither DXF nor SVG: let the name end in .dxf or .svg.")
    if not status.is_ready(pattern_obj):
        raise ExportError(
            f"{pattern_obj.Label} is not up to date. {status.problem(pattern_obj)} "
            "Repair that, recompute and export again."
        )
    pattern = build(pattern_obj)
    write_files(path.parent, {path.name: dxf_bytes(pattern) if kind == "dxf" else svg_bytes(pattern)})
    return path
