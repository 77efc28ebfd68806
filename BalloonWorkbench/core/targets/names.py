# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of files with closed bodies of triangles."""

from __future__ import annotations

from pathlib import Path

#: Kinds of mesh files, by the ends of their names.
MESHES = ("stl", "obj", "ply", "3mf")


def is_mesh(path: str | Path) -> bool:
    """Whether a file is a mesh, by its name."""
    return Path(path).suffix.lower().lstrip(".") in MESHES
