# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is told of a film, on every way, beside its data: never two statements that contradict each other."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from inflated import designed
from test_assembly import POPPLER, subject, told_by

from BalloonWorkbench.cli import command_line, summary
from BalloonWorkbench.core.assembly_sheet.page import SheetSubject, assembly_pdf
from BalloonWorkbench.core.assembly_sheet.steps import steps
from BalloonWorkbench.core.assembly_sheet.texts import figures, material
from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.film.film import JOININGS
from BalloonWorkbench.core.film.library import FOLDER, custom_film, film, films, read_film
from BalloonWorkbench.core.machines.machine import machines
from BalloonWorkbench.core.machines.machine_file import machines_for
from BalloonWorkbench.core.making.numbers import numbers_report
from BalloonWorkbench.core.making.safety import WELD
from BalloonWorkbench.core.options.pattern import PatternOptions
from BalloonWorkbench.core.pattern.intake.kinds import intake_kind, intake_kinds
from BalloonWorkbench.core.pattern.make import pieces_remarks
from BalloonWorkbench.core.pattern.marks import with_tie_tab
from BalloonWorkbench.core.pattern.pattern import Contour, Pattern, Role
from BalloonWorkbench.core.pictures.canvas import PreviewCanvas
from BalloonWorkbench.core.pictures.preview import preview_png
from BalloonWorkbench.core.types import in_english

ROOT = Path(__file__).resolve().parents[3]
DATA = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(FOLDER.glob("*.json"))}
#: A film of the user's own: nothing is known but its numbers.
UNKNOWN: dict[str, Any] = {"joining": "", "one_side": False, "some_grades": False, "laser": None}
TAPED = {**UNKNOWN, "joining": "tape"}
OWN = {"own": UNKNOWN, "taped": TAPED}
#: What is done with the strips of a film valve.
VALVE = [
    str(step["text"])
    for step in json.loads((ROOT / "resources" / "assembly" / "steps.json").read_text("utf-8"))["steps"]
    if "film-valve" in step.get("intakes", ())
]
#: A word that tells how films are joined, and the joinings for which it may be said.
WORDS = {
    r"\bweld": ("heat", "high-frequency"),
    r"\bglue": ("glue",),
    r"\btaped seam|\bjoin the panels with tape|\btape along": ("tape",),
    r"high frequency": ("high-frequency",),
    r"\btemperature|\biron\b|\bheat": ("heat",),
    r"soapy water": ("heat", "high-frequency"),
}
#: What a sheet says of each joining, whatever else it is about.
MUST = {
    "heat": "Weld along",
    "high-frequency": "Weld with high frequency",
    "glue": "Glue",
    "tape": "Tape along",
}
MUST[""] = "Join the panels along"


def contradictions(text: str, data: dict[str, Any]) -> list[str]:
    """What a text says against the data of a film."""
    own = text
    for step in VALVE:  # its strips are of another film
        own = own.replace(step, "")
    found = [
        word
        for word, joinings in WORDS.items()
        if re.search(word, own, re.IGNORECASE) and data["joining"] not in joinings
    ]
    lasers = re.findall(r"[^.]*\blaser[^.]*", own)
    if bool(lasers) != (data["laser"] is False) or any("Never" not in told for told in lasers):
        found.append("laser")
    if "sealing side" in own and not data["one_side"]:
        found.append("sealing side")
    if "sealing layer" in own and not data["some_grades"]:
        found.append("sealing layer")
    if re.search(r"\d\s*°C", own):
        found.append("a temperature that no data has")
    return found


def about(name: str, shape: str = "disc", intake: str = "straw") -> tuple[SheetSubject, dict[str, Any]]:
    """A balloon of a film of the library, or of one of a user's own, and the data of the film."""
    if name in DATA:
        return subject(shape, name, intake), DATA[name]
    one = subject(shape, intake=intake)
    own = replace(custom_film(1e9, 0.4, 3e-5), max_stress=5e7, joining=OWN[name]["joining"])
    return replace(one, film=own), OWN[name]


@cache
def tabbed(name: str, shape: str, intake: str) -> Pattern:
    return with_tie_tab(about(name, shape, intake)[0].pattern, 1.0)


