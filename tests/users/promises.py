# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences of the tutorial, one by one."""

import re
from pathlib import Path

TUTORIAL = Path(__file__).resolve().parents[2] / "docs" / "tutorial.md"


def sentences():
    """Those of the text below its headings, without its pictures and marks."""
    paragraphs = re.split(r"\n\s*\n|\n(?=- )", TUTORIAL.read_text(encoding="utf-8"))
    told = []
    for paragraph in paragraphs:
        text = " ".join(paragraph.split()).removeprefix("- ")
        if text.startswith(("#", "![")):
            continue
        text = re.sub(r"\[([^]]+)\]\([^)]*\)", r"\1", text).replace("**", "").replace("`", "")
        told += re.split(r"(?<=[.!?])\s+(?=[A-Z\[])", text)
    return told


#: About paper, foil and tools: no program can hold them.
BEYOND = (
    "You need a FreeCAD with this workbench (make freecad opens one) and a printer.",
    "A foil, an iron and a straw come later.",
    "Print it at 100 %, measure the bar of 100 mm, glue the sheets together at their marks.",
    "Lay the pattern on two layers of foil, cut both along the red line, seal along the magenta one with an "
    "iron between two sheets of baking paper.",
    "The neck stays open: blow it up with a straw, then seal the neck, too.",
)
