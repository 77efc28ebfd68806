# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fonts for what people read on paper: those of Europe, and for Japanese one that the system has."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.types import Say, in_english

_EUROPE = "DejaVu Sans"  # matplotlib has it
#: Families with Japanese letters, those that a PDF can be searched in first.
_JAPANESE = (
    *("IPAexGothic", "IPAPGothic", "TakaoPGothic", "VL PGothic", "Meiryo", "BIZ UDPGothic", "Yu Gothic"),
    *("Noto Sans CJK JP", "Noto Sans JP", "Hiragino Sans", "Hiragino Kaku Gothic ProN", "Source Han Sans JP"),
    *("IPAGothic", "TakaoGothic", "VL Gothic", "MS PGothic", "MS Gothic", "Droid Sans Fallback"),
)
#: Letters as wide as they are high: kana, Chinese characters and their punctuation.
WIDE = "\u2e80-\u9fff\uf900-\ufaff\uff00-\uff60"
_POINT = 25.4 / 72.0  # mm
_TRIED = 1000  # size at which letters are measured


@dataclass(frozen=True)
class Fonts:
    """Families in the order in which a letter is looked for, and how matplotlib puts them into a PDF."""

    families: tuple[str, ...]
    kind: int
    _widths: dict[tuple[str, bool], float] = field(default_factory=dict)

    def width(self, text: str, size: float, bold: bool = False) -> float:
        """Width of a text [mm] at a size in points."""
        return sum(self._width(letter, bold) for letter in text) * size * _POINT

    def _width(self, letter: str, bold: bool) -> float:
        """Width of a letter in parts of the size."""
        if (letter, bold) not in self._widths:
            fonts = [_opened(family, bold) for family in self.families]
            font = next((font for font in fonts if font.get_char_index(ord(letter))), fonts[0])
            font.set_size(_TRIED, 72)
            advance = font.load_char(ord(letter)).linearHoriAdvance  # of the letter without hinting
            self._widths[letter, bold] = advance / 65536.0 / _TRIED
        return self._widths[letter, bold]


def fonts_for(language: str, others: str) -> Fonts:
    """Fonts for a page in the language that a text of it is written in, and for other texts on it.

    Needs matplotlib.
    """
    japanese = _japanese() if is_wide(language) or is_wide(others) else None
    if japanese is None:
        return Fonts((_EUROPE,), 42)
    families = (japanese, _EUROPE) if is_wide(language) else (_EUROPE, japanese)
    return Fonts(families, 42 if _outlines(Path(_opened(japanese).fname)) != b"OTTO" else 3)


def drawn(text: str, bold: bool = False) -> Any:
    """A line with Japanese letters as a Path of matplotlib, one unit high, where `can_show` says yes."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath
    from matplotlib.transforms import Affine2D

    font = FontProperties(family=[_japanese(), _EUROPE], weight="bold" if bold else "normal")
    path = TextPath((0.0, 0.0), text, size=_TRIED, prop=font)
    return path.transformed(Affine2D().scale(1.0 / _TRIED))


def readable(say: Say, text: str) -> Say:
    """What says the texts of a page, one of which is given: English where no font has the letters."""
    return say if can_show(say(text)) else in_english


def can_show(text: str) -> bool:
    """There is a font for the letters of a text; for Japanese that needs matplotlib."""
    return not is_wide(text) or _japanese() is not None


def is_wide(text: str) -> bool:
    """There are Japanese letters in a text."""
    return re.search(f"[{WIDE}]", text) is not None


def _japanese() -> str | None:
    """The first family of our list that the system has."""
    try:
        from matplotlib import font_manager
    except ImportError:
        return None
    found = _listed(font_manager.fontManager)
    if found is None:  # matplotlib keeps its list: look for fonts that came later
        known = {font.fname for font in font_manager.fontManager.ttflist}
        for path in sorted(set(font_manager.findSystemFonts()) - known):
            try:
                font_manager.fontManager.addfont(path)
            except (OSError, RuntimeError, ValueError):
                continue  # no font that it can read
        found = _listed(font_manager.fontManager)
    return found


def _listed(manager: Any) -> str | None:
    known: dict[str, list[str]] = {}
    for font in manager.ttflist:
        known.setdefault(font.name, []).append(font.fname)
    return next((name for name in _JAPANESE if any(map(_goes_into_pdf, known.get(name, [])))), None)


def _goes_into_pdf(name: str) -> bool:
    """A single font with PostScript's outlines does not; as Type 3 those of a collection do."""
    path = Path(name)
    return path.is_file() and (path.suffix.lower() == ".ttc" or _outlines(path) != b"OTTO")


def _outlines(path: Path) -> bytes:
    """The mark of a font file, or of the first font in a collection: OTTO for outlines of PostScript."""
    with path.open("rb") as stream:
        mark = stream.read(4)
        if mark == b"ttcf":
            stream.seek(12)
            stream.seek(int.from_bytes(stream.read(4), "big"))
            mark = stream.read(4)
    return mark


def _opened(family: str, bold: bool = False) -> Any:
    from matplotlib.font_manager import FontProperties, findfont, get_font

    return get_font(findfont(FontProperties(family=family, weight="bold" if bold else "normal")))
