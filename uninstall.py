# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removes what the workbench keeps outside its own folder; the user's own films, machines and paintings stay.

FreeCAD's Addon Manager runs it before it deletes the folder. Without it: freecadcmd uninstall.py, then
delete the folder. Plain Python removes files alone, since FreeCAD's settings need FreeCAD.
"""


def remove_film_balloon():
    """The Addon Manager runs this text inside a function: all that is needed has to be in here."""
    import contextlib
    import os
    import shutil
    import sys
    import tempfile
    from pathlib import Path

    name, toolbar = "BalloonWorkbench", "Film Balloon"
    short = {"Boolean": "Bool", "Integer": "Int", "Unsigned Long": "Unsigned"}

    def forget(group):
        """Remove groups of our name, entries that belong to our commands, and our name as a value."""
        for child in group.GetGroups():
            if child == name:
                group.RemGroup(child)
            else:
                forget(group.GetGroup(child))
        for kind, key, value in group.GetContents() or ():
            listed = value.split(",") if kind == "String" else []
            if key.startswith(name) or key == toolbar or value == name:
                getattr(group, "Rem" + short.get(kind, kind))(key)
            elif name in listed:
                group.SetString(key, ",".join(each for each in listed if each != name))

    def remove_files():
        home = Path(os.path.expanduser("~"))
        local = os.environ.get("LOCALAPPDATA")
        for folder in (
            home / ".film-balloon" / "native",
            Path(os.environ.get("BALLOON_FAULT_FOLDER") or home / ".film-balloon" / "faults"),
            *Path(tempfile.gettempdir()).glob("film-balloon-faults*"),
            (Path(local) if local else home / "AppData" / "Local") / "FilmBalloon",
        ):
            shutil.rmtree(folder, ignore_errors=True)
        with contextlib.suppress(OSError):  # the user's own machines are in it
            (home / ".film-balloon").rmdir()

    remove_files()
    try:
        import FreeCAD
    except ImportError:
        sys.stdout.write("FreeCAD's settings stay: run this with freecadcmd to remove ours from them too.\n")
        return
    for part in ("BaseApp", "Tux"):  # Tux keeps where toolbars lie
        forget(FreeCAD.ParamGet("User parameter:" + part))
    FreeCAD.saveParameter()


remove_film_balloon()
