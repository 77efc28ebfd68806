# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.xml as FreeCAD and its Addon Manager read it."""

import importlib
import os
import sys
from pathlib import Path

import FreeCAD as App
import pytest

import BalloonWorkbench

MANAGER = Path(App.getResourceDir()) / "Mod" / "AddonManager"


@pytest.fixture(scope="module")
def manifest():
    return App.Metadata(os.path.abspath("package.xml"))


def test_freecad_reads_it(manifest):
    assert manifest.Name == "Film Balloon"
    assert manifest.Version == BalloonWorkbench.__version__
    assert manifest.FreeCADMin == "0.20.0"
    assert manifest.FreeCADMax in ("", "0.0.0")
    assert {item["name"]: item["file"] for item in manifest.License} == {
        "LGPL-2.1-or-later": "LICENSE",
        "CC-BY-SA-4.0": "LICENSE-ARTWORK",
    }
    assert manifest.Maintainer[0]["name"]
    addresses = {item["type"]: item for item in manifest.Urls}
    assert addresses["repository"]["branch"] == "release"
    assert addresses["readme"]["location"].startswith(addresses["repository"]["location"])


def test_this_freecad_is_supported(manifest):
    assert manifest.supportsCurrentFreeCAD()


def test_workbench_is_described(manifest):
    (workbench,) = manifest.Content["workbench"]
    assert workbench.Classname == "BalloonWorkbench"
    assert workbench.Subdirectory == "./"
    assert 3 <= len(workbench.Tag) <= 7
    assert Path(workbench.Icon).suffix == ".svg"
    assert Path(workbench.Icon).is_file()


@pytest.fixture
def manager(monkeypatch):
    """The Addon Manager's own modules."""
    monkeypatch.syspath_prepend(str(MANAGER))
    before = set(sys.modules)
    yield importlib.import_module("Addon")
    for name in set(sys.modules) - before:
        del sys.modules[name]


def dependencies(manager):
    """What the Addon Manager takes for required modules of FreeCAD, required and optional packages."""
    addon = manager.Addon("Film Balloon", "", manager.Addon.Status.NOT_INSTALLED, "")
    addon.load_metadata_file(os.path.abspath("package.xml"))
    return addon.requires, addon.python_requires, addon.python_optional


def test_addon_manager_knows_every_dependency(manager):
    internal, required, optional = dependencies(manager)
    packages = {"numpy", "scipy", "ezdxf", "shapely"}
    if not required:  # FreeCAD 0.20 does not tell packages from modules
        internal, required, optional = (
            internal - packages - {"matplotlib"},
            internal & packages,
            {"matplotlib"},
        )
    assert internal == {"part", "mesh", "sketcher"}
    assert required == packages
    assert optional == {"matplotlib"}


def test_addon_manager_installs_every_package(manager):
    """Its list of what it installs, as of this FreeCAD's release; newer ones have it online only."""
    listed = MANAGER / "ALLOWED_PYTHON_PACKAGES.txt"
    if not listed.is_file():
        assert tuple(map(int, App.Version()[:2])) >= (1, 0)
        return
    allowed = {line.strip().lower() for line in listed.read_text(encoding="utf-8").splitlines()}
    text = Path("package.xml").read_text(encoding="utf-8")
    wanted = {
        part.partition("<")[0] for part in text.replace(' optional="true"', "").split('type="python">')[1:]
    }
    assert wanted == {"numpy", "scipy", "ezdxf", "shapely", "matplotlib"}
    assert wanted - allowed <= {"shapely"}  # came onto the list later
