# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench adds to the start of FreeCAD, measured in its window."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_PROGRAM = """\
# SPDX-License-Identifier: LGPL-2.1-or-later
import os, sys
from pathlib import Path
from PySide import QtCore

def run():
    sys.path.append("tests/gui")
    try:
        import startup
        Path({path!r}).write_text(str(startup.milliseconds()), encoding="utf-8")
    finally:
        os._exit(0)

QtCore.QTimer.singleShot(0, run)
"""


def milliseconds(folder: Path) -> float | None:
    """Processor time of Init.py and InitGui.py; None where there is no FreeCAD, or no screen to be had."""
    if not (shutil.which("freecad") and shutil.which("xvfb-run")):
        return None
    script, found = folder / "start.py", folder / "start.txt"
    script.write_text(_PROGRAM.format(path=str(found)), encoding="utf-8")
    found.unlink(missing_ok=True)
    subprocess.run(
        [str(_ROOT / "tools" / "in-window.sh"), str(folder / "freecad"), str(script)],
        cwd=_ROOT,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        env={**os.environ, "PYTHONPATH": ""},
        check=False,
    )
    return float(found.read_text(encoding="utf-8")) if found.exists() else None
