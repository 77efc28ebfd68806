# SPDX-License-Identifier: LGPL-2.1-or-later
"""translations.py   brings the files in resources/translations up to date with the source code.

Every text that a user meets is collected: what the window translates by name, tooltips of properties, the
sentences of the engine with their {places} for numbers, and titles, notes and sentences of the data files.
Each language has a .ts file, which Qt Linguist edits; what is translated stays, what is gone is dropped.
sentences.json lists the engine's sentences for the window, which recognises and translates them.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from functools import cache
from itertools import product
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "BalloonWorkbench"
FOLDER = ROOT / "resources" / "translations"
LANGUAGES = {"de": "German", "ja": "Japanese", "fr": "French", "es-ES": "Spanish"}

OURS, PROPERTY = "BalloonWorkbench", "App::Property"
#: Files whose texts go into pictures and files, or to developers.
_SILENT = ("pictures/preview.py", "results/vtu.py", "machines/writers/svg.py", "pictures/render.py")
_SILENT += ("machines/writers/hpgl.py", "core/reports/report.py", "core/reports/bag_report.py", "app/host.py")
_SILENT += ("core/pages/fonts.py", "core/memoize.py", "pictures/cards.py", "pictures/bag_preview.py")
_SILENT += ("core/web_pages/page.py",)  # a policy for browsers
_SILENT += ("machines/writers/gcode.py", "machines/writers/moves.py", "test_cards/files.py")
#: Layers that say plain sentences, and a file of the window that does as they do.
_SPOKEN, _SPOKEN_FILE = ("core", "app", "cli"), "/equipment.py"
#: Keys of the data files that people read, by folder or file.
_DATA = {
    "advice/rules.json": ("title", "sentence"),
    "films": ("title", "note"),
    "machines": ("title", "note"),
    "intakes": ("title", "note"),
    "gases.json": ("title",),
    "stamps.json": ("title",),
    "assembly/steps.json": ("text",),
}
_WORDS = "words.json"
#: Functions that are given what to say, and as which argument.
_SAYING = {"say": 0, "run_blocking": 0, "progress": 1}
_ENTRY = re.compile(r"[A-Z][a-z]+([ -][A-Za-z]+)*")  # of an enumeration
_LETTERS = 7  # that a sentence with places must have, to be recognised


class Text(NamedTuple):
    """A text to be translated; `sentence` when it is recognised by its form."""

    context: str
    source: str
    sentence: bool = False


@cache
def texts() -> list[Text]:
    """Every text of the workbench, each once, in a fixed order."""
    found: set[Text] = set()
    for path in [*sorted(PACKAGE.rglob("*.py")), ROOT / "InitGui.py", ROOT / "Init.py"]:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        found |= set(_named(tree))
        layer = path.relative_to(PACKAGE).parts[0] if PACKAGE in path.parents else ""
        if (layer in _SPOKEN or str(path).endswith(_SPOKEN_FILE)) and not str(path).endswith(_SILENT):
            found |= {Text(OURS, source, True) for source in (*_sentences(tree), *_said(tree))}
        if layer == "app" or path.parent == PACKAGE / "core" / "options":
            found |= {Text(OURS, source, True) for source in _choices(tree)}
        found |= {Text(OURS, source, True) for source in _titles(tree)}
    found |= {Text(OURS, source, True) for source in _data()}
    recognised = {text.source for text in found if text.sentence}
    kept = {text for text in found if text.sentence or text.context != OURS or text.source not in recognised}
    return sorted(kept)


def sentences() -> list[str]:
    """What the window recognises by its form: sentences and words of the engine and the data files."""
    return sorted({text.source for text in texts() if text.sentence})


def _named(tree: ast.AST) -> Iterator[Text]:
    """translate("..."), QT_TRANSLATE_NOOP("Context", "...") and the tooltips of Property(...)."""
    for node in ast.walk(tree):
        name = _called(node)
        if not name:
            continue
        given = [arg.value if isinstance(arg, ast.Constant) else None for arg in node.args]
        if name == "translate" and len(given) == 1 and isinstance(given[0], str):
            yield Text(OURS, given[0])
        elif name == "QT_TRANSLATE_NOOP" and len(given) == 2:
            yield Text(str(given[0]), str(given[1]))
        elif name == "Property" and len(given) > 3 and isinstance(given[3], str):
            yield Text(PROPERTY, given[3])
            yield from _labels(node)
        elif name == "result" and len(given) == 3 and isinstance(given[2], str):
            yield Text(PROPERTY, given[2])
        elif name == "MachineEntry":
            yield from _labels(node)
        elif _is_option(node):
            if not any(word.arg == "prop" and ast.unparse(word.value) == "''" for word in node.keywords):
                yield Text(PROPERTY, str(given[2]))
            yield from _labels(node)


def _is_option(node: ast.AST) -> bool:
    """A declaration of core/options: SECTION(Kind.LENGTH, default, "text", ...)."""
    if not isinstance(node, ast.Call) or len(node.args) < 3:
        return False
    kind, _, text = node.args[:3]
    return ast.unparse(kind).startswith("Kind.") and isinstance(getattr(text, "value", None), str)


def _labels(node: ast.AST) -> Iterator[Text]:
    """The label of a field, that of a preference, and what is told of a field."""
    for word in node.keywords if isinstance(node, ast.Call) else []:
        if word.arg in ("label", "preference", "tip") and isinstance(word.value, ast.Constant):
            yield Text(OURS, str(word.value.value))


def _called(node: ast.AST) -> str:
    """Name of the function that is called, empty where none is."""
    return getattr(node.func, "id", getattr(node.func, "attr", "")) if isinstance(node, ast.Call) else ""


def _said(tree: ast.AST) -> Iterator[str]:
    """say("..."), run_blocking("...", job), progress(part, "..."): what is said through a function."""
    for node in ast.walk(tree):
        name = _called(node)
        if name in _SAYING:
            yield from (text for text in _forms(node.args[_SAYING[name]]) if re.sub(r"{\d+}", "", text))


def _sentences(tree: ast.AST) -> Iterator[str]:
    """Texts that read like a sentence, with {0}, {1} ... where the program puts something."""
    skipped = {id(node) for node in _not_for_people(tree)}
    for node in _outermost(tree, skipped):
        for source in _forms(node):
            if _is_sentence(source):
                yield source


def _not_for_people(tree: ast.AST) -> Iterator[ast.AST]:
    """Docstrings, annotations, tooltips, what is looked up, options, and the help of the command line."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value
        unread = ("Property", "result", "QT_TRANSLATE_NOOP", "Section")
        if (isinstance(node, ast.Call) and getattr(node.func, "id", "") in unread) or _is_option(node):
            yield node
        if isinstance(node, ast.Call) and _called(node) in (
            "_Parser",
            "_add_parser",
            "add_argument",
        ):
            yield node  # --help is in English, as the options are


