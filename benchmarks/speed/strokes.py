# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a stroke in the paint window to the balloon on the screen, measured in FreeCAD's window."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from datetime import date
from pathlib import Path
from typing import Any

from speed import machine

_ROOT = Path(__file__).resolve().parents[2]
_SCRIPT = Path(__file__).parent / "paint_strokes.py"


def measure(folder: Path) -> dict[str, Any] | None:
    """What came of each stroke of `paint_strokes.py`; None without FreeCAD or a screen to be had.

    Also written to folder/strokes.json. Of FreeCAD 1.x:
    tools/in-root.sh ROOT tools/in-window.sh build/bench/freecad benchmarks/speed/paint_strokes.py
    """
    if not (shutil.which("freecad") and shutil.which("xvfb-run")):
        return None
    found = folder / "strokes.json"
    found.unlink(missing_ok=True)
    load = machine.load()
    ended = subprocess.run(
        [str(_ROOT / "tools" / "in-window.sh"), str(folder / "freecad"), str(_SCRIPT)],
        cwd=_ROOT,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": "", "SUITE": ""},
        check=False,
    )
    if not found.exists():
        raise RuntimeError(f"The strokes were not measured:\n{ended.stdout}\n{ended.stderr}")
    rows = json.loads(found.read_text(encoding="utf-8"))
    measured = {"date": date.today().isoformat(), "load": load, "rows": rows}
    found.write_text(json.dumps(measured, indent=1), encoding="utf-8")
    return measured
