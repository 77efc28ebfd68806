# SPDX-License-Identifier: LGPL-2.1-or-later
"""option_tables.py   writes the tables of all options, and of a study's results, into docs."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from BalloonWorkbench.cli.options import help_text, metavar  # noqa: E402
from BalloonWorkbench.core.options.film import FilmOptions  # noqa: E402
from BalloonWorkbench.core.options.option import Kind, Option, options_of  # noqa: E402
from BalloonWorkbench.core.options.table import options  # noqa: E402
from BalloonWorkbench.core.studies.results import RESULTS  # noqa: E402

BEGIN, END = "<!-- options: made by tools/option_tables.py -->\n", "<!-- end of options -->\n"


def command_line() -> str:
    """What may be typed, by topic."""
    return _table(("option", "what it is"), _typed())


def _typed() -> Iterator[tuple[str, str]]:
    topic = ""
    for option in options():
        if not option.flag_name:
            continue
        if option.topic != topic:
            topic = option.topic
            yield f"**{topic}**", ""
        yield f"`{f'{option.flag_name} {metavar(option)}'.strip()}`", help_text(option)


def api() -> str:
    """The names of values in macros."""
    films = options_of(FilmOptions)
    rows = []
    for option in options():
        if option.property_name:
            twice = option in films and option.api_name == "seal_width"
            rows.append((f"`{'film_' * twice}{option.api_name}`", _chosen(option), option.text))
    return _table(("name", "value", "what it is"), rows)


def _chosen(option: Option) -> str:
    if option.kind is Kind.CHOICE:
        return ", ".join(
            f'"{known}"' for known in (option.titles if option.begins else option.titles.values())
        )
    return "length" if option.kind is Kind.HEIGHT else option.kind.value


def _table(heads: tuple[str, ...], rows: object) -> str:
    lines = [heads, ("---",) * len(heads), *rows]  # type: ignore[misc]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def studies() -> str:
    """The results of a study's table."""
    rows = [(f"`{result.name}`", result.text) for result in RESULTS]
    rows += [("`warnings`", "The notes of the report"), ("`failure`", "Why there is no balloon")]
    return _table(("column", "what it is"), rows)


TABLES = {"command-line.md": command_line, "api.md": api, "studies.md": studies}


def renewed(path: Path) -> str:
    """The text of a page with its table as it is now."""
    before, rest = path.read_text(encoding="utf-8").split(BEGIN)
    return before + BEGIN + TABLES[path.name]() + END + rest.split(END)[1]


if __name__ == "__main__":
    for name in TABLES:
        page = ROOT / "docs" / name
        page.write_text(renewed(page), encoding="utf-8")
