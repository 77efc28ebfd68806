# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Python without certain packages: for tests of what remains."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from BalloonWorkbench.core.mesh import delaunay
from BalloonWorkbench.core.pictures import canvas
from BalloonWorkbench.core.solver import backend
from BalloonWorkbench.core.solver.native import load
from BalloonWorkbench.core.tracing import raster


@contextmanager
def without(*names: str, folder: Path) -> Iterator[None]:
    """Packages that cannot be imported; "native" is the library, looked for in an empty folder."""
    cached = (raster.opencv, load._load, backend.available, canvas._pillow)
    with pytest.MonkeyPatch.context() as patch:
        for name in names:
            for module in [name, *(known for known in sys.modules if known.startswith(f"{name}."))]:
                patch.setitem(sys.modules, module, None)
        if "native" in names:
            patch.setattr(load, "_FOLDER", folder)
        if "pythoncdt" in names:
            patch.setattr(delaunay, "pythoncdt", None)
        for function in cached:
            function.cache_clear()
        yield
    for function in cached:
        function.cache_clear()
