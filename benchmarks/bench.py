# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speed, as ratios within one run: build/bench/*.json and docs/benchmarks.md.

bench.py [--sizes N ...] [--evolver-sizes N ...]
bench.py --commands  only whole commands: the rest of the page stays as it is
bench.py --account   only where the time of a cold inflation goes, for the disc: the rest of the page stays
bench.py --strokes   only how soon a stroke is a balloon on the screen: the rest of the page stays as it is
bench.py --nesting   only how much film layouts use, where spyrrow is installed: the rest of the page stays
bench.py --studies 1000   only how much of the machine a study uses, what kills cost: build/bench/studies.json
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path

from speed import commands, nesting, page, strokes, studies, suite

ROOT = Path(__file__).resolve().parents[1]


def main(arguments: list[str]) -> int:
    """Measure everything and write it down."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", type=int, nargs="+", default=[500, 2000, 10000, 50000])
    parser.add_argument("--evolver-sizes", type=int, nargs="*", default=[2000, 10000])
    parser.add_argument("--strokes", action="store_true")
    parser.add_argument("--commands", action="store_true")
    parser.add_argument("--account", action="store_true")
    parser.add_argument("--nesting", action="store_true")
    parser.add_argument("--studies", type=int, metavar="BALLOONS")
    options = parser.parse_args(arguments)
    folder = ROOT / "build" / "bench"
    folder.mkdir(parents=True, exist_ok=True)
    if options.studies:
        with tempfile.TemporaryDirectory(dir=folder) as place:
            figures = json.dumps(studies.measure(Path(place), options.studies), indent=2)
        (folder / "studies.json").write_text(figures + "\n", encoding="utf-8")
        sys.stdout.write(figures + "\n")
        return 0
    file = ROOT / "docs" / "benchmarks.md"
    if options.commands:
        measured = commands.measure(folder)
        text = page.with_commands(file.read_text(encoding="utf-8"), measured, commands.loading())
    elif options.strokes:
        text = page.with_strokes(file.read_text(encoding="utf-8"), strokes.measure(folder))
    elif options.nesting:
        text = nesting.replaced(file.read_text(encoding="utf-8"), nesting.measure())
    elif options.account:
        measured = suite.measure_account(folder, sorted(options.sizes))
        text = page.with_account(file.read_text(encoding="utf-8"), measured)
    else:
        text = page.written(
            suite.measure(folder, sorted(options.sizes), sorted(options.evolver_sizes), sys.stdout)
        )
        text = nesting.replaced(text, nesting.measure())
    file.write_text(text, encoding="utf-8")
    sys.stdout.write("\n" + text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
