# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removing the workbench: all that it keeps outside its folder goes, and nothing of the user's."""

import runpy
import subprocess
import sys
from pathlib import Path

import FreeCAD as App
import pytest

SCRIPT = Path("uninstall.py").resolve()
BASE, TUX = "User parameter:BaseApp", "User parameter:Tux"
OURS = "BalloonWorkbench"
PLACES = ("Preferences/Shortcut", "Preferences/Workbenches")


@pytest.fixture
def home(monkeypatch, tmp_path):
    """A home with files of ours and of the user's."""
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("LOCALAPPDATA", raising=False)
    monkeypatch.delenv("BALLOON_FAULT_FOLDER", raising=False)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    for name in (
        ".film-balloon/native/0.1.0/linux-x86_64/libfilm_solver.so",
        ".film-balloon/faults/fault-1.txt",
        ".film-balloon/machines/mine.json",
        "temporary/film-balloon-faults/fault-2.txt",
        "AppData/Local/FilmBalloon/native/0123/film_solver.dll",
        "AppData/Local/Other/file",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    return tmp_path


@pytest.fixture
def settings():
    """All kinds of settings, ours and others', with these names; gone afterwards."""
    group = App.ParamGet(f"{BASE}/Preferences/General")
    before = group.GetString("AutoloadModule")
    yield
    group.SetString("AutoloadModule", before)
    for path in (
        "Preferences/Mod/Other",
        "Workbench/Other",
        "Preferences/Shortcut",
        "Preferences/Workbenches",
    ):
        parent, _, name = path.rpartition("/")
        App.ParamGet(f"{BASE}/{parent}").RemGroup(name)


def files(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def as_the_addon_manager_does():
    def run_uninstall_script(path):
        with open(path, encoding="ascii") as file:
            exec(file.read())

    run_uninstall_script(SCRIPT)


WAYS = {"script": lambda: runpy.run_path(str(SCRIPT)), "Addon Manager": as_the_addon_manager_does}


@pytest.mark.parametrize("way", WAYS)
def test_files_of_ours_go(way, home, settings):
    WAYS[way]()
    assert files(home) == {".film-balloon/machines/mine.json", "AppData/Local/Other/file"}


def test_an_empty_folder_goes_too(home, settings):
    (home / ".film-balloon/machines/mine.json").unlink()
    (home / ".film-balloon/machines").rmdir()
    WAYS["script"]()
    assert not (home / ".film-balloon").exists()


@pytest.mark.parametrize("way", WAYS)
def test_settings_of_ours_go_and_those_of_others_stay(way, home, settings):
    for name in (OURS, "Other"):
        group = App.ParamGet(f"{BASE}/Preferences/Mod/{name}")
        group.SetBool("Flag", True)
        group.SetInt("Number", 3)
        group.SetUnsigned("Colour", 4)
        group.SetFloat("Length", 1.5)
        group.SetString("Text", "x")
    for name in (OURS, "Other"):
        group = App.ParamGet(f"{BASE}/Workbench/{name}/Toolbar/Custom_1")
        group.SetString("BalloonWorkbench_Paint", "Film Balloon")
        group.SetString("Std_Open", "FreeCAD")
    App.ParamGet(f"{TUX}/PersistentToolbars/User/{OURS}").SetString("Top", "File,Film Balloon")
    del group  # FreeCAD keeps a group that somebody holds, but empty
    shortcuts = App.ParamGet(f"{BASE}/Preferences/Shortcut")
    shortcuts.SetString("BalloonWorkbench_Paint", "Ctrl+B")
    shortcuts.SetString("Std_Open", "Ctrl+O")
    workbenches = App.ParamGet(f"{BASE}/Preferences/Workbenches")
    workbenches.SetString("Ordered", "PartWorkbench,BalloonWorkbench,MeshWorkbench")
    App.ParamGet(f"{BASE}/Preferences/General").SetString("AutoloadModule", OURS)
    App.ParamGet(f"{BASE}/MainWindow/Toolbars").SetBool("Film Balloon", False)

    WAYS[way]()

    assert _everything(App.ParamGet(BASE)) == []
    assert _everything(App.ParamGet(TUX)) == []
    assert workbenches.GetString("Ordered") == "PartWorkbench,MeshWorkbench"
    assert shortcuts.GetStrings() == ["Std_Open"]
    kept = App.ParamGet(f"{BASE}/Preferences/Mod/Other")
    assert len(kept.GetContents()) == 5
    assert App.ParamGet(f"{BASE}/Workbench/Other/Toolbar/Custom_1").GetStrings() == ["Std_Open"]


def _everything(group, path=""):
    """Places in the settings that still speak of us."""
    places = [f"{path}/{name}" for name in group.GetGroups() if OURS in name]
    for _, key, value in group.GetContents() or ():
        if OURS in key or "Film Balloon" in key or OURS in str(value):
            places.append(f"{path}/{key}={value}")
    for name in group.GetGroups():
        places += _everything(group.GetGroup(name), f"{path}/{name}")
    return places


def test_plain_python_removes_the_files_and_says_what_stays(home):
    ended = subprocess.run(
        [sys.executable if "python" in sys.executable else "python3", "-I", str(SCRIPT)],
        env={"HOME": str(home), "PATH": "/usr/bin:/bin", "TMPDIR": str(home / "temporary")},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert "run this with freecadcmd" in ended.stdout
    assert files(home) == {".film-balloon/machines/mine.json", "AppData/Local/Other/file"}
