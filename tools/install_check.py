# SPDX-License-Identifier: LGPL-2.1-or-later
"""Install what was released as a new user does, use it in FreeCAD's window, remove it, and look what is left.

    install_check.py LIBRARIES FOLDER [SUITE...]

LIBRARIES are those of native_libraries.py; FOLDER is made anew. Suites: here (FreeCAD 0.20), trixie (1.0),
forky (1.1), the last two in the roots of freecad-root.sh; as root. Each of WAYS starts in an empty home.
"""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from native_libraries import ROOT
from release import addon_files, files, version_and_date
from release_branch import publish

sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "core")]

from wheel_server import server, wheel_list  # noqa: E402 - the tests are no package

NAME = "BalloonWorkbench"
_PATIENCE = 300  # s for one FreeCAD


class Way(NamedTuple):
    """What is installed and how; is there a network; what the user answers; the solver that is used then."""

    source: str
    manager: bool
    network: bool
    answer: str
    solver: str


WAYS = {
    "the zip, no network": Way("zip", False, False, "", "native"),
    "the release branch, no network": Way("branch", False, False, "", "native"),
    "the release branch by the Addon Manager": Way("branch", True, True, "", "native"),
    "a plain clone, solver refused": Way("clone", False, False, "No, use NumPy", "numpy"),
    "a plain clone, no network to fetch from": Way("clone", False, False, "Fetch", "numpy"),
    "a plain clone, solver fetched": Way("clone", False, True, "Fetch", "native"),
}
#: What FreeCAD itself keeps of a window, of the user's document, and of the workbench that was used last.
_OF_FREECAD = ("/MainWindow", "/RecentFiles", "/Preferences/General/FileOpenSavePath", "/General/LastModule")


#: What Qt and the graphics driver keep of compiled shaders.
_OF_DRIVERS = ("mesa_shader_cache", "qtshadercache-x86_64-little_endian-lp64")
_TIME = re.compile(r"\d{8}-\d{6}|\d{10}")  # in the names of the copies that FreeCAD keeps

#: Files, and entries of the settings.
Left = tuple[set[str], set[str]]


class FreeCAD:
    """A FreeCAD and a home for it."""

    def __init__(self, suite: str, home: Path) -> None:
        self.home = home
        self._root = None if suite == "here" else _output("tools/freecad-root.sh", suite)
        (home.parent / "run").mkdir(parents=True, mode=0o700)
        home.mkdir()
        told = self._run(["freecadcmd", "-c", "import FreeCAD; print('at', FreeCAD.getUserAppDataDir())"])
        self.mod = Path(told.rpartition("at ")[2].splitlines()[0]) / "Mod"

    def window(self, task: dict[str, object], network: bool = False) -> dict[str, str]:
        """What tests/gui/installed.py sees."""
        screen = ["xvfb-run", "--auto-servernum", f"--server-num={100 + os.getpid() % 30000}"]
        screen += ["--server-args=-screen 0 1366x768x24 -noreset", "freecad"]
        return self._task(screen, "installed.py", task, network)

    def manager(self, do: str, source: Path) -> None:
        """Have the Addon Manager install or remove the workbench."""
        task: dict[str, object] = {"do": do, "from": str(source), "branch": "release"}
        if not self._task(["freecadcmd"], "by_addon_manager.py", task, True)["done"]:
            raise SystemExit(f"the Addon Manager did not {do} it")

    def uninstall(self) -> None:
        """Run uninstall.py, and delete the folder."""
        self._run(["freecadcmd", str(self.mod / NAME / "uninstall.py")])
        shutil.rmtree(self.mod / NAME)

    def left(self) -> Left:
        """Files in the home, and entries of FreeCAD's settings."""
        names = {
            _TIME.sub("TIME", path.relative_to(self.home).as_posix())
            for path in self.home.rglob("*")
            if not path.is_dir() and not any(part in _OF_DRIVERS for part in path.parts)
        }
        entries: set[str] = set()
        for path in self.home.rglob("user.cfg"):
            entries |= set(_entries(ElementTree.parse(path).getroot(), ""))
        return names, entries

    def _task(
        self, command: list[str], script: str, task: dict[str, object], network: bool
    ) -> dict[str, str]:
        place = self.home.parent / "task.json"
        place.write_text(json.dumps(task), encoding="utf-8")
        answer = place.with_name("seen.json")
        answer.unlink(missing_ok=True)
        told = self._run([*command, str(ROOT / "tests" / "gui" / script)], network)
        if not answer.is_file():
            raise SystemExit(f"FreeCAD ended before its time:\n{told[-3000:]}")
        seen: dict[str, str] = json.loads(answer.read_text(encoding="utf-8"))
        if "failed" in seen:
            raise SystemExit(seen["failed"])
        return seen

    def _run(self, command: list[str], network: bool = False) -> str:
        site = _output(".venv/bin/python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))")
        if self._root is not None:
            (found,) = Path(self._root, "opt/venv/lib").glob("python3.*/site-packages")
            site = f"/{found.relative_to(self._root)}"
        variables = {
            "PATH": "/usr/bin:/bin:/usr/sbin:/sbin",
            "LANG": "C.UTF-8",
            "HOME": str(self.home),
            "XDG_RUNTIME_DIR": str(self.home.parent / "run"),
            "QT_QPA_PLATFORM": "xcb" if "xvfb-run" in command else "offscreen",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "QTWEBENGINE_DISABLE_SANDBOX": "1",
            "BALLOON_TASK": str(self.home.parent / "task.json"),
            "BALLOON_SITE": site,
        }
        inside = ["env", "-i", *(f"{name}={value}" for name, value in variables.items()), *command]
        if self._root is not None:
            inside = ["tools/in-root.sh", self._root, *inside]
        if not network:
            inside = ["unshare", "--net", *inside]
        ended = subprocess.run(
            inside,
            cwd=ROOT,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=_PATIENCE,
            check=False,
        )
        told = ended.stdout.decode(errors="replace")
        with (self.home.parent / "log").open("a") as log:
            log.write(f"== {command}\n{told}\n")
        return told


