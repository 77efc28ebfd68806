# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules of the house: which layer may use which, and what every source file looks like."""

import ast
import datetime
import os
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import pytest

import BalloonWorkbench

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "BalloonWorkbench"

#: Modules of FreeCAD that need no window, those that do, and Qt under its names.
FREECAD = {
    "FreeCAD",
    "App",
    "Part",
    "Mesh",
    "MeshPart",
    "Sketcher",
    "Draft",
    "Import",
    "importDXF",
    "freecad",
}
WINDOW = {"FreeCADGui", "Gui", "PartGui", "MeshGui", "SketcherGui", "pivy"}
QT = {"PySide", "PySide2", "PySide6", "PyQt5", "PyQt6", "shiboken2", "shiboken6"}

#: The rooms of the core in the order of the data; a room uses only those before it.
ROOMS = ["geometry", "files", "options", "pages", "language", "arcs", "outline", "tracing", "readers"]
ROOMS += ["outline_edits", "film", "panels", "mesh", "bags", "bodies", "targets", "segmentation"]
ROOMS += ["seam_edits", "flattening", "solver", "design", "correction", "bag_design", "target_design"]
ROOMS += ["results", "pattern", "arrangement", "bag_pattern", "nesting", "making", "tolerances"]
ROOMS += ["machines", "pictures", "artwork", "scenes", "assembly_sheet", "advice", "reports", "web_pages"]
ROOMS += ["as_made", "studies"]

OPTIONAL = ["cv2", "scipy", "ezdxf", "shapely", "pythoncdt", "matplotlib", "PIL"]
OPTIONAL += ["spyrrow", "distributed", "dask", "dask_jobqueue", "dask_kubernetes", "pyarrow"]


def sources(*suffixes: str) -> list[Path]:
    """Our own files: not what was built, installed or written."""
    return [path for path in _own_files() if path.suffix in suffixes]


@cache
def _own_files() -> list[Path]:
    skipped = {".venv", ".git", "build", "out", "lib", "__pycache__"}
    found = []
    for folder, folders, names in os.walk(ROOT):
        folders[:] = sorted(set(folders) - skipped)
        found += [Path(folder, name) for name in sorted(names)]
    return found


@cache
def tree(path: Path) -> ast.Module:
    """What a file says, read once for all tests: not to be changed."""
    return ast.parse(path.read_text(encoding="utf-8"))


def layer(*parts: str) -> list[Path]:
    return sorted(PACKAGE.joinpath(*parts).rglob("*.py"))


def named(path: Path) -> str:
    return str(path.relative_to(ROOT))


@cache
def imports(path: Path) -> list[str]:
    """Every module that a file imports, wherever in the file, with the names taken from it."""
    modules = []
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Import):
            modules += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{named(path)}:{node.lineno} imports relatively: write the full name"
            modules += [f"{node.module}.{alias.name}" for alias in node.names]
    return modules


def taken_from(path: Path, *forbidden: str) -> list[str]:
    """Imports of a file that are, or lie in, a forbidden module."""
    return [
        f"{named(path)}: {module}"
        for module in imports(path)
        if any(module == name or module.startswith(f"{name}.") for name in forbidden)
    ]


def broken(paths: list[Path], *forbidden: str) -> list[str]:
    assert paths
    return [line for path in paths for line in taken_from(path, *forbidden)]


def test_core_knows_neither_freecad_nor_qt() -> None:
    outside = (*FREECAD, *WINDOW, *QT, "BalloonWorkbench.app", "BalloonWorkbench.gui", "BalloonWorkbench.cli")
    assert not broken(layer("core"), *outside)


def test_app_knows_no_window() -> None:
    assert not broken(layer("app"), *WINDOW, "BalloonWorkbench.gui", "BalloonWorkbench.cli")


