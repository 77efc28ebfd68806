# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD and end the process with pytest's exit code.

Give this file to freecadcmd (runs tests/app) or freecad (runs tests/gui), from the root of the repository.
The environment variable BALLOON_TESTS replaces these folders by other arguments of pytest.

FreeCAD imports a script, runs it again after an exception and still exits with 0; leaving through the
event loop loses the exit code. So the process ends here, with os._exit after a flush.
"""

import os
import shlex
import sys
import traceback

import FreeCAD


def run() -> None:
    """Run the tests and end the process."""
    # FreeCAD's own streams have no file number; without line buffering a crash would swallow the last lines
    sys.stdout = os.fdopen(os.dup(1), "w", buffering=1)
    sys.stderr = os.fdopen(os.dup(2), "w", buffering=1)
    # the versions of .venv, not those that Debian may have beside them
    sys.path.insert(0, os.path.join(FreeCAD.getUserAppDataDir(), "AdditionalPythonPackages"))
    folder = "tests/gui" if FreeCAD.GuiUp else "tests/app"
    code = 99
    try:
        import pytest

        measure = None
        if os.environ.get("BALLOON_COVERAGE"):
            import coverage

            # our folder is reached through a link
            own = [f"*/BalloonWorkbench/{layer}/*" for layer in ("app", "core")]
            measure = coverage.Coverage(data_suffix=True, source=[], include=own)
            measure.start()
            for name in [name for name in sys.modules if name.partition(".")[0] == "BalloonWorkbench"]:
                del sys.modules[name]  # FreeCAD has loaded them unmeasured
            import BalloonWorkbench.app.balloon
            import BalloonWorkbench.app.group
            import BalloonWorkbench.app.outline
            import BalloonWorkbench.app.pattern  # noqa: F401
        # tee-sys: what FreeCAD and its Python print while a test runs also reaches the log
        code = int(pytest.main(["--capture=tee-sys", *shlex.split(os.environ.get("BALLOON_TESTS", folder))]))
        if measure is not None:
            measure.stop()
            measure.save()
    finally:
        if code == 99:
            traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(0, run)  # once the window stands and the event loop runs
else:
    run()