def _entries(group: ElementTree.Element, path: str) -> Iterator[str]:
    for each in group:
        name = f"{path}/{each.get('Name', '')}"
        if any(part in name for part in _OF_FREECAD):
            continue
        if each.tag == "FCParamGroup":
            yield name
            yield from _entries(each, name)
        else:
            yield f"{name} = {each.get('Value', each.text)}"


def _output(*command: str) -> str:
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()


def sources(libraries: Path, folder: Path) -> dict[str, Path]:
    """What can be installed: the released zip, a repository with the release branch, a plain clone."""
    for name, content in files(libraries).items():
        (folder / name).write_bytes(content)
    repository = folder / "repository"
    _output("git", "init", "--quiet", "--bare", str(repository))
    publish(addon_files(libraries), repository)
    archive = folder / "release.zip"  # what the Addon Manager's server makes of a branch
    _output("git", "-C", str(repository), "archive", "--format=zip", "-o", str(archive), "release")
    plain = io.BytesIO(subprocess.run(["git", "archive", "--format=zip", "HEAD"], cwd=ROOT, check=True,
                                      stdout=subprocess.PIPE).stdout)  # fmt: skip
    clone = folder / "clone"
    zipfile.ZipFile(plain).extractall(clone)
    (zipped,) = folder.glob("film-balloon-*.zip")
    return {"zip": zipped, "branch": repository, "archive": archive, "clone": clone}


def install(freecad: FreeCAD, way: Way, known: dict[str, Path]) -> None:
    """Bring the workbench into FreeCAD's Mod folder."""
    freecad.mod.mkdir(parents=True, exist_ok=True)
    place = freecad.mod / NAME
    if way.manager:
        freecad.manager("install", known["archive"])
    elif way.source == "zip":
        zipfile.ZipFile(known["zip"]).extractall(freecad.mod)
    elif way.source == "branch":
        address = f"file://{known['branch']}"
        _output("git", "clone", "--quiet", "--depth=1", "--branch", "release", address, str(place))
    else:
        shutil.copytree(known["clone"], place)


def check(suite: str, way: Way, known: dict[str, Path], folder: Path, usual: Left) -> None:
    """One way from an empty home to one that is as it was. SystemExit where it does not lead there."""
    freecad = FreeCAD(suite, folder / "home")
    document, other = freecad.home / "First.FCStd", freecad.home / "Other.FCStd"
    without: dict[str, object] = {"activate": False, "save": str(other)}
    freecad.window(without)
    install(freecad, way, known)
    with ExitStack() as stack:
        if way.answer:
            version, _ = version_and_date()
            (name,) = known["zip"].parent.glob(f"film_balloon_native-{version}-*manylinux*x86_64.whl")
            wheel = name.read_bytes()
            address = stack.enter_context(server(wheel))
            wheel_list(freecad.mod / NAME / "resources" / "native-wheels.json", address, wheel)
        task = {"activate": True, "answer": way.answer, "save": str(document)}
        seen = freecad.window(task, way.network)
    expected = {"active": NAME, "solver": way.solver, "asks": False}
    wrong = {key: seen.get(key) for key, value in expected.items() if seen.get(key) != value}
    if wrong:
        raise SystemExit(f"not as expected: {wrong}")
    if way.manager:
        freecad.manager("remove", known["archive"])
    else:
        freecad.uninstall()
    assert not freecad.window(without)["known"]
    names, entries = freecad.left()
    installed = freecad.mod / "manifest.json"  # the Addon Manager's own list of what is installed
    if installed.is_file() and NAME not in installed.read_text(encoding="utf-8"):
        names.remove(installed.relative_to(freecad.home).as_posix())
    more = sorted(names - usual[0] - {document.name}) + sorted(entries - usual[1])
    if more or not document.is_file():
        raise SystemExit("left behind:\n  " + "\n  ".join(more))


def main(arguments: list[str]) -> int:
    """Try all ways; 1 when one fails."""
    libraries, folder, suites = Path(arguments[0]), Path(arguments[1]).resolve(), arguments[2:]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    known, failed = sources(libraries, folder), 0
    for suite in suites or ("here", "trixie", "forky"):
        without = FreeCAD(suite, folder / suite / "without" / "home")
        for _ in range(3):
            without.window({"activate": False, "save": str(without.home / "Other.FCStd")})
        usual = without.left()
        for number, (title, way) in enumerate(WAYS.items()):
            if way.manager and suite == "here":
                continue  # its Addon Manager has no installer that can be called
            try:
                check(suite, way, known, folder / suite / str(number), usual)
            except SystemExit as error:
                print(f"FAILED {suite:7} {title}: {error}")
                failed = 1
            else:
                print(f"ok     {suite:7} {title}")
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