def test_app_knows_no_widgets() -> None:
    """Pictures may be read with Qt; only app/host.py looks for the widgets, on behalf of the window."""
    host = PACKAGE / "app" / "host.py"
    widgets = [f"{qt}.{module}" for qt in QT for module in ("QtWidgets", "QtSvg", "QtUiTools")]
    assert not broken([path for path in layer("app") if path != host], *widgets)


def test_gui_goes_through_the_host_for_qt() -> None:
    """What differs between Qt 5 and 6 is handled in one place."""
    assert not broken(layer("gui"), "PySide2", "PySide6", "PyQt5", "PyQt6")


#: What is not called, and what is instead.
REPLACED = {
    "makeCompound": (
        "Part.Compound([...]): in plain Python with FreeCAD 1.1 the other one ends the program",
        (),
    ),
    "fitAll": (
        "gui/view3d/fit_view.py: FreeCAD's own does not know of panels over its view",
        ("gui/view3d/fit_view.py",),
    ),
    "ViewFit": ("gui/view3d/fit_view.py: FreeCAD's own does not know of panels over its view", ()),
}


@pytest.mark.parametrize("name", REPLACED)
def test_what_has_a_better_way_is_not_called(name: str) -> None:
    instead, but = REPLACED[name]
    callers = [path for path in layer() if re.search(rf"\b{name}\b", path.read_text(encoding="utf-8"))]
    assert not [named(path) for path in callers if not named(path).endswith(tuple(but) or "\n")], instead


@pytest.mark.parametrize("room", ROOMS)
def test_rooms_of_the_core_follow_the_data(room: str) -> None:
    later = ROOMS[ROOMS.index(room) + 1 :]
    outside = (*later, "job", "bag_job")
    assert not broken(layer("core", room), *(f"BalloonWorkbench.core.{name}" for name in outside))


def test_core_imports_with_numpy_alone() -> None:
    """Optional packages and FreeCAD are hidden; every module of the core must still import."""
    program = f"""
import importlib, pkgutil, sys
hidden = {sorted({*OPTIONAL, *FREECAD, *WINDOW, *QT})!r}
class Hide:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in hidden:
            raise ModuleNotFoundError(f"{{name}} is hidden", name=name)
sys.meta_path.insert(0, Hide())
import BalloonWorkbench.core
for module in pkgutil.walk_packages(BalloonWorkbench.core.__path__, "BalloonWorkbench.core."):
    importlib.import_module(module.name)
"""
    ended = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stderr


def _imported() -> dict[str, set[str]]:
    """Our modules, each with those of ours that it imports: at its top, inside functions, for type hints."""
    modules = {".".join(path.relative_to(ROOT).with_suffix("").parts): path for path in layer()}
    modules = {name.removesuffix(".__init__"): path for name, path in modules.items()}
    edges = {}
    for name, path in modules.items():
        taken = {each if each in modules else each.rpartition(".")[0] for each in imports(path)}
        edges[name] = taken & set(modules) - {name}
    return edges


def _circles(edges: dict[str, set[str]]) -> list[list[str]]:
    """What is left when modules are taken away that use none of the others, or that none of them uses."""
    left = dict(edges)
    while True:
        used = {name for each in left.values() for name in each}
        kept = {name: each & set(left) for name, each in left.items() if each & set(left) and name in used}
        if kept == left:
            return [[name, *sorted(each)] for name, each in sorted(left.items())]
        left = kept


def test_circles_are_seen() -> None:
    assert not _circles({"a": {"b"}, "b": {"c"}, "c": set()})
    assert [name for name, *_ in _circles({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"c"}})] == ["b", "c"]


def test_no_import_runs_in_a_circle() -> None:
    """Also inside functions: a module can be read and changed after those that it uses."""
    assert not _circles(_imported())


def test_files_name_their_licence() -> None:
    silent = [
        named(path)
        for path in sources(".py", ".cpp", ".c", ".h", ".hpp", ".sh", ".toml", ".yaml", ".yml")
        if "SPDX-License-Identifier: LGPL-2.1-or-later"
        not in "".join(path.read_text(encoding="utf-8").splitlines()[:3])
    ]
    assert not silent


