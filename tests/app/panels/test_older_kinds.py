# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of releases without many panels open in silence, as balloons of two panels."""

import shutil
from pathlib import Path

import FreeCAD as App
import pytest

from BalloonWorkbench.app.border import hooks, status

KEPT = sorted(Path("tests/resources/documents").resolve().glob("*.FCStd"))


@pytest.mark.parametrize("path", KEPT, ids=lambda path: path.stem)
def test_an_older_document_opens_in_silence(path, tmp_path, monkeypatch):
    errors = []
    monkeypatch.setattr(hooks, "show_error", errors.append)
    document = App.openDocument(shutil.copy(path, tmp_path))
    try:
        assert not errors
        balloons = [obj for obj in document.Objects if "SolvedFor" in obj.PropertiesList]
        assert balloons
        assert {obj.PanelCount for obj in balloons} == {0}
        assert {obj.Band.Value for obj in balloons} == {0.0}
        for obj in balloons:
            obj.touch()
        document.recompute()
        assert [obj.Status for obj in balloons] == [status.READY] * len(balloons)
        assert not errors
    finally:
        App.closeDocument(document.Name)
