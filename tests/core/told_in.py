# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine's texts in another language, as FreeCAD's window says them, from the files of translations."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

from BalloonWorkbench.gui import forms

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "translations"
LANGUAGES = ("de", "ja", "fr", "es-ES")


@cache
def says(language: str) -> Callable[[str], str]:
    """A function that says a text in a language."""
    done = {}
    for message in ElementTree.parse(FOLDER / f"BalloonWorkbench_{language}.ts").iter("message"):
        done[message.findtext("source", "")] = message.findtext("translation", "")
    listed = forms.known(json.loads((FOLDER / "sentences.json").read_text(encoding="utf-8")))
    return lambda text: forms.told(text, listed, done.__getitem__)
