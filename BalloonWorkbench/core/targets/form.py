# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a file is made into many panels, and as what: told without reading all of it."""

from __future__ import annotations

import json
from pathlib import Path

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.options.body import BandOptions, BodyOptions
from BalloonWorkbench.core.readers.vector import read_bytes, vector_kind

#: Kinds of mesh files, by the ends of their names.
MESHES = ("stl", "obj", "ply", "3mf")
#: What a JSON file of panels, or of a profile, has instead of the loops of an outline.
PANELS = "panels"
#: A file with a closed body: triangles, or a solid, which FreeCAD reads.
MESH, SOLID = "mesh", "solid"
#: Kinds of files with solids, by the ends of their names.
SOLIDS = ("step", "stp", "brep", "brp", "iges", "igs")
_MOST_BYTES = 8 << 20
_KEYS = (PANELS, "profile", "natural_shape")


def is_mesh(path: str | Path) -> bool:
    """Whether a file is a mesh, by its name."""
    return Path(path).suffix.lower().lstrip(".") in MESHES


def has_many_panels(path: str | Path, body: BodyOptions, band: BandOptions) -> bool:
    """Whether a file and what is asked for make more than two equal panels; the file may not be there."""
    return body != BodyOptions() or band != BandOptions() or form_of(path) is not None


def form_of(path: str | Path) -> str | None:
    """PANELS or another of the words by which a JSON file of many panels is known; MESH; None for any other
    file.

    One that cannot be read is left to the readers of what it speaks of, which say why.
    """
    path = Path(path)
    if is_mesh(path):
        return MESH
    if path.suffix.lower().lstrip(".") in SOLIDS:
        return SOLID
    named: list[str] = []
    try:
        with path.open("rb") as file:
            if vector_kind(path, file.read(4096)) != "json":
                return None
        data = read_bytes(path)
        named = [key for key in _KEYS if f'"{key}"'.encode() in data]
        if not named or len(data) > _MOST_BYTES:  # most outlines are not unpacked twice
            return named[0] if named else None
        text = json.loads(data)
    except (OSError, InputError):
        return None
    except (ValueError, RecursionError):
        return named[0] if named else None
    return next((key for key in _KEYS if isinstance(text, dict) and key in text), None)
