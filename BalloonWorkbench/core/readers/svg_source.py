# SPDX-License-Identifier: LGPL-2.1-or-later
"""An SVG document before it is read: without what shows no lines, and weighed with its copies and styles."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from xml.etree import ElementTree
from xml.parsers import expat

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.budget import MOST_ELEMENTS, Budget

_SVG = "{http://www.w3.org/2000/svg}"
_XLINK = "{http://www.w3.org/1999/xlink}href"
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
# What shows no lines, whatever is in it.
_SHOWS_NOTHING = {
    *("text", "tspan", "textPath", "title", "desc", "metadata", "script", "image", "filter"),
    *("linearGradient", "radialGradient"),
}
_LINES = {"d", "points"}
_SHAPES = {"path", "polyline", "polygon"}
# Characters of attributes and styles, each counted for all elements that inherit it; the reader looks at all
# of them again at each element.
_MOST_TEXT = 20_000_000
_MOST_ATTRIBUTES = 1_000_000
_LONGEST_ATTRIBUTE = 10_000
_LONGEST_NUMBER = re.compile(r"[0-9]{400}")
_NUMBER = re.compile(r"\d*\.?\d+(?:[eE][-+]?\d+)?")
_COMMAND = re.compile("[A-Za-z]")
_COMMENT = re.compile(r"//.*$", re.MULTILINE)
_AT_ONCE = 1 << 16


def harmless(data: bytes, budget: Budget) -> ElementTree.Element:
    """The document's root, once it is sure that reading it needs neither other files nor endless memory.

    Only what can show lines is in it. InputError where it is no SVG or is too much.
    """
    _look_through(data, budget)
    try:
        root = ElementTree.fromstring(data)
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise InputError(f"The SVG file is damaged ({error}). Save it once more.") from None
    if root.tag.rpartition("}")[2] != "svg":
        raise InputError("The file is XML but no SVG drawing. Choose a drawing.")
    styles: dict[str, int] = {}
    cleaned = _cleaned(root, styles)
    weight = _SvgWeights(cleaned, styles, budget).of(cleaned, 0)
    budget.spend_elements(weight.elements)
    budget.allow_points(weight.points)
    if not weight.text <= _MOST_TEXT:
        raise InputError(
            "The drawing has too much text in its styles and transforms. Save it as plain SVG once more."
        )
    return cleaned


def _look_through(data: bytes, budget: Budget) -> None:
    """InputError for entities, and before too many or too deep elements are made into objects."""
    level = count = 0

    def refuse(*_: object) -> None:
        raise InputError("The SVG file defines entities, which are not read. Save it as plain SVG.")

    def begin(*_: object) -> None:
        nonlocal level, count
        level, count = level + 1, count + 1
        budget.check_level(level)
        if count > MOST_ELEMENTS:
            budget.spend_elements(count)

    def end(_: str) -> None:
        nonlocal level
        level -= 1

    if data.count(b"=") > _MOST_ATTRIBUTES:
        raise InputError("The SVG file has too many attributes. Save it as plain SVG once more.")
    parser = expat.ParserCreate()
    parser.EntityDeclHandler = refuse
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    try:
        for start in range(0, len(data), _AT_ONCE):
            parser.Parse(data[start : start + _AT_ONCE])
        parser.Parse(b"", True)
    except (expat.ExpatError, ValueError, LookupError) as error:
        raise InputError(f"The SVG file is damaged ({error}). Save it once more.") from None


def _cleaned(element: ElementTree.Element, styles: dict[str, int]) -> ElementTree.Element:
    """The element with what can show lines, blanks drawn together.

    styles  length of the styles of each selector, which is added to
    """
    name = element.tag.removeprefix(_SVG)
    copy = ElementTree.Element(element.tag)
    for key, value in element.attrib.items():
        if key in _LINES and name not in _SHAPES:
            continue
        if key[:1] != "{" or key in (_XLINK, _LABEL):
            copy.set(key, _plain(key, value))
    if name == "style":
        copy.text = _rules(element.text or "", styles)
    else:
        visible = [child for child in element if child.tag.removeprefix(_SVG) not in _SHOWS_NOTHING]
        copy.extend([_cleaned(child, styles) for child in visible])
    return copy


def _plain(key: str, value: str) -> str:
    """An attribute with single blanks; InputError where it has what takes endless time to read."""
    value = " ".join(value.split())
    if (len(value) > _LONGEST_ATTRIBUTE and key not in _LINES) or _LONGEST_NUMBER.search(value):
        raise InputError(f"The SVG file has a '{key}' of endless length. Save it as plain SVG once more.")
    return value


def _rules(text: str, styles: dict[str, int]) -> str:
    """The rules of a style sheet, without comments."""
    pieces = text.split("/*")
    text = "".join([pieces[0], *(piece.partition("*/")[2] for piece in pieces[1:])])
    text = " ".join(_COMMENT.sub("", text).split())
    rules, at = [], 0
    while (begin := text.find("{", at)) >= 0 and (end := text.find("}", begin)) >= 0:
        selectors, rule = text[at:begin].strip(), text[begin + 1 : end].strip()
        at = end + 1
        if selectors and rule:
            rules.append(f"{selectors}{{{rule}}}")
            for selector in selectors.split(","):
                styles[selector.strip()] = styles.get(selector.strip(), 0) + len(rule)
    if sum(styles.values()) > _MOST_TEXT:
        raise InputError("The SVG file has too many styles. Save it as plain SVG once more.")
    return "".join(rules)


@dataclass(frozen=True)
class _Weight:
    """Elements, points and characters of text, as often as they are read."""

    elements: float = 0.0
    points: float = 0.0
    text: float = 0.0

    def __add__(self, other: _Weight) -> _Weight:
        return _Weight(self.elements + other.elements, self.points + other.points, self.text + other.text)


class _SvgWeights:
    """What elements weigh once every <use> is replaced by what it shows; endless where one shows itself."""

    def __init__(self, root: ElementTree.Element, styles: dict[str, int], budget: Budget) -> None:
        self._named = {element.get("id"): element for element in root.iter() if element.get("id")}
        self._styles, self._budget = styles, budget
        self._known: dict[ElementTree.Element, _Weight] = {}
        self._open: set[ElementTree.Element] = set()

    def of(self, element: ElementTree.Element, level: int) -> _Weight:
        """Of an element with all in it, so many levels deep."""
        self._budget.check_level(level)
        if element in self._open:
            return _Weight(math.inf)
        if element not in self._known:
            self._budget.check_time()
            self._open.add(element)
            weight = _Weight(1.0, _written_points(element))
            for child in element:
                weight += self.of(child, level + 1)
            link = element.get("href") or element.get(_XLINK) or ""
            if element.tag.removeprefix(_SVG) == "use" and link[1:] in self._named:
                weight += self.of(self._named[link[1:]], level + 1)
            self._open.discard(element)
            own = min(weight.elements, MOST_ELEMENTS + 1) * self._text(element)
            self._known[element] = weight + _Weight(text=own)
        return self._known[element]

    def _text(self, element: ElementTree.Element) -> float:
        """Characters of an element that it and all in it have to look at."""
        tag = element.tag.removeprefix(_SVG)
        own = sum(len(value) + 10 for key, value in element.attrib.items() if key not in _LINES)
        names = ["*", tag, f"#{element.get('id')}"]
        for name in (element.get("class") or "").split():
            names += [f".{name}", f"{tag}.{name}"]
        return own + sum(self._styles.get(name, 0) for name in names)


def _written_points(element: ElementTree.Element) -> float:
    """About as many points as the lines of an element are written with, or more."""
    text = element.get("d") or element.get("points") or ""
    if len(text) < 100:
        return 0.0
    return max(sum(1 for _ in _NUMBER.finditer(text)) / 2, sum(1 for _ in _COMMAND.finditer(text)))
