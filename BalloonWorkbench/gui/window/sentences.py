# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine says, in the user's language.

The engine speaks plain English and knows no Qt. Its sentences are listed, with {places} for what it puts
in; here they are recognised by their form, translated, and filled again.
"""

from __future__ import annotations

import FreeCADGui as Gui

from BalloonWorkbench.core.language import sentence_forms
from BalloonWorkbench.core.language.speech import listed
from BalloonWorkbench.gui.qt import translate


def translated(text: str) -> str:
    """A text of the engine in the user's language; one that is not known stays as it is."""
    return sentence_forms.translated(text, listed(), translate)


def language() -> str:
    """That of the window, as in "de"."""
    return Gui.supportedLocales().get(Gui.getLocale(), "en")
