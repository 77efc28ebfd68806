# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's Python finds the workbench and the packages it uses."""

import importlib
import os

import FreeCAD
import pytest


@pytest.mark.parametrize(
    "name", ["numpy", "scipy.sparse.linalg", "cv2", "ezdxf", "shapely", "pythoncdt", "matplotlib"]
)
def test_package_is_importable(name: str) -> None:
    assert importlib.import_module(name).__name__ == name


@pytest.mark.parametrize("name", ["Part", "Mesh", "Sketcher"])
def test_freecad_module_is_importable(name: str) -> None:
    assert importlib.import_module(name).__name__ == name


def test_workbench_is_installed_as_an_addon() -> None:
    addon = os.path.join(FreeCAD.getUserAppDataDir(), "Mod", "BalloonWorkbench")
    assert os.path.realpath(addon) == os.path.realpath(os.getcwd())
    assert importlib.import_module("BalloonWorkbench.core").__file__
