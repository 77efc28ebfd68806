# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the file of a study says: its rows, and sentences about what cannot be."""

from __future__ import annotations

import itertools
import json
import tracemalloc
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.studies.plan import distinct, planned
from BalloonWorkbench.core.studies.read_study import read_study, study_of
from BalloonWorkbench.core.studies.study import Study


@pytest.fixture
def place(tmp_path: Path) -> Path:
    for name in ("a.png", "b.png", "c.svg"):
        (tmp_path / name).write_text(name)
    return tmp_path


def study(place: Path, **data: Any) -> Study:
    return study_of(data, place)


def table(place: Path, text: str) -> Study:
    (place / "s.csv").write_text(text, encoding="utf-8")
    return read_study(place / "s.csv")


def test_a_grid_is_each_with_each(place: Path) -> None:
    rows = study(
        place,
        fixed={"material": "mylar"},
        vary={"input": {"glob": "*.png"}, "width": ["200mm", "300mm"], "gores": {"range": [6, 12, 3]}},
    ).rows
    each = itertools.product(["a.png", "b.png"], ["200mm", "300mm"], [6, 9, 12])
    assert [(row["input"], row["width"], row["gores"]) for row in rows] == [*each]
    assert {row["material"] for row in rows} == {"mylar"}


@pytest.mark.parametrize(
    ("axis", "values"),
    [
        ({"linspace": ["1kPa", "2kPa", 5]}, ["1kPa", "1.25kPa", "1.5kPa", "1.75kPa", "2kPa"]),
        ({"linspace": [0.1, 0.4, 4]}, [0.1, 0.2, 0.3, 0.4]),
        ({"range": ["0.1bar", "0.4bar", "0.1bar"]}, ["0.1bar", "0.2bar", "0.3bar", "0.4bar"]),
        ({"range": [30, 10, -10]}, [30, 20, 10]),
        ({"range": [1, 2.5, 1]}, [1, 2]),
        ({"linspace": ["1kPa", 3, 1]}, ["1kPa"]),
        ("2kPa", ["2kPa"]),
    ],
)
def test_what_a_column_runs_through(place: Path, axis: Any, values: list[Any]) -> None:
    rows = study(place, fixed={"input": "a.png"}, vary={"pressure": axis}).rows
    assert [row["pressure"] for row in rows] == values


def test_a_latin_hypercube_takes_each_part_once_and_is_the_same_for_its_seed(place: Path) -> None:
    data = {
        "vary": {
            "input": {"glob": "*.png"},
            "width": {"between": [0.0, 10.0]},
            "gores": {"between": [6, 10]},
        },
        "sample": {"kind": "latin-hypercube", "rows": 10, "seed": 4},
    }
    rows = [*study(place, **data).rows]
    assert sorted(int(row["width"]) for row in rows) == [*range(10)]
    assert Counter(row["gores"] for row in rows) == dict.fromkeys(range(6, 11), 2)
    assert Counter(row["input"] for row in rows) == {"a.png": 5, "b.png": 5}
    assert [*study(place, **data).rows] == rows
    data["sample"]["seed"] = 5
    assert [*study(place, **data).rows] != rows


def test_tables_of_spreadsheets(place: Path) -> None:
    same = [*table(place, 'input,seal-width,label\na.png,5mm,"x, y"\n\nb.png,,z\n').rows]
    assert same == [{"input": "a.png", "seal-width": "5mm", "label": "x, y"},
                    {"input": "b.png", "seal-width": "", "label": "z"}]  # fmt: skip
    assert [
        *table(place, "\ufeffinput;Seal width;label\r\na.png;5mm;x, y\r\n;;\r\n b.png ;;z\r\n").rows
    ] == same


def test_rows_that_mean_the_same_are_one_balloon(place: Path) -> None:
    both = table(place, "input,width,pressure\na.png,30cm,2kPa\na.png,300mm,\na.png,0.3,2000\nb.png,30cm,\n")
    keys = [row.key for row in planned(both)]
    assert len({*keys[:3]}) == 1
    assert len({*keys}) == 2
    assert [job.key for job in distinct(both)] == [keys[0], keys[3]]


def test_a_key_depends_on_the_content_and_on_all_values(place: Path) -> None:
    def key(**row: Any) -> str:
        return next(planned(study(place, rows=[{"input": "a.png", **row}]))).key

    first = key()
    others = {key(width="0.2"), key(height="0.2"), key(command="inflate"), key(input="b.png"), first}
    assert len(others) == 5
    (place / "a.png").write_text("changed!")
    assert key() not in others


