# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench costs nothing while FreeCAD starts."""

import subprocess


def test_start_imports_no_numerics():
    code = (
        "import sys; from BalloonWorkbench.app.balloon import BalloonProxy; "
        "print('loaded:', sorted({'numpy', 'scipy', 'cv2', 'shapely', 'ezdxf'} & set(sys.modules)))"
    )
    ended = subprocess.run(
        ["freecadcmd", "-c", code],
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
        timeout=60,
    )
    assert "loaded: []" in ended.stdout
