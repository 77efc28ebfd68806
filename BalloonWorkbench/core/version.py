# SPDX-License-Identifier: LGPL-2.1-or-later
"""Version and date of this release: package.xml is the one place for them."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

_MANIFEST = ElementTree.parse(Path(__file__).resolve().parents[2] / "package.xml")

VERSION, DATE = (str(_MANIFEST.findtext("{*}" + name)) for name in ("version", "date"))
