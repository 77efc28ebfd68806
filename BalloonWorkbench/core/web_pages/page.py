# SPDX-License-Identifier: LGPL-2.1-or-later
"""A web page of one file: its elements, in which any text is only text, and the whole of it.

The page tells browsers that nothing of it comes from elsewhere, and that only our own scripts run
(Content-Security-Policy with their SHA-256): also a text that was not escaped could do nothing.
"""

from __future__ import annotations

import base64
import hashlib
import html
import re
from collections.abc import Iterable, Sequence

from BalloonWorkbench.core.files.data_file import RESOURCES

#: Scripts and style, classic ones: modules are not loaded from files.
_FOLDER = RESOURCES / "web"
VIEWER, TABLE, _STYLE = "viewer.js", "table.js", "page.css"
_LINE_END, _UNSHOWN = re.compile(r"\r\n?"), re.compile(r"[^\t\n -\ud7ff\ue000-\U0010ffff]")
#: Elements that have no content and no end.
_VOID = {"img", "meta", "br"}


class Markup(str):
    """Text that is HTML already; any other text is escaped where it becomes part of a page."""

    __slots__ = ()


Content = str | Markup | Iterable["Content"]


def markup(content: Content) -> Markup:
    """The content as HTML: a text is escaped, Markup stays, several follow each other."""
    if isinstance(content, Markup):
        return content
    if isinstance(content, str):
        return Markup(html.escape(_readable(content)))
    return Markup("".join(map(markup, content)))


def element(tag: str, *content: Content, **attributes: str | int | float | None) -> Markup:
    """An element with its attributes; those that are None are left out, `class_` is class, a_b is a-b."""
    named = "".join(
        f' {name.rstrip("_").replace("_", "-")}="{markup(str(value))}"'
        for name, value in attributes.items()
        if value is not None
    )
    end = "" if tag in _VOID else f"</{tag}>"
    return Markup(f"<{tag}{named}>{markup(content)}{end}")


def data_uri(kind: str, content: bytes) -> str:
    """The address of content that is in the page itself; kind: its media type, such as image/png."""
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def web_page(title: str, language: str, body: Sequence[Markup], scripts: Sequence[str] = ()) -> bytes:
    """The whole page, with these of our scripts; language: of its texts, as in "de"."""
    style = (_FOLDER / _STYLE).read_text(encoding="utf-8")
    programs = [(_FOLDER / name).read_text(encoding="utf-8") for name in scripts]
    allowed = " ".join(map(_hash, programs)) or "'none'"
    policy = f"default-src 'none'; img-src data:; style-src {_hash(style)}; script-src {allowed}"
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", http_equiv="Content-Security-Policy", content=policy),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("title", title),
        element("style", Markup(style)),
    )
    whole = element("body", *body, *(element("script", Markup(program)) for program in programs))
    page = element("html", head, "\n", whole, lang=language)
    return f"<!DOCTYPE html>\n{page}\n".encode()


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def _readable(text: str) -> str:
    """A sign for letters that are none, as in names of other systems' files, and those no page may have."""
    return _UNSHOWN.sub("\ufffd", _LINE_END.sub("\n", text))
