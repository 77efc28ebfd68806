# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD loads is what the translators have written."""

from pathlib import Path
from xml.etree import ElementTree

import pytest

from BalloonWorkbench.app.host import qt

FOLDER = Path(__file__).resolve().parents[2] / "resources/translations"


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.ts")), ids=lambda path: path.stem)
def test_compiled_file_has_every_text(path):
    """Run `make translations` when this fails."""
    translator = qt()[0].QTranslator()
    assert translator.load(str(path.with_suffix(".qm")))
    wrong = []
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            source, told = message.findtext("source"), message.findtext("translation")
            if translator.translate(context.findtext("name"), source) != told:
                wrong.append(source)
    assert not wrong


def test_languages_are_those_of_freecad():
    """FreeCAD looks for its own names of languages at the end of the files' names."""
    assert {path.stem.split("_")[1] for path in FOLDER.glob("*.ts")} == {"de", "ja", "fr", "es-ES"}
