# SPDX-License-Identifier: LGPL-2.1-or-later
"""A home folder for the packages that want one: containers have none, services one that is not theirs."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from BalloonWorkbench.core.machines import machine


@contextmanager
def home() -> Iterator[None]:
    """Set one up for the time of a run where the user has none that can be written to.

    FreeCAD, ezdxf and matplotlib look into it for settings, and end or fail where they may not.
    """
    if _is_of_use():
        yield
        return
    before = dict(os.environ)
    try:
        folder = tempfile.mkdtemp(prefix="film-balloon-home-")
    except OSError:  # no place for one either
        yield
        return
    try:
        os.environ.setdefault(
            "BALLOON_FAULT_FOLDER", f"{tempfile.gettempdir()}/film-balloon-faults-{os.getuid()}"
        )
        if (own := _own_machines()) is not None:
            os.environ["BALLOON_MACHINES"] = own  # a home may be there to read
        os.environ["HOME"] = folder
        yield
    finally:
        os.environ.clear()
        os.environ.update(before)
        shutil.rmtree(folder, ignore_errors=True)


def _is_of_use() -> bool:
    if os.name != "posix":
        return True
    try:
        place = Path.home()
        return place.is_dir() and os.access(place, os.R_OK | os.W_OK | os.X_OK)
    except (RuntimeError, OSError):  # RuntimeError: nobody knows it
        return False


def _own_machines() -> str | None:
    try:
        return str(machine.own_folder())
    except RuntimeError:
        return None