def _outermost(node: ast.AST, skipped: set[int]) -> Iterator[ast.AST]:
    if id(node) in skipped:
        return
    if _parts(node) is not None:
        yield node
        return
    for child in ast.iter_child_nodes(node):
        yield from _outermost(child, skipped)


def _parts(node: ast.AST) -> list[list[str | None]] | None:
    """The pieces of a text, each with its alternatives, None for what the program puts in; else None."""
    if isinstance(node, ast.Constant):
        return [[node.value]] if isinstance(node.value, str) else None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = _parts(node.left), _parts(node.right)
        if left is None and right is None:
            return None
        return [*(left or [[None]]), *(right or [[None]])]
    if isinstance(node, ast.JoinedStr):
        return [piece for value in node.values for piece in _parts(value) or [[None]]]
    if isinstance(node, ast.FormattedValue) and isinstance(node.value, ast.BinOp):
        repeated = node.value.left  # {"s" * (count > 1)}
        if isinstance(repeated, ast.Constant) and isinstance(repeated.value, str):
            return [["", repeated.value]]
    if isinstance(node, ast.FormattedValue) and isinstance(node.value, ast.IfExp):
        either = [node.value.body, node.value.orelse]
        if all(isinstance(value, ast.Constant) and isinstance(value.value, str) for value in either):
            return [[value.value for value in either]]  # type: ignore[attr-defined]
    return None


def _forms(node: ast.AST) -> Iterator[str]:
    for chosen in product(*(_parts(node) or [])):
        number, text = 0, ""
        for piece in chosen:
            if piece is None:
                text += f"{{{number}}}"
                number += 1
            else:
                text += piece
        yield text


