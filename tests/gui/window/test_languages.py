# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in other languages: menu, tools, panels, and what the engine and the coach say."""

import shutil
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import hands
import Part
import pytest

import BalloonWorkbench
from BalloonWorkbench.app.border import status
from BalloonWorkbench.app.document import create
from BalloonWorkbench.core.pages import fonts
from BalloonWorkbench.gui.window.sentences import translated


@pytest.fixture
def speak():
    """Change FreeCAD's language as its preferences do."""

    def change(language):
        Gui.setLocale(language)
        hands.wait(0.3)

    yield change
    change("English")


MENUS = {
    "German": ("Folienballon", "Neuer Ballon aus Bild"),
    "Japanese": ("フィルム風船(B)", "画像から新しい風船"),
    "French": ("Ballon en film", "Nouveau ballon depuis une image"),
    "Spanish": ("Globo de película", "Nuevo globo desde imagen"),
}


@pytest.mark.parametrize("language", MENUS)
def test_menu_and_tools(speak, language):
    speak(language)
    menu, command = MENUS[language]
    window = Gui.getMainWindow()
    menus = [action for action in window.menuBar().actions() if action.text().replace("&", "") == menu]
    assert menus, [action.text() for action in window.menuBar().actions()]
    assert command in [action.text().replace("&", "") for action in menus[0].menu().actions()]
    action = Gui.Command.get("BalloonWorkbench_FromPicture").getAction()[0]
    assert command in action.toolTip()


PANELS = {
    "German": ("Dicke", "Automatisch", "Folie"),
    "Japanese": ("厚み", "自動", "フィルム"),
    "French": ("Épaisseur", "Automatique", "Film"),
    "Spanish": ("Grosor", "Automática", "Película"),
}


@pytest.mark.slow
@pytest.mark.parametrize("language", PANELS)
def test_panel(speak, doc, language):
    speak(language)
    label, choice, tab = PANELS[language]
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    steps, thickness = hands.find("Steps"), hands.find("Thickness")
    hands.show_tab(thickness)
    assert steps.tabText(steps.currentIndex()) == tab
    assert thickness.parentWidget().layout().labelForField(thickness).text() == label
    backend = hands.find("Backend")
    assert choice in [backend.itemText(index) for index in range(backend.count())]
    assert backend.currentData() == "Automatic", "what is kept in the document stays English"
    hands.screenshot(f"panel-{language}")
    hands.press("Cancel")


def test_choice_in_another_language_reaches_the_property(speak, doc):
    speak("German")
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    made = next(obj for obj in doc.Objects if "Mode" in obj.PropertiesList)
    hands.choose(hands.find("Mode"), "Wie gezeichnet aufblasen")
    assert made.Mode == "Inflate as drawn"
    hands.choose(hands.find("Mode"), "An Zeichnung anpassen")
    assert made.Mode == "Fit to drawing"
    hands.press("Cancel")


COACH = {
    "German": "Dieser Arm ist zu dünn zum Füllen",
    "Japanese": "この腕は細すぎてふくらみません",
    "French": "Ce bras est trop mince pour se remplir",
    "Spanish": "Este brazo es demasiado fino para llenarse",
}


@pytest.mark.slow
@pytest.mark.parametrize("language", COACH)
def test_coach(speak, doc, language):
    speak(language)
    corners = [(0, 0), (120, 0), (120, 45), (220, 45), (220, 53), (120, 53), (120, 100), (0, 100)]
    wire = doc.addObject("Part::Feature", "Plate")
    wire.Shape = Part.makePolygon([App.Vector(x, y) for x, y in (*corners, corners[0])])
    made = create.balloon_from_sketch(doc, wire, mesh_size=14, correct=False, intake=False)
    Gui.runCommand("BalloonWorkbench_Advice")
    hands.wait_until(hands.panel_is_seen)
    findings = hands.find("Findings")
    told = [findings.item(row).text() for row in range(findings.count())]
    assert any(text.startswith(COACH[language]) for text in told), told
    assert not any(" is " in text or "film" in text.split() for text in told if language != "French")
    hands.screenshot(f"coach-{language}")
    hands.press("Close")
    assert all("thin" in text for text in made.balloon.Advice if "arm" in text), "documents stay English"


def test_error_in_the_panel(speak, doc, tmp_path):
    """A picture without a shape: what happened and what to do, in German."""
    speak("German")
    path = tmp_path / "text.png"
    path.write_text("no picture")
    Gui.runCommand("BalloonWorkbench_FromPicture")
    hands.wait_until(hands.panel_is_seen)
    hands.type_into(hands.find("Drawing"), str(path))
    assert hands.message() == "„text.png“ ist kein lesbares Bild. Als PNG, JPEG oder BMP speichern."
    hands.press("Cancel")


