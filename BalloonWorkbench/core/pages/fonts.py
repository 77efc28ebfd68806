# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fonts for what people read on paper and film: DejaVu Sans, and for other letters those of the system.

A text is drawn letter by letter: what is written from right to left, and marks that stand on other letters,
cannot be shown so.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from BalloonWorkbench.core.packages import matplotlib_pdf, matplotlib_text
from BalloonWorkbench.core.types import Floats, Say, in_english

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
#: Fonts that have something else in the places of letters, or the same for all of them.
_STRANGE = re.compile(r"[a-z]+\d+|STIX(Size|NonUnicode).*|\.?Last ?Resort.*|Adobe (Not)?(De|Blank).*")
#: Letters that only tell how others are shown, beside those of the category Cf.
_IGNORED = re.compile("[\u034f\ufe00-\ufe0f\U000e0100-\U000e01ef]")
_LEFTWARD = ("R", "AL", "AN")
_UNSHOWN = "\ufffd"


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


def plain(text: str) -> str:
    """A text as one line of letters: single blanks, marks joined to their letters, no invisible signs."""
    text = unicodedata.normalize("NFC", " ".join(text.split()))
    visible = (letter for letter in text if unicodedata.category(letter) != "Cf")
    return " ".join(_IGNORED.sub("", "".join(visible)).split())


def unshown(text: str) -> list[str]:
    """Names of the letters of a plain text that cannot be drawn, each once. Needs matplotlib."""
    return [_name(letter) for letter in dict.fromkeys(text) if _family(letter) is None]


def drawable(text: str) -> str:
    """A text as one line, with a sign in place of each letter that cannot be drawn, plain and bold.

    Needs matplotlib.
    """
    letters = plain(text)
    known = {each for each in letters if None not in (_family(each), _family(each, bold=True))}
    return "".join(letter if letter in known else _UNSHOWN for letter in letters)


def outlines(text: str, size: float) -> list[Floats]:
    """Closed outlines (n, 2) of a plain text whose letters can all be drawn; fine for a large size.

    Raises MissingPackageError without matplotlib.
    """
    matplotlib_text()
    return [np.asarray(loop) for loop in _path(text, _families(text), size).to_polygons(closed_only=True)]


def fonts_for(language: str, others: str) -> Fonts:
    """Fonts for a page in the language that a text of it is written in, and for other texts on it.

    MissingPackageError without matplotlib.
    """
    matplotlib_pdf()
    japanese = _japanese() if is_wide(language) else None
    families = tuple(dict.fromkeys(([japanese] if japanese else []) + _families(others)))
    whole = all(_outlines(Path(_opened(family).fname)) != b"OTTO" for family in families)
    return Fonts(families, 42 if whole else 3)


def readable(say: Say, text: str) -> Say:
    """What says the texts of a page, one of which is given: English where no font has the letters."""
    return say if can_show(say(text)) else in_english


def can_show(text: str) -> bool:
    """There is a font for the letters of a text; for Japanese that needs matplotlib."""
    return not is_wide(text) or _japanese() is not None


def is_wide(text: str) -> bool:
    """There are Japanese letters in a text."""
    return re.search(f"[{WIDE}]", text) is not None


def _path(text: str, families: list[str], size: float) -> Any:
    """A line as a Path of matplotlib, never read as mathematics."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.path import Path as Lines

    text_to_path = matplotlib_text()
    font = FontProperties(family=families)
    points, codes = text_to_path.get_text_path(font, text, ismath=False)
    return Lines(np.reshape(points, (-1, 2)) * size / text_to_path.FONT_SCALE, codes)


def _families(text: str) -> list[str]:
    """DejaVu Sans, and what else draws the letters of a text, plain and bold."""
    families = [_family(letter, bold) for letter in text for bold in (False, True)]
    return list(dict.fromkeys([_EUROPE, *filter(None, families)]))


@cache
def _family(letter: str, bold: bool = False) -> str | None:
    """The first family that draws a letter; None for one that cannot be drawn by itself."""
    leftward = unicodedata.bidirectional(letter) in _LEFTWARD
    if leftward or unicodedata.category(letter).startswith(("M", "C")):
        return None
    return next((family for family in _tried() if _draws(family, letter, bold)), None)


def _tried() -> Iterator[str]:
    """Families in the order in which a letter is looked for: DejaVu Sans, Japanese ones, all others."""
    from matplotlib import font_manager

    yield _EUROPE
    japanese = _japanese()  # has looked for new fonts
    if japanese is not None:
        yield japanese
    files: dict[str, list[str]] = {}
    for font in font_manager.fontManager.ttflist:
        files.setdefault(font.name, []).append(font.fname)
    for family in sorted(files):
        if not _STRANGE.fullmatch(family) and all(map(_goes_into_pdf, files[family])):
            yield family


def _draws(family: str, letter: str, bold: bool) -> bool:
    """A family has a glyph for a letter, with outlines unless it is a blank."""
    if ord(letter) not in _codes(family, bold):
        return False
    font = _opened(family, bold)
    font.set_size(_TRIED, 72)
    font.load_char(ord(letter))
    return letter == " " or len(font.get_path()[0]) > 0


@cache
def _codes(family: str, bold: bool) -> frozenset[int]:
    """The letters of a family."""
    return frozenset(_opened(family, bold).get_charmap())


def _name(letter: str) -> str:
    """How a message names a letter."""
    code = f"U+{ord(letter):04X}"
    alone = letter.isprintable() and not unicodedata.category(letter).startswith("M")
    return f"{letter} ({code})" if alone else code


def _japanese() -> str | None:
    """The first family of our list that the system has."""
    try:
        from matplotlib import font_manager
    except ImportError:
        return None
    family = _listed(font_manager.fontManager)
    if family is None:  # matplotlib keeps its list: look for fonts that came later
        known = {font.fname for font in font_manager.fontManager.ttflist}
        for path in sorted(set(font_manager.findSystemFonts()) - known):
            try:
                font_manager.fontManager.addfont(path)
            except (OSError, RuntimeError, ValueError):
                continue  # no font that it can read
        family = _listed(font_manager.fontManager)
    return family


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
