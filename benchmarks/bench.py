# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speed, as ratios within one run: build/bench/*.json and docs/benchmarks.md.

bench.py [--sizes N ...] [--evolver-sizes N ...]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from speed import page, suite

ROOT = Path(__file__).resolve().parents[1]


def main(arguments: list[str]) -> int:
    """Measure everything and write it down."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sizes", type=int, nargs="+", default=[500, 2000, 10000, 50000])
    parser.add_argument("--evolver-sizes", type=int, nargs="*", default=[2000, 10000])
    options = parser.parse_args(arguments)
    folder = ROOT / "build" / "bench"
    folder.mkdir(parents=True, exist_ok=True)
    measured = suite.measure(folder, sorted(options.sizes), sorted(options.evolver_sizes), sys.stdout)
    text = page.written(measured)
    (ROOT / "docs" / "benchmarks.md").write_text(text, encoding="utf-8")
    sys.stdout.write("\n" + text)
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