def _is_sentence(source: str) -> bool:
    literal = re.sub(r"{\w*}", "", source)
    if sum(map(str.isalpha, literal)) < _LETTERS or "\n" in source or "<" in source or "__" in source:
        return False
    ends = literal.rstrip().endswith((".", ":")) or source.endswith("}")
    phrase = re.fullmatch(r"[A-Za-z'’,; -]+", literal) is not None and literal.strip().count(" ") >= 2
    return (ends and " " in literal.strip() and "=" not in literal) or phrase


def _choices(tree: ast.Module) -> Iterator[str]:
    """Entries of enumerations: capitalised words in the constants of a module."""
    for node in tree.body:
        targets = node.targets if isinstance(node, ast.Assign) else []
        names = [name.id for target in targets for name in ast.walk(target) if isinstance(name, ast.Name)]
        if not names or not all(name.isupper() for name in names):
            continue
        yield from filter(_ENTRY.fullmatch, _constants(node.value))  # type: ignore[union-attr]


def _titles(tree: ast.AST) -> Iterator[str]:
    """What people read for the choices of an option."""
    for node in ast.walk(tree):
        declared = _is_option(node) or _called(node) == "MachineEntry"
        for word in node.keywords if isinstance(node, ast.Call) and declared else []:
            if word.arg in ("choices", "titles"):
                values = getattr(word.value, "values", [])
                yield from (value for each in values for value in _constants(each) if _ENTRY.fullmatch(value))


def _constants(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Call):
        return
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    for child in ast.iter_child_nodes(node):
        yield from _constants(child)


def _data() -> Iterator[str]:
    """Titles, notes and sentences of the data files, and the words that the engine puts into sentences."""
    yield from json.loads((FOLDER / _WORDS).read_text(encoding="utf-8"))
    for name, keys in _DATA.items():
        place = ROOT / "resources" / name
        for path in sorted(place.glob("*.json")) if place.is_dir() else [place]:
            yield from _values(json.loads(path.read_text(encoding="utf-8")), keys)


def _values(data: object, keys: tuple[str, ...]) -> Iterator[str]:
    if isinstance(data, dict):
        for key, value in data.items():
            if key in keys and isinstance(value, str) and value:
                yield value
            else:
                yield from _values(value, keys)
    elif isinstance(data, list):
        for value in data:
            yield from _values(value, keys)


def ts_file(language: str) -> Path:
    """The file that translators edit."""
    return FOLDER / f"BalloonWorkbench_{language}.ts"


def read(language: str) -> dict[tuple[str, str], str]:
    """What is translated so far, by context and source."""
    path = ts_file(language)
    if not path.exists():
        return {}
    done = {}
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            key = context.findtext("name", ""), message.findtext("source", "")
            done[key] = message.findtext("translation", "")
    return done


def write(language: str, known: dict[tuple[str, str], str], wanted: list[Text]) -> None:
    """Write a language's file; the same text in another context lends its translation."""
    lent = {source: told for (_, source), told in known.items() if told}
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>"]
    lines.append(f'<TS version="2.1" language="{language}" sourcelanguage="en">')
    for context in sorted({text.context for text in wanted}):
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for source in sorted({text.source for text in wanted if text.context == context}):
            told = known.get((context, source)) or lent.get(source, "")
            mark = "" if told else ' type="unfinished"'
            lines += ["    <message>", f"        <source>{escape(source)}</source>"]
            lines += [f"        <translation{mark}>{escape(told)}</translation>", "    </message>"]
        lines.append("</context>")
    lines.append("</TS>")
    ts_file(language).write_text("\n".join(lines) + "\n", encoding="utf-8")


def sentences_json() -> str:
    """Content of sentences.json."""
    return json.dumps(sentences(), ensure_ascii=False, indent=1) + "\n"


def main() -> None:
    """Write sentences.json and the languages' files; tell what is left to translate."""
    wanted = texts()
    (FOLDER / "sentences.json").write_text(sentences_json(), encoding="utf-8")
    for language, title in LANGUAGES.items():
        write(language, read(language), wanted)
        lacking = sum(not told for told in read(language).values())
        print(f"{title}: {len(wanted) - lacking} of {len(wanted)} texts are translated")


if __name__ == "__main__":
    main()