def test_a_file_is_one_idea() -> None:
    paths = sources(".py", ".cpp", ".h", ".hpp", ".sh")
    long = [named(path) for path in paths if len(path.read_text(encoding="utf-8").splitlines()) > 400]
    assert not long, "split them: a file holds one idea"


def test_functions_can_be_read_at_once() -> None:
    """At most 60 lines; the linter holds complexity (10) and parameters (8)."""
    functions = [
        (path, node)
        for path in sources(".py")
        for node in ast.walk(tree(path))
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
    ]
    long = [
        f"{named(path)}:{node.lineno} {node.name}"
        for path, node in functions
        if (node.end_lineno or node.lineno) - node.lineno >= 60
    ]
    assert not long, "split them"


def _private(path: Path) -> Iterator[str]:
    """Names with an underscore that a file takes out of modules of the core."""
    modules = set()
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("BalloonWorkbench.core"):
            modules |= {alias.asname or alias.name for alias in node.names}
            yield from (alias.name for alias in node.names if alias.name.startswith("_"))
    for node in ast.walk(tree(path)):
        taken = node.value if isinstance(node, ast.Attribute) else None
        if isinstance(taken, ast.Name) and taken.id in modules and re.match(r"_[^_]", node.attr):
            yield f"{taken.id}.{node.attr}"


def test_benchmarks_take_nothing_private() -> None:
    """What they exchange or look at, anybody can."""
    private = [
        f"{named(path)}: {name}"
        for path in sorted((ROOT / "benchmarks").rglob("*.py"))
        for name in _private(path)
    ]
    assert not private


#: Files of a room, `__init__` with them.
MOST_FILES = 13


def test_rooms_are_small() -> None:
    counts = {named(folder): len([*folder.glob("*.py")]) for folder in rooms()}
    assert not {name for name, count in counts.items() if count > MOST_FILES}


def test_a_room_says_what_lives_in_it() -> None:
    """Its first sentence says what does, and mostly what does not."""
    silent = []
    for folder in rooms():
        text = ast.get_docstring(tree(folder / "__init__.py")) or ""
        if len(text.partition(".")[0].split()) < 3:
            silent.append(named(folder))
    assert not silent


def rooms() -> list[Path]:
    return sorted({path.parent for path in layer()})


def test_every_module_is_used() -> None:
    """A file that nobody imports any more goes; names that are looked up while running stand in texts."""
    ours = [path for path in sources(".py") if "tests" not in path.relative_to(ROOT).parts]
    taken = {module for path in ours for module in imports(path)}
    taken |= {module.rpartition(".")[0] for module in taken}
    texts = "".join(path.read_text(encoding="utf-8") for path in ours)
    idle = []
    for path in layer():
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        by_name = f'.{module.partition(".")[2]}"' in texts  # as in f"{_PACKAGE}.gui.paint.window"
        if path.name not in ("__init__.py", "__main__.py") and module not in taken and not by_name:
            idle.append(named(path))
    assert not idle


def test_no_class_name_twice() -> None:
    names = Counter(
        node.name for path in layer() for node in ast.walk(tree(path)) if isinstance(node, ast.ClassDef)
    )
    assert not {name for name, count in names.items() if count > 1}


