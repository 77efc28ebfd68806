# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Python without ctypes, as in some packed FreeCADs: everything loads, and one sentence says what is lost.

SciPy itself needs ctypes: where it does not load either, nothing is inflated. Where it does, NumPy solves.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from absent import without

from BalloonWorkbench.core import packages
from BalloonWorkbench.core.files import system

ROOT = Path(__file__).parents[4]
#: Ways in which ctypes fails that NumPy survives: no module, no libffi.
FAILURES = {
    "no module": "sys.modules['_ctypes'] = None",
    "no libffi": "refuse(ImportError('libffi.so.7: cannot open shared object file'))",
}
_REFUSE = """
import sys
class _Refusing:
    def __init__(self, error):
        self.error = error
    def find_spec(self, name, path=None, target=None):
        if name == "_ctypes":
            raise self.error
def refuse(error):
    sys.modules.pop("_ctypes", None), sys.modules.pop("ctypes", None)
    sys.meta_path.insert(0, _Refusing(error))
"""
_EVERY_MODULE = """
import importlib, pkgutil
import BalloonWorkbench.core
for module in pkgutil.walk_packages(BalloonWorkbench.core.__path__, "BalloonWorkbench.core."):
    if not module.name.endswith(".c_interface"):  # the one that is ctypes
        importlib.import_module(module.name)
"""
_RUN = "from BalloonWorkbench.cli import command_line as cli\nsys.exit(cli.main(sys.argv[1:]))\n"


def run(program: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", _REFUSE + program, *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def box(folder: Path) -> str:
    path = folder / "box.json"
    path.write_text(json.dumps({"unit": "mm", "outer": [[0, 0], [99, 0], [99, 99], [0, 99]]}))
    return str(path)


@pytest.mark.parametrize("failure", FAILURES)
def test_every_module_loads_and_one_sentence_is_said(failure: str) -> None:
    tell = "from BalloonWorkbench.core import packages\nprint(*packages.missing(), sep='\\n')\n"
    ended = run(FAILURES[failure] + _EVERY_MODULE + tell)
    assert (ended.returncode, ended.stderr, ended.stdout) == (0, "", packages.NO_CTYPES + "\n")


def test_numpy_solves_where_scipy_had_it(tmp_path: Path) -> None:
    ended = run(
        "import scipy.sparse.linalg, scipy.spatial, scipy.ndimage\n"
        "sys.modules['ctypes'] = sys.modules['FreeCAD'] = None\n" + _RUN,
        *("inflate", box(tmp_path), "--mesh-size", "30mm", "--out", str(tmp_path / "out")),
    )
    assert ended.returncode == 0, ended.stderr
    assert "solver numpy" in ended.stdout
    assert ended.stdout.count(packages.NO_CTYPES) == 1
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names >= {"pattern.dxf", "pattern.svg", "balloon.stl", "preview.png", "report.json"}


def test_where_nothing_can_be_inflated_the_reason_is_said(tmp_path: Path) -> None:
    ended = run(
        FAILURES["no module"] + "\n" + _RUN,
        *("inflate", box(tmp_path), "--mesh-size", "30mm", "--out", str(tmp_path / "out")),
    )
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr == f"balloon: {packages.NO_CTYPES}\n"
    assert not (tmp_path / "out").exists()


def test_no_solver_is_asked_for_in_vain(tmp_path: Path) -> None:
    ask = (
        "from BalloonWorkbench.core.solver import backend\n"
        "from BalloonWorkbench.core.errors import BalloonError\n"
        "try:\n    backend.active_backend()\nexcept BalloonError as error:\n    print(error)\n"
    )
    ended = run(FAILURES["no module"] + "\n" + ask)
    assert ended.stdout == f"No solver works here: {packages.NO_CTYPES}\n"
    assert ended.stderr == ""


def test_folders_are_still_exchanged_by_renaming(tmp_path: Path) -> None:
    """Files are written all or none without the call that exchanges two folders in one step."""
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / name).touch()
    with without("ctypes", folder=tmp_path):
        assert not system.exchange(tmp_path / "one", tmp_path / "other")
    assert (tmp_path / "one" / "one").is_file()
