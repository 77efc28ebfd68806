# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python code of a page of the guide: tests run it, and pictures are taken of what it makes."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
IMAGES = DOCS / "images"
EXAMPLES = ROOT / "resources" / "examples"
#: Enough to see that code runs: few triangles, a balloon that is not corrected, a pattern of short lines.
_COARSE = 'mesh_size="{} mm", mode="Inflate as drawn", arcs=False'
_BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_MESH = re.compile(r'mesh_size="(\d+) mm"')


def blocks(page: str) -> list[str]:
    """The blocks of Python of a page such as api.md, in their order."""
    return _BLOCK.findall((DOCS / page).read_text(encoding="utf-8"))


def coarse(code: str) -> str:
    """The same code, with balloons that take a moment."""
    return _MESH.sub(lambda size: _COARSE.format(2 * int(size[1])), code)


def run(code: str, name: str, known: dict) -> None:
    """Run code with the names that code before has left, and add its own."""
    exec(compile(code, name, "exec"), known)
