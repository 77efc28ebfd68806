# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which kind of ours a document object is, and what it belongs to: told from proxy and links, for those who
stand below the proxies."""

from __future__ import annotations

_SOURCES = ("OutlineProxy", "GoredBodyProxy", "BagProxy", "TargetProxy")
_KINDS = (*_SOURCES, "BalloonProxy", "PatternProxy", "PanelProxy", "ArtworkProxy", "FilmSheetProxy")


def _kind(obj) -> str:
    return type(getattr(obj, "Proxy", None)).__name__


def is_ours(obj) -> bool:
    """One of ours, but no group."""
    return _kind(obj) in _KINDS


def is_outline(obj) -> bool:
    """Whether a document object is an outline."""
    return _kind(obj) == "OutlineProxy"


def is_gored_body(obj) -> bool:
    """Whether a document object is a body of gores."""
    return _kind(obj) == "GoredBodyProxy"


def is_bag(obj) -> bool:
    """Whether a document object is a bag: panels and their seams."""
    return _kind(obj) == "BagProxy"


def is_target(obj) -> bool:
    """Whether a document object is a target: a closed body in panels."""
    return _kind(obj) == "TargetProxy"


def is_source(obj) -> bool:
    """Whether a document object says what a balloon is to be: an outline, a body or a bag."""
    return _kind(obj) in _SOURCES


def is_balloon(obj) -> bool:
    """Whether a document object is a balloon."""
    return _kind(obj) == "BalloonProxy"


def is_pattern(obj) -> bool:
    """Whether a document object is a pattern."""
    return _kind(obj) == "PatternProxy"


def is_panel(obj) -> bool:
    """Whether a document object is one panel of a pattern of many."""
    return _kind(obj) == "PanelProxy"


def is_artwork(obj) -> bool:
    """Whether a document object is an artwork."""
    return _kind(obj) == "ArtworkProxy"


def is_film_sheet(obj) -> bool:
    """Whether a document object is a sheet of film."""
    return _kind(obj) == "FilmSheetProxy"


def is_study(obj) -> bool:
    """Whether a document object is a study."""
    return _kind(obj) == "StudyProxy"


def leader(source):
    """The outline that has the drawing: the object itself, or the one whose drawing it shares.

    Bodies of gores and bags share nothing.
    """
    return getattr(source, "Leader", None) or source
