# SPDX-License-Identifier: LGPL-2.1-or-later
"""The web page of one job: its balloons in 3D, their numbers, the pattern, advice; needs no network."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from BalloonWorkbench.core.types import Say, in_english
from BalloonWorkbench.core.web_pages.page import VIEWER, Content, Markup, data_uri, element, web_page
from BalloonWorkbench.core.web_pages.table import values_table

_SVG = "<svg "


@dataclass(frozen=True)
class NamedTable:
    """Names and values under a title, as the reader knows them."""

    title: str
    rows: Sequence[tuple[str, str]]


@dataclass(frozen=True)
class BalloonPage:
    """What the page is about; its texts are in the reader's language.

    subtitle  a line about its size
    glb       the balloons in 3D; picture: a PNG of them, for browsers without scripts and for paper
    tables    by balloon
    pattern   an SVG file of all that is cut; lines: their colours (#rrggbb) and what they are
    advice    how grave it is, and a sentence, each; notes: sentences
    ground    media type and file of an image that covers what is behind the balloon; None is the page's own
    """

    title: str
    subtitle: str
    glb: bytes
    picture: bytes
    tables: Sequence[Sequence[NamedTable]]
    pattern: bytes
    lines: Sequence[tuple[str, str]]
    advice: Sequence[tuple[str, str]]
    notes: Sequence[str]
    ground: tuple[str, bytes] | None = None


def balloon_page(subject: BalloonPage, language: str = "en", say: Say = in_english) -> bytes:
    """The page's content; the same bytes for the same. language: of the texts, as in "de"."""
    cards = [
        _card(say("Balloon"), _view(subject, say), wide=True),
        *(
            _card(
                _numbered(say("Numbers"), k, len(subject.tables)), [values_table(*_of(each)) for each in own]
            )
            for k, own in enumerate(subject.tables, 1)
        ),
    ]
    if subject.advice:
        cards.append(_card(say("Advice"), _list(f"{kind}: {text}" for kind, text in subject.advice)))
    if subject.notes:
        cards.append(_card(say("Notes"), _list(subject.notes)))
    cards.append(_card(say("Pattern"), _pattern(subject, say), wide=True))
    head = element("header", element("h1", subject.title), element("p", subject.subtitle, class_="soft"))
    return web_page(subject.title, language, [head, element("main", *cards, class_="cards")], [VIEWER])


def _of(table: NamedTable) -> tuple[str, Sequence[tuple[str, str]]]:
    return table.title, table.rows


def _card(title: str, content: Content, *, wide: bool = False) -> Markup:
    return element("section", element("h2", title), content, class_="card wide" if wide else "card")


def _numbered(title: str, number: int, count: int) -> str:
    return title if count == 1 else f"{title} {number}"


def _list(texts: Iterable[str]) -> Markup:
    return element("ul", *(element("li", text) for text in texts))


def _view(subject: BalloonPage, say: Say) -> Markup:
    """The picture, in whose place the script shows the balloon in 3D; the file itself to take away."""
    alt = say(f"{subject.title}, inflated: {subject.subtitle}")
    image = element("img", id="balloon-image", src=data_uri("image/png", subject.picture), alt=alt)
    shown = [image]
    if subject.ground is not None:
        address = data_uri(*subject.ground)
        shown.insert(0, element("img", id="balloon-ground", src=address, alt=""))
    keys = say("Drag to turn, turn the wheel to zoom; keys: arrows, plus, minus, Home.")
    download = element(
        "a",
        say("Balloon as a GLB file, for 3D programs"),
        id="balloon-file",
        download="balloon.glb",
        href=data_uri("model/gltf-binary", subject.glb),
    )
    # without scripts nothing turns
    caption = element("figcaption", element("span", f"{keys} ", id="balloon-keys", hidden=""), download)
    return element("figure", element("div", shown, class_="stage"), caption, id="balloon")


def _pattern(subject: BalloonPage, say: Say) -> Markup:
    """The drawing of the pattern, and what its lines are."""
    text = subject.pattern.decode("utf-8")
    label = element("title", say("Pattern of the balloon, all pieces"))
    start = text.index(_SVG)  # what stands before is for XML
    head, _, rest = text[start:].partition(">")
    drawing = Markup(f'{head} role="img">{label}{rest}')
    lines = [element("li", _sample(colour), name) for colour, name in subject.lines]
    return Markup(element("div", drawing, class_="pattern") + element("ul", *lines, class_="legend"))


def _sample(colour: str) -> Markup:
    line = element("line", x1=0, y1=3, x2=18, y2=3, stroke=colour, stroke_width=2)
    return element("svg", line, viewBox="0 0 18 6", aria_hidden="true")
