# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a painted balloon straight to paper: the export panel, set to sheets that any printer takes."""

from __future__ import annotations

from BalloonWorkbench.app.document.parts import patterns
from BalloonWorkbench.gui.paint.painting.lengths import is_imperial
from BalloonWorkbench.gui.panels import is_free, show


def offer(parts) -> None:
    """Open the export panel on the pattern, in real size on A4 (or Letter): OK writes the file."""
    from BalloonWorkbench.gui.panels.making.export import ExportPanel

    if is_free():
        paper = "paper"
        panel = ExportPanel(patterns(parts.pattern.Document), parts.pattern, paper)
        panel.machine.choose(paper, "Letter" if is_imperial() else "A4")
        show(panel)
