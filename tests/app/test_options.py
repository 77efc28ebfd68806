# SPDX-License-Identifier: LGPL-2.1-or-later
"""One declaration for each option: the properties of documents, the Python API and preferences follow."""

import subprocess
from pathlib import Path

import pytest

from BalloonWorkbench.app import artwork, balloon, film_sheet, gored_body, outline, pattern, target
from BalloonWorkbench.app.document import create
from BalloonWorkbench.app.properties import film, preferences, values
from BalloonWorkbench.app.properties.property_table import engine_value, shown_value
from BalloonWorkbench.core.options.option import Kind
from BalloonWorkbench.core.options.table import options

ROOT = Path(__file__).parents[2]
HELD = {
    item.option.text: item
    for module in (outline, gored_body, target, balloon, pattern, artwork, film_sheet)
    for item in module.PROPERTIES
    if item.option is not None
}
#: A length, a preference and a choice that nobody has declared, added by a line each.
ADDED = """    sparkle: float = MARKS(Kind.LENGTH, 0.0025, "How wide the glitter is strewn", label="Glitter",
        preference="Glitter")
    glow: str = MARKS(Kind.CHOICE, "dim", "How it glows", label="Glow", choices={"dim": "Dim", "hot": "Hot"})
"""
CODE = """
import sys
sys.path.insert(0, {folder!r})
sys.path.append({sketches!r})
for name in [name for name in sys.modules if name.startswith("BalloonWorkbench")]:
    del sys.modules[name]
import FreeCAD, sketches
import BalloonWorkbench
assert BalloonWorkbench.__file__.startswith({folder!r}), BalloonWorkbench.__file__
from BalloonWorkbench.app import pattern; from BalloonWorkbench.app.properties import preferences
doc = FreeCAD.newDocument("More")
made = BalloonWorkbench.from_sketch(doc, sketches.rectangle(doc, 120, 80), mode="Inflate as drawn",
                                    mesh_size=15, sparkle="4 mm", glow="Hot")
held, told = made.pattern, pattern.values(made.pattern)
print("held:", held.Sparkle.Value, held.Glow, held.getGroupOfProperty("Sparkle"), told.sparkle, told.glow)
BalloonWorkbench.change(made, sparkle=5)
print("held:", round(pattern.values(held).sparkle, 9), "Sparkle" in preferences.items(), flush=True)
FreeCAD.closeDocument(doc.Name)  # FreeCAD 1.1 crashes when it closes a mesh at its own end
"""


def test_every_option_of_documents_is_a_property_once():
    declared = [option for option in options() if option.property_name]
    assert {option.text for option in declared} == set(HELD)
    assert len(HELD) == len(declared) > 50


@pytest.mark.parametrize(
    "text", [text for text, item in HELD.items() if item.name not in (*film.VALUES, "Film")]
)
def test_a_new_object_begins_with_what_is_declared(doc, text):
    """But for the film and its numbers: see test_preferences.py."""
    item = HELD[text]
    parts = create.make(doc)
    made = [*parts, artwork.make(parts.pattern), film_sheet.make(doc, [parts.pattern])]
    made += [create.make(doc, source=kind).outline for kind in ("GoredBody", "Target")]
    (obj,) = [obj for obj in made if text in map(obj.getDocumentationOfProperty, obj.PropertiesList)]
    assert obj.getTypeIdOfProperty(item.name) == f"App::Property{item.type}"
    assert obj.getGroupOfProperty(item.name) == item.option.group
    value, option = getattr(obj, item.name), item.option
    if option.begins is None:
        told = 0 if option.kind is Kind.COUNT and option.default is None else option.default
        assert engine_value(option, value) == pytest.approx(told) or option.kind is Kind.FILE
    else:
        assert getattr(value, "Value", value) == pytest.approx(shown_value(option, option.begins))


def test_values_go_through_a_document_and_back():
    """In the unit of the property, and in that of the engine."""
    samples = {Kind.CHOICE: None, Kind.FLAG: True, Kind.TEXT: "A", Kind.FILE: "a.png", Kind.COUNT: 7}
    for option in [item.option for item in HELD.values() if item.name != "Film"]:
        given = list(option.titles)[-1] if option.titles else samples.get(option.kind, 300.0)
        assert engine_value(option, shown_value(option, given)) == pytest.approx(given), option.name


def test_preferences_are_those_that_are_declared():
    kept = {item.key for item in preferences.items().values() if item.prop}
    assert kept == {"Film", "Live"} | {
        option.property_name for option in options() if option.preference and option.property_name
    }


def test_macros_know_every_option_of_a_balloon(doc):
    body, solid = (create.make(doc, source=kind).outline for kind in ("GoredBody", "Target"))
    for source, first in ((None, outline), (body, gored_body), (solid, target)):
        known = values.places(source)
        held = [item for module in (first, balloon, pattern) for item in module.PROPERTIES if item.option]
        assert held
        for item in held:
            assert {item.option.api_name, f"film_{item.option.api_name}"} & set(known), item.name


def test_an_entry_is_a_property_and_a_value_of_macros(tmp_path):
    """The package as it is with two entries more, in a FreeCAD of its own."""
    import shutil

    shutil.copytree(ROOT / "BalloonWorkbench", tmp_path / "BalloonWorkbench")
    (tmp_path / "resources").symlink_to(ROOT / "resources")
    shutil.copy(ROOT / "package.xml", tmp_path)
    declared = tmp_path / "BalloonWorkbench" / "core" / "options" / "pattern.py"
    text = declared.read_text(encoding="utf-8")
    declared.write_text(text.replace("    tie_tab: bool", f"{ADDED}    tie_tab: bool", 1), encoding="utf-8")
    code = CODE.format(folder=str(tmp_path), sketches=str(ROOT / "tests" / "app"))
    ended = subprocess.run(
        ["freecadcmd", "-c", code],
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.DEVNULL,
        timeout=600,
    )
    held = [line.partition("held: ")[2] for line in ended.stdout.splitlines() if "held: " in line]
    assert held == ["4.0 Hot Marks 0.004 hot", "0.005 True"], ended.stdout[-3000:] + ended.stderr
