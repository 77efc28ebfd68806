# SPDX-License-Identifier: LGPL-2.1-or-later
"""A language that nobody speaks, made from all texts that are translated: what it does not reach is not
translated, and what is cut off in it would be in some language.

Each text is 40 % longer, has accents, and brackets that show whether it is whole.
"""

import re
import xml.etree.ElementTree as ET
from contextlib import contextmanager

from hands import QtCore, QtWidgets

from BalloonWorkbench.gui.qt import TRANSLATIONS

PSEUDO, MIRRORED = "Pseudo", "Mirrored"  # the second one is written from right to left
KINDS = (PSEUDO, MIRRORED)
_LONGER = 0.4
_WORD = 6  # letters of what is added
_ACCENTS = str.maketrans("aeiouyAEIOUYcnsz", "áéîöüýÁÉÎÖÜÝçñšž")
_LEFT_ALONE = re.compile(r"(\{[^{}]*\}|<[^<>]*>|&\w+;|%\w)")  # places, tags, signs


def pseudo(text):
    """A text in that language."""
    parts = _LEFT_ALONE.split(text)
    letters = sum(len(part) for part in parts[::2])
    more, words = round(_LONGER * letters), []
    while more > 0:
        words.append("öüåñéš"[: min(more, _WORD)])
        more -= _WORD + 1
    same = [part.translate(_ACCENTS) if number % 2 == 0 else part for number, part in enumerate(parts)]
    return f"[{''.join(same)} {' '.join(words)}]" if words else f"[{''.join(same)}]"


def _texts():
    """(context, source) of all that is translated: each language has the same ones."""
    for context in ET.parse(TRANSLATIONS / "BalloonWorkbench_de.ts").getroot().iter("context"):
        for message in context.iter("message"):
            yield context.findtext("name"), message.findtext("source")


class _Translator(QtCore.QTranslator):
    def __init__(self):
        super().__init__()
        self._known = {key: pseudo(key[1]) for key in _texts()}

    def isEmpty(self):  # noqa: N802 - Qt's
        """Qt takes no empty one."""
        return False

    def translate(self, context, source, _disambiguation=None, _number=-1):
        return self._known.get((context, source))


@contextmanager
def spoken(kind):
    """The window in it."""
    app, translator = QtWidgets.QApplication.instance(), _Translator()
    assert app.installTranslator(translator)
    if kind == MIRRORED:
        app.setLayoutDirection(QtCore.Qt.RightToLeft)
    try:
        yield
    finally:
        app.setLayoutDirection(QtCore.Qt.LeftToRight)
        app.removeTranslator(translator)