def variants(name: str, intake: str) -> Iterator[tuple[SheetSubject, dict[str, Any]]]:
    """With and without holes, a tie tab, lines inside, a grain, enough strength; none where it is refused."""
    try:
        pieces_remarks(
            PatternOptions(intake_kind="straw" if intake == "none" else intake), about(name)[0].film
        )
    except InputError:
        return
    shapes = ("disc", "ring") if intake in ("straw", "none") else ("disc",)
    for shape, tab, inside, grain, strong in product(shapes, *[(False, True)] * 4):
        if shape == "disc" and intake == "none":
            continue
        one, data = about(name, shape, intake)
        pattern, made_of, numbers = one.pattern, one.film, one.numbers
        if tab:
            pattern = tabbed(name, shape, intake)
        if inside:
            line = Contour(Role.WELD, np.array([[0.0, 0.0], [0.01, 0.0]]), False)
            pattern = replace(pattern, contours=(line, *pattern.contours))
        if grain:
            made_of = replace(made_of, young_modulus_across=0.5 * made_of.young_modulus)
        safe = replace(numbers.safety, safe_pressure=(2.0 if strong else 0.5) * numbers.safety.pressure)
        yield replace(one, pattern=pattern, film=made_of, numbers=replace(numbers, safety=safe)), data


def test_every_film_says_how_it_is_joined_and_where_that_is_from() -> None:
    for name, data in DATA.items():
        assert data["joining"] in JOININGS, name
        assert data["joining"], name
        assert sum(source.startswith("Joining: ") for source in data["sources"]) == 1, name
        assert sum(source.startswith("Laser: ") for source in data["sources"]) == (
            data["laser"] is not None
        ), name
        read = film(name)
        assert (
            UNKNOWN.keys()
            == {key: getattr(read, key) for key in UNKNOWN if getattr(read, key) == data[key]}.keys()
        )


@pytest.mark.parametrize("name", DATA)
def test_note_of_a_film_agrees_with_its_data(name: str) -> None:
    note, data = DATA[name]["note"], DATA[name]
    assert ("laser" in note) == (data["laser"] is False)
    assert ("Glue" in note) == (data["joining"] == "glue")
    assert bool(re.search(r"\b[Ww]eld", note)) == (data["joining"] in ("heat", "high-frequency"))
    assert ("high frequency" in note) == (data["joining"] == "high-frequency")
    assert ("sealing layer" in note) == data["some_grades"]
    # strengths of welds are of films that are welded
    making = json.loads((ROOT / "resources" / "making.json").read_text(encoding="utf-8"))
    assert (name in making["seal_strength_N_m"]) == (data["joining"] != "glue")


@pytest.mark.parametrize("name", [*DATA, *OWN])
@pytest.mark.parametrize("intake", [*intake_kinds(), "none"])
def test_sheet_says_nothing_against_the_film(name: str, intake: str) -> None:
    for one, data in variants(name, intake):
        work = steps(one.pattern, one.film, one.numbers)
        lists = [f"{key}: {text}" for key, text in material(one.film, one.pattern, one.numbers)[2:]]
        lists += [f"{key}: {text}" for key, text in figures(one.film, one.numbers)]
        text = "\n".join([*work, *lists])
        assert not contradictions(text, data), text
        assert len(set(work)) == len(work)
        assert MUST[data["joining"]] in text
        assert "{" not in text
        assert ("sealing sides" in text) == data["one_side"]
        assert ("sealing layer" in text) == data["some_grades"]
        assert ("grain" in text) == (one.film.lies is not None)
        (most,) = re.findall(r"Fill to ([\d.]+) kPa", text)
        safety = one.numbers.safety
        assert safety.safe_pressure is not None
        assert 1e3 * float(most) == pytest.approx(min(safety.pressure, safety.safe_pressure), rel=0.01)
        kinds = [intake_kind(each.kind) for each in one.pattern.intakes]
        assert ("mouth of the neck" in text) == any(kind.place == "rim" for kind in kinds)


@pytest.mark.parametrize("name", [*DATA, *OWN])
@pytest.mark.parametrize("intake", [*intake_kinds(), "none"])
def test_steps_come_in_the_order_of_the_work(name: str, intake: str) -> None:
    """Holes while the film is in one piece, then the panels; the warning of the laser before both."""
    for one, data in variants(name, intake):
        work = steps(one.pattern, one.film, one.numbers)

        def place(word: str, work: list[str] = work) -> list[int]:
            return [number for number, step in enumerate(work) if word in step]

        (panels,) = place("Cut two panels")
        inner = one.pattern.of(Role.CUT_INNER)
        holes, nozzle = place("Cut out the holes inside"), place("hole of the nozzle")
        assert len(holes) == any(not hole.front for hole in inner)
        assert len(nozzle) == any(hole.front for hole in inner) == (intake == "nozzle")
        assert all(step < panels for step in (*holes, *nozzle))
        warned = place("laser")
        assert len(warned) == (data["laser"] is False)
        assert all(step < min([panels, *holes, *nozzle]) for step in warned)
        (joined,) = place(MUST[data["joining"]])[:1]
        (laid,) = place("Lay the panels on each other")
        assert panels < laid < joined
        assert all(step > joined for step in (*place("inside the balloon"), *place("Fill to")))