def test_shares_have_every_balloon_once(place: Path) -> None:
    whole = study(place, fixed={"input": "a.png"}, vary={"width": {"linspace": [0.1, 0.2, 11]}})
    shares = [[job.key for job in distinct(whole, (i, 3))] for i in (1, 2, 3)]
    assert sorted(itertools.chain(*shares)) == sorted(job.key for job in distinct(whole))
    assert [*map(len, shares)] == [4, 4, 3]


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        ({"vary": {"input": "a.png", "widths": [1]}}, "widths"),
        ({"vary": {"width": [1]}}, "no inputs"),
        ({"vary": {"input": []}}, "no values"),
        ({"vary": {"input": {"glob": "*.dxf"}}}, r"'\*\.dxf'"),
        ({"vary": {"input": "a.png", "width": {"linspace": [1, 2]}}}, "linspace"),
        ({"vary": {"input": "a.png", "width": {"linspace": [1, 2, 0]}}}, "equal parts"),
        ({"vary": {"input": "a.png", "width": {"range": [1, 2, 0]}}}, "never gets"),
        ({"vary": {"input": "a.png", "width": {"range": [1, 2, -1]}}}, "never gets"),
        ({"vary": {"input": "a.png", "width": {"range": [1, 2, "1kPa"]}}}, "unit"),
        ({"vary": {"input": "a.png", "width": {"linspace": ["1mm", "2cm", 3]}}}, "one unit"),
        ({"vary": {"input": "a.png", "width": {"linspace": ["1kPa", "2kPa", 3]}}}, "not a length"),
        ({"vary": {"input": "a.png", "material": {"linspace": [1, 2, 3]}}}, "no number"),
        ({"vary": {"input": "a.png", "width": {"between": [1, 2]}}}, "samples"),
        ({"vary": {"input": "a.png"}, "sample": {"kind": "best", "rows": 3}}, "best"),
        ({"vary": {"input": "a.png"}, "sample": {"kind": "random", "rows": "3"}}, "whole number"),
        ({"vary": {"input": "a.png"}, "sample": 5}, "sample"),
        ({"vary": {"input": "a.png"}, "rows": []}, "either"),
        ({"vary": {"input": "a.png"}, "keep": "all"}, "kept"),
        ({"vary": {"input": "a.png", "--input": "b.png"}}, "twice"),
        ({"vari": {}}, "vari"),
        ({"rows": []}, "no (rows|inputs)"),
        ([1], "JSON object"),
    ],
)
def test_what_a_study_cannot_be_is_told(place: Path, data: Any, sentence: str) -> None:
    (place / "s.json").write_text(json.dumps(data))
    with pytest.raises(InputError, match=sentence):
        read_study(place / "s.json")


@pytest.mark.parametrize("content", [b"\xff\xfe", b"", b"{", b"[" * 100_000, b'{"vary": {"width": 1e999}}'])
@pytest.mark.parametrize("name", ["s.json", "s.csv"])
def test_a_file_that_is_none_is_told(place: Path, content: bytes, name: str) -> None:
    (place / name).write_bytes(content)
    with pytest.raises(InputError):
        read_study(place / name)


def test_ten_million_rows_are_refused_before_they_are_there(place: Path) -> None:
    axis = {"linspace": [1, 2, 3200]}
    with pytest.raises(InputError, match="10240000 rows"):
        study(place, vary={"input": "a.png", "width": axis, "height": axis})
    with pytest.raises(InputError, match="10000000 rows"):
        study(place, vary={"input": "a.png"}, sample={"kind": "random", "rows": 10_000_000})
    with pytest.raises(InputError, match="rows, more than 3"):
        read_study_of(place, "input\n" + "a.png\n" * 4, most=3)


def read_study_of(place: Path, text: str, most: int) -> Study:
    (place / "s.csv").write_text(text)
    return read_study(place / "s.csv", most)


def test_rows_are_there_only_while_they_are_looked_at(place: Path) -> None:
    axis = {"linspace": [0.1, 0.2, 100]}
    large = study(place, fixed={"input": "a.png"}, vary={"width": axis, "height": axis, "mesh-size": axis})
    assert len(large.rows) == 1_000_000
    tracemalloc.start()
    try:
        keys = {row.key for row in itertools.islice(planned(large), 500)}
        assert tracemalloc.get_traced_memory()[1] < 5e6
    finally:
        tracemalloc.stop()
    assert len(keys) == 500


def test_a_senseless_row_is_a_row(place: Path) -> None:
    rows = [*planned(table(place, "input,width\na.png,1\nnone.png,1\n,1\na.png,x\na.png,1,2\nb.png,1\n"))]
    assert [bool(row.job) for row in rows] == [True, False, False, False, False, True]
    words = ["There is no file", "no input", "'x'", "more cells"]
    assert all(word in row.sentence for word, row in zip(words, rows[1:5], strict=True))
