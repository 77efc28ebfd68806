# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is in a file: an outline comes out of it, or a sentence that says what to do; soon, in bounds.

BALLOON_FILES sets how many files of either sort are tried (`make fuzz`: 10 000).
"""

from __future__ import annotations

import os
import re
import resource
import time
from pathlib import Path

import broken_files
import ezdxf
import numpy as np
import pytest
import too_much
import valid_files
from read_files import MEGABYTES as MOST_MEGABYTES
from read_files import SECONDS as MOST_SECONDS
from read_files import outcomes

from BalloonWorkbench.core.errors import BalloonError
from BalloonWorkbench.core.mesh.sizing import size_for
from BalloonWorkbench.core.mesh.triangulate import triangulate
from BalloonWorkbench.core.outline.drawing import Drawing
from BalloonWorkbench.core.readers.read import read_drawing

COUNT = int(os.environ.get("BALLOON_FILES", "100"))
SECONDS = 6.0  # of processor time
MEGABYTES = 1500

_ADVICE = re.compile(
    r"\b(Save|Choose|Use|Write|Check|Make|Simplify|Leave|Give|Draw|Close|Part|Join|Remove|Install|Enlarge|"
    r"Take|bring|keep|part|join|close|correct|separate|remove|enlarge|leave|choose|draw|give|make|use|move)\b"
)


def tried(path: Path) -> Drawing | None:
    """The shapes in a file, the largest one meshed; None where that was refused in words that help."""
    try:
        drawing, _ = read_drawing(path, 0.1)
        triangulate(drawing.largest, size_for(drawing.largest, 100))
    except BalloonError as error:
        assert _ADVICE.search(str(error)), f"no advice: {error}"
        assert "\n" not in str(error)
        return None
    return drawing


def test_no_file_does_more_than_complain(tmp_path: Path) -> None:
    read, slow = 0, {}
    for number in range(COUNT):
        ending, content = broken_files.file(number)
        path = tmp_path / f"case {number}.{ending}"
        path.write_bytes(content)
        began = time.process_time()
        try:
            drawing = tried(path)
        except BaseException as error:
            error.add_note(f"file number {number}, {ending}, {len(content)} bytes: {content[:300]!r}")
            raise
        path.unlink()
        if time.process_time() - began > SECONDS:
            slow[number] = time.process_time() - began
        if drawing is not None:
            read += 1
            assert all(np.isfinite(loop).all() for part in drawing.parts for loop in part.loops), number
            assert max(drawing.size) < 100.1, number
    assert not slow
    assert 0.02 * COUNT < read < 0.7 * COUNT
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024 < MEGABYTES


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("version", valid_files.VERSIONS)
def test_the_seeds_are_valid(version: str, binary: bool, tmp_path: Path) -> None:
    path = tmp_path / "seed.dxf"
    path.write_bytes(valid_files.dxf(version, 1, binary))
    assert ezdxf.readfile(path).dxfversion
    path.write_bytes(valid_files.dxf(version, 0, binary))
    drawing, _ = read_drawing(path)
    # the plate with two bulging sides, its hole, its weld and its spot; in the blocks two circles and more
    plate = drawing.largest
    assert (len(plate.holes), len(plate.welds), len(plate.spots)) == (1, 1, 1)


def bad(one: dict) -> bool:
    """Whether reading a file took too much, or ended in words that do not help."""
    refusal = one["refusal"]
    if refusal is not None and ("\n" in refusal or not _ADVICE.search(refusal)):
        return True
    return not one["finite"] or one["seconds"] > MOST_SECONDS or one["megabytes"] > MOST_MEGABYTES


def test_no_change_to_a_valid_file_does_more_than_refuse_it() -> None:
    read = 0
    for first in range(0, COUNT, 500):
        done = outcomes(str(first), str(min(first + 500, COUNT)))
        assert len(done) == min(500, COUNT - first)
        assert not [one for one in done if bad(one)]
        read += sum(one["refusal"] is None for one in done)
    assert 0.1 * COUNT < read < 0.9 * COUNT


#: What is said of each file of `too_much`; None where it is read.
TOLD = {
    "spline at 1e12": "more than 200000 points",
    "nested empty blocks": "more than 100000 elements",
    "nested skew blocks": "more than 100000 elements",
    "nested full blocks": "more than 100000 elements",
    "block in itself": "show themselves",
    "rows and columns": "more than 100000 elements",
    "through many points": "a curve through more than 5000 points",
    "circles": "more than 200000 points",
    "blanks of a style": None,
    "style without rules": None,
    "style of many": "too much text",
    "blanks of a transform": "endless length",
    "digits": "endless length",
    "deep transforms": "too much text",
    "tiny subpaths": "more than 200000 points",
    "attributes": "too many attributes",
    "rings": None,
    "8000 holes": None,
    "lists of nothing": "more than 200000 points",
    "large photograph": None,
}
#: Those that take their time: tried with many files.
TOLD_LATE = {"tags without end": "8 s", "many rectangles": "8 s", "grain": None}
TOLD_NOW = TOLD | TOLD_LATE if COUNT >= 10_000 else TOLD


@pytest.fixture(scope="module")
def of_too_much() -> dict[str, dict]:
    return {one["name"]: one for one in outcomes(*TOLD_NOW)}


@pytest.mark.parametrize("name", TOLD_NOW)
def test_too_much_is_refused_in_time(name: str, of_too_much: dict[str, dict]) -> None:
    """In 10 s of processor time and 1 GB; what people have is read."""
    one, words = of_too_much[name], TOLD_NOW[name]
    assert not bad(one), one
    assert one["refusal"] is None if words is None else words in str(one["refusal"]), one


def test_each_of_too_much_is_tried() -> None:
    assert {*TOLD, *TOLD_LATE} == set(too_much.FILES)