@POPPLER
@pytest.mark.parametrize("name", ["pvc", "kraft-paper", "own"])
def test_page_says_nothing_against_the_film(name: str, tmp_path: Path) -> None:
    """All of the page: legend, lists and steps."""
    one, data = about(name, "ring", "straw")
    line = Contour(Role.WELD, np.array([[0.0, 0.1], [0.01, 0.1]]), False)
    pattern = replace(one.pattern, contours=(line, *one.pattern.contours))
    path = tmp_path / "page.pdf"
    path.write_bytes(assembly_pdf(replace(one, pattern=pattern)))
    text = " ".join(told_by("pdftotext", path, "-").replace("\u00a0", " ").split())
    assert not contradictions(text, data), text
    assert one.film.seam in text


@pytest.mark.parametrize("name", ["pvc", "kraft-paper", "own"])
def test_command_line_and_preview_say_nothing_against_the_film(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    one, data = about(name)
    numbers = numbers_report(one.numbers)
    line = "\n".join(summary._making(numbers, one.film, in_english))
    assert not contradictions(line, {**data, "laser": None}), line
    assert (one.film.seam in line) == (numbers["strength"]["weakest"] == WELD)
    said: list[str] = []
    write = PreviewCanvas.text

    def heard(canvas: PreviewCanvas, *given: Any, **look: Any) -> Any:
        said.extend(each for each in given if isinstance(each, str))
        return write(canvas, *given, **look)

    monkeypatch.setattr(PreviewCanvas, "text", heard)
    monkeypatch.setattr("BalloonWorkbench.core.pictures.preview._balloon", lambda *given: None)
    from drawn_shapes import NAMED

    preview_png([designed(NAMED["disc"], 300)], [one.pattern], one.film.seam)
    text = "\n".join(said)
    assert not contradictions(text, {**data, "laser": None}), text
    assert one.film.seam in text


def test_film_that_must_not_be_lasered_is_no_file_for_a_laser() -> None:
    """Told before the work; other machines are not warned of."""
    for machine, name in product(machines().values(), films()):
        forbidden = machine.process == "laser" and DATA[name]["laser"] is False
        if forbidden:
            with pytest.raises(ExportError, match="laser") as caught:
                machines_for(film(name), [machine])
            assert machine.title in str(caught.value)
        else:
            borne, remarks = machines_for(film(name), [machine])
            assert borne == [machine]
            welds = DATA[name]["joining"] == "heat" or machine.process != "heat-sealing"
            assert len(remarks) == (not welds), remarks
    lasers = [machine for machine in machines().values() if machine.process == "laser"]
    assert {machine.name for machine in lasers} >= {"glowforge", "lightburn", "rdworks"}
    assert all(
        (machine.process == "laser") >= ("laser" in machine.title.lower()) for machine in machines().values()
    )
    assert not machines_for(custom_film(1e9, 0.3, 3e-5), lasers)[1]


def test_own_file_without_the_new_data_says_nothing_of_them(tmp_path: Path) -> None:
    data = {key: value for key, value in DATA["pvc"].items() if key not in UNKNOWN}
    path = tmp_path / "pvc.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    read = read_film(path)
    assert {key: getattr(read, key) for key in UNKNOWN} == UNKNOWN
    assert read.seam == "seam"


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"joining": "sewn"}, "sewn"),
        ({"joining": None}, "joining"),
        ({"one_side": 1}, "one_side"),
        ({"some_grades": "yes"}, "some_grades"),
        ({"laser": "never"}, "laser"),
        ({"laser": 0}, "laser"),
    ],
)
def test_broken_data_are_named(tmp_path: Path, change: dict[str, Any], word: str) -> None:
    path = tmp_path / "pvc.json"
    path.write_text(json.dumps({**DATA["pvc"], **change}), encoding="utf-8")
    with pytest.raises(InputError, match=word):
        read_film(path)


def test_command_line_refuses_a_laser_before_the_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "BalloonWorkbench.cli.settings.make_balloon",
        lambda *given, **more: pytest.fail("the work has begun"),
    )
    out = tmp_path / "out"
    assert (
        command_line.main(
            ["inflate", "x.json", "--material", "pvc", "--machine", "rdworks", "--out", str(out)]
        )
        == 2
    )
    assert "Soft PVC film, 0.2 mm must never be cut with a laser" in capsys.readouterr().err
    assert not out.exists()
