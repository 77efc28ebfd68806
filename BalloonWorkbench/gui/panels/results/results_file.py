# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saving what the simulation found: asks for a file, says what became of it."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app.engine.export import export_results
from BalloonWorkbench.app.properties import preferences
from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.gui.panels.widgets.target_file import name_of
from BalloonWorkbench.gui.qt import QtWidgets, translate
from BalloonWorkbench.gui.window import macro_recorder
from BalloonWorkbench.gui.window.sentences import tell

_KINDS = (("ParaView", "vtu"), ("STL", "stl"), ("NumPy", "npz"))


def save_results(balloon) -> str:
    """Ask for a file, write the results of a balloon object; a sentence about it, empty when cancelled."""
    folder = preferences.export_folder(balloon.Document)
    kinds = [f"{program} (*.{ending})" for program, ending in _KINDS]
    path, kind = QtWidgets.QFileDialog.getSaveFileName(
        None,
        translate("Save results"),
        str(folder / f"{name_of(balloon)}.{_KINDS[0][1]}"),
        ";;".join(kinds),
    )
    if not path:
        return ""
    if Path(path).suffix.lower().lstrip(".") not in [ending for _, ending in _KINDS]:
        path += "." + _KINDS[max(kinds.index(kind) if kind in kinds else 0, 0)][1]
        if Path(path).exists():  # the dialog has asked about another name
            return translate("{} is there already: give another name.").format(Path(path).name)
    try:
        written = export_results(balloon, path)
    except BalloonError as error:
        return tell(str(error))
    preferences.put_export_folder(balloon.Document, written.parent)
    macro_recorder.call("export", macro_recorder.obj(balloon), macro_recorder.text(written))
    return translate("Results written to {}").format(written)