#: Where an unforeseen error ends, by file: each is told in a sentence, and its details are kept in a file.
BORDERS = {
    "BalloonWorkbench/core/faults.py": "the report itself",
    "BalloonWorkbench/core/nesting/nest.py": "the thread of the search",
    "BalloonWorkbench/core/files/foreign_reader.py": "readers of other projects",
    "BalloonWorkbench/cli/command_line.py": "the command line",
    "BalloonWorkbench/cli/freecad_process.py": "FreeCAD's process beside it",
    "BalloonWorkbench/cli/studies/worker.py": "a row of a study",
    "BalloonWorkbench/app/api/call.py": "the Python API",
    "BalloonWorkbench/app/border/guard.py": "what FreeCAD calls in our objects, views and observers",
    "BalloonWorkbench/app/border/status.py": "a recompute",
    "BalloonWorkbench/gui/window/borders.py": "commands, panels, and what Qt calls",
    "BalloonWorkbench/gui/long_work/worker.py": "a worker thread",
    "BalloonWorkbench/gui/paint/preview/preload.py": "what is loaded ahead",
    "BalloonWorkbench/gui/paint/window.py": "Make it!",
}
_BROAD = re.compile(r"\b((Base)?Exception|UNFORESEEN)\b")


def _broad(path: Path) -> Iterator[str]:
    """Where a file catches whatever comes, unless it only tidies up and raises again."""
    for node in ast.walk(tree(path)):
        caught = []
        if isinstance(node, ast.ExceptHandler) and ast.unparse(node.body[-1]) != "raise":
            caught = [ast.unparse(node.type) if node.type else "Exception"]
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith("suppress"):
            caught = [ast.unparse(given) for given in node.args]
        if any(_BROAD.search(kind) for kind in caught):
            yield f"{named(path)}:{node.lineno}"


def test_no_failure_is_swallowed() -> None:
    """Whatever comes is caught at the borders alone."""
    assert not [place for path in sources(".py") if named(path) not in BORDERS for place in _broad(path)]


def test_every_border_is_one() -> None:
    """A file that catches no longer whatever comes leaves the list."""
    assert not [name for name in BORDERS if not [*_broad(ROOT / name)]]


def test_one_source_of_version_and_date() -> None:
    """package.xml has them; nothing else has a number of its own."""
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    version, date = manifest.findtext("{*}version"), manifest.findtext("{*}date")
    assert (BalloonWorkbench.__version__, BalloonWorkbench.__date__) == (version, date)
    assert datetime.date.fromisoformat(str(date)) >= datetime.date(2026, 11, 21)
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert not re.search(r"^version\b", project, re.MULTILINE)
    assert 'attr = "BalloonWorkbench.__version__"' in project
    newest = re.search(
        r"^## (\S+) - (.+)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert newest
    assert newest[1] == version
    assert newest[2] in ("not released", date)
    texts = [path.read_text(encoding="utf-8") for path in sources(".py", ".toml", ".sh", ".h", ".cpp")]
    assert not [text for text in texts if f'version = "{version}"' in text]


def test_manifest_names_what_is_there() -> None:
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    files = [element.get("file") for element in manifest.findall("{*}license")]
    files += [element.text for element in manifest.findall(".//{*}icon")]
    assert files
    assert all((ROOT / str(file)).is_file() for file in files), files
    classname = manifest.findtext(".//{*}classname")
    assert f"class {classname}(" in (ROOT / "InitGui.py").read_text(encoding="utf-8")


@pytest.mark.parametrize("folder", [".", "tests", "resources"])
def test_folder_is_no_package(folder: str) -> None:
    """FreeCAD puts our root on sys.path: these names would be taken from every other addon."""
    assert not list((ROOT / folder).glob("__init__.py"))
    assert folder == "." or not list((ROOT / folder).rglob("__init__.py"))


def test_the_report_view_is_written_to_in_one_way() -> None:
    """It opens by itself for errors and warnings: these are for faults of the program, and in one place."""
    loud = re.compile(r"Console\.Print(Error|Warning|Critical)|FreeCAD\.Err\b|App\.Err\b")
    found = {
        str(path.relative_to(PACKAGE)): len(loud.findall(path.read_text(encoding="utf-8")))
        for path in PACKAGE.rglob("*.py")
    }
    # a document of a newer release loses what it knows when it is changed: that is worth a warning
    assert {name: count for name, count in found.items() if count} == {
        "app/border/hooks.py": 1,
        "app/document/migrate.py": 1,
    }
