# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removes what the workbench keeps outside its own folder; the user's own films, machines and paintings stay.

FreeCAD's Addon Manager runs it before it deletes the folder. Without it: freecadcmd uninstall.py, then
delete the folder. Plain Python removes files alone, since FreeCAD's settings need FreeCAD.
"""


class FilmBalloonRemoval:
    """One class: the Addon Manager runs this text in a function, where functions do not see each other."""

    name, toolbar = "BalloonWorkbench", "Film Balloon"
    short = (("Boolean", "Bool"), ("Integer", "Int"), ("Unsigned Long", "Unsigned"))

    def __init__(self):
        import sys

        self.remove_files()
        try:
            import FreeCAD
        except ImportError:
            sys.stdout.write(
                "FreeCAD's settings stay: run this with freecadcmd to remove ours from them too.\n"
            )
            return
        for part in ("BaseApp", "Tux"):  # Tux keeps where toolbars lie
            self.forget(FreeCAD.ParamGet("User parameter:" + part))
        FreeCAD.saveParameter()

    def forget(self, group):
        """Remove groups of our name, entries that belong to our commands, and our name as a value."""
        for child in group.GetGroups():
            if child == self.name:
                group.RemGroup(child)
            else:
                self.forget(group.GetGroup(child))
        for kind, key, value in group.GetContents() or ():
            self.forget_entry(group, kind, key, value)

    def forget_entry(self, group, kind, key, value):
        """One entry of a group."""
        listed = value.split(",") if kind == "String" else []
        if key.startswith(self.name) or key == self.toolbar or value == self.name:
            getattr(group, "Rem" + dict(self.short).get(kind, kind))(key)
        elif self.name in listed:
            group.SetString(key, ",".join(each for each in listed if each != self.name))

    def remove_files(self):
        """Folders beside FreeCAD's own."""
        import contextlib
        import os
        import shutil
        import tempfile
        from pathlib import Path

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


FilmBalloonRemoval()