SAID = [
    ("The simulation was stopped.", "Die Simulation wurde angehalten."),
    (
        "The Poisson's ratio 0.7 is not between 0 and 0.5: give one such as 0.38.",
        "Die Querkontraktionszahl 0.7 liegt nicht zwischen 0 und 0,5: zum Beispiel 0.38 angeben.",
    ),
    (
        "The shape is only 8.2 mm thick near (123.0, 53.0) mm, too thin for a mesh of 20 mm: make it thicker"
        " there, or use a mesh size of at most 15 mm.",
        "Die Form ist nahe (123.0, 53.0) mm nur 8.2 mm dick, zu dünn für ein Netz von 20 mm: dort verdicken"
        " oder höchstens 15 mm Netzweite benutzen.",
    ),
    (
        "fish-2 was left out. The simulation was stopped.",
        "fish-2 wurde weggelassen. Die Simulation wurde angehalten.",
    ),
    ("An own remark {0} of a user", "An own remark {0} of a user"),
    ("", ""),
]


@pytest.mark.parametrize(("english", "german"), SAID)
def test_sentences_of_the_engine(speak, english, german):
    speak("German")
    assert translated(english) == german
    assert translated(f"{english}\n{english}") == f"{german}\n{german}"


def test_english_stays_as_it_was_said():
    for english, _ in SAID:
        assert translated(english) == english


def test_errors_of_the_engine_are_recognised():
    """Real errors, not their text: each must lead to a known sentence."""
    from BalloonWorkbench.core.errors import BalloonError
    from BalloonWorkbench.core.film import library
    from BalloonWorkbench.core.language.speech import listed
    from BalloonWorkbench.core.units import parse_length

    plain, forms = listed()
    for act in (
        lambda: library.film("cheese"),
        lambda: library.custom_film(1e3, 0.3, 1e-5),
        lambda: library.custom_film(1e9, 0.7, 1e-5),
        lambda: parse_length("three"),
    ):
        with pytest.raises(BalloonError) as caught:
            act()
        text = str(caught.value)
        assert text in plain or any(form.pattern.fullmatch(text) for form in forms), text


def test_status_of_an_object_stays_english(speak, doc):
    speak("Japanese")
    made = create.make(doc)
    doc.recompute()
    assert status.problem(made.outline) == "Choose a picture or a sketch."
    assert translated(status.problem(made.outline)) == "画像かスケッチを選んでください。"


SHEETS = {
    "German": ("Montageblatt", "Schnittmuster, zweimal schneiden", "trägt"),
    "Japanese": ("組み立て図", "型紙（2 枚切り", "浮力"),
    "French": ("Fiche de montage", "Patron, à couper deux fois", "porte"),
    "Spanish": ("Hoja de montaje", "Patrón, cortar dos", "levanta"),
}


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler-utils are not installed")
@pytest.mark.parametrize("language", SHEETS)
def test_assembly_sheet(speak, made, language, tmp_path):
    """The panel, its page, and the page that the recorded line of a macro writes."""
    speak(language)
    if language == "Japanese" and not fonts.can_show("組"):
        pytest.skip("no Japanese font is installed")
    path = tmp_path / "sheet.pdf"
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_AssemblySheet")
    hands.wait_until(hands.panel_is_seen)
    title, heading, lifts = SHEETS[language]

    def labels():
        return [label.text() for label in hands.visible(hands.QtWidgets.QLabel)]

    hands.wait_until(lambda: any(lifts in text for text in labels()))
    assert not any(" the film " in text or "(film)" in text for text in labels() if language != "French")
    assert not hands.find("AssemblyMessage").text()
    hands.screenshot(f"assembly-{language}")
    hands.type_into(hands.find("AssemblyFile"), str(path), confirm=False)
    hands.press("Ok")
    hands.wait_until(hands.panel_is_closed)
    told = subprocess.run(["pdftotext", path, "-"], capture_output=True, check=True).stdout.decode()
    for wanted in (title, heading, lifts):
        assert wanted.replace(" ", "") in told.replace(" ", "").replace("\u00a0", ""), wanted
    again = BalloonWorkbench.assembly_sheet(made, tmp_path / "again.pdf")
    assert again.read_bytes() == path.read_bytes()


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="poppler-utils are not installed")
def test_pattern_on_pages(speak, made, tmp_path):
    speak("German")
    path = BalloonWorkbench.export(made.pattern, tmp_path / "pages.pdf", machine="paper", paper="A4")
    told = subprocess.run(["pdftotext", path, "-"], capture_output=True, check=True).stdout.decode()
    assert "Schnittmuster auf mehreren Seiten" in told
    assert "Seite 1 von" in told


def test_assembly_sheet_without_a_font(speak, made, stand_in):
    """It will be in English; the panel says why and what to do."""
    stand_in.setattr(fonts, "_JAPANESE", ())
    speak("Japanese")
    Gui.Selection.addSelection(made.balloon)
    Gui.runCommand("BalloonWorkbench_AssemblySheet")
    hands.wait_until(hands.panel_is_seen)
    assert "IPAexGothic" in hands.find("AssemblyMessage").text()
    assert "フォント" in hands.find("AssemblyMessage").text()
    hands.press("Cancel")
    speak("French")
    Gui.runCommand("BalloonWorkbench_AssemblySheet")
    hands.wait_until(hands.panel_is_seen)
    assert not hands.find("AssemblyMessage").text()
    hands.press("Cancel")
