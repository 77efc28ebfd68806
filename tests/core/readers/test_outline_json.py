# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines written out as points in JSON, good and bad, and what holds for every drawing file."""

import json

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.readers import vector


def read_vector(path, *size):
    """The largest shape of a drawing."""
    return vector.read_vector(path, *size).largest


def points(folder, text):
    path = folder / "drawing.json"
    path.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
    return path


TRIANGLE = [[0, 0], [300, 0], [150, 200]]


@pytest.mark.parametrize(("unit", "metres"), [("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254)])
def test_json_units(unit, metres, tmp_path):
    found = read_vector(
        points(tmp_path, {"unit": unit, "outer": TRIANGLE, "holes": [[[140, 50], [160, 50], [150, 70]]]})
    )
    assert found.size == pytest.approx((300 * metres, 200 * metres))
    assert found.area == pytest.approx((30_000 - 200) * metres**2)


def test_json_comes_back_as_written(tmp_path):
    loop = np.random.default_rng(7).uniform(0.9, 1, 40) * np.exp(2j * np.pi * np.arange(40) / 40)
    loop = np.column_stack([loop.real, loop.imag])
    found = read_vector(points(tmp_path, {"unit": "m", "outer": loop.tolist()}))
    assert np.array_equal(found.outer, loop)
    assert read_vector(points(tmp_path, {"outer": TRIANGLE})).notes[0].endswith("millimetres are assumed.")


def test_repeated_json_points_are_dropped(tmp_path):
    found = read_vector(
        points(tmp_path, {"unit": "mm", "outer": [p for p in TRIANGLE for _ in range(3)] + TRIANGLE[:1]})
    )
    assert np.array_equal(found.outer * 1e3, TRIANGLE)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"unit": "mm", "outer": [[0, 0], [NaN, 0], [1, 1]]}', "NaN is not a coordinate"),
        ('{"unit": "mm", "outer": [[0, 0], [1' + "0" * 400 + ", 0], [1, 1]]}", "Point 2"),
        ('{"unit": "mm", "outer": [[0, 0], [-Infinity, 0], [1, 1]]}', "Infinity is not a coordinate"),
        ('{"unit": "mm", "outer": [[0, 0], [1e999, 0], [1, 1]]}', "Point 2 .*pair of numbers"),
        ('{"unit": "mm", "outer": [[0, 0], ["1", 0], [1, 1]]}', "Point 2"),
        ('{"unit": "mm", "outer": [[0, 0], [true, 0], [1, 1]]}', "Point 2"),
        ('{"unit": "mm", "outer": [[0, 0], [1, 0, 0], [1, 1]]}', "Point 2"),
        ('{"unit": "mm", "outer": [[0, 0], [1, 0]]}', "at least three points"),
        ('{"unit": "mm", "outer": 5}', "at least three points"),
        ('{"unit": "mm", "holes": []}', "no 'outer' loop"),
        ('{"unit": "furlong", "outer": [[0, 0], [1, 0], [1, 1]]}', "unknown unit 'furlong'"),
        ('{"unit": ["mm"], "outer": [[0, 0], [1, 0], [1, 1]]}', "unknown unit"),
        ('{"unit": "mm", "outer": [[0, 0], [9, 0], [9, 9]], "holes": [[[1, 1]]]}', "hole 1 needs"),
        ('{"unit": "mm", "outer": [[0, 0], [9, 0], [9, 9]], "holes": {}}', "not a list of loops"),
        ('{"unit": "mm", "outer": [[0, 0], [9, 9], [9, 0], [0, 9]]}', r"itself at \(4\.5, 4\.5\) mm"),
        ('{"unit": "mm", "outer": [[0, 0], [9, 0], [5, 0]]}', "no area"),
        ('{"outer": ', "cannot be read"),
        ('{"outer": ' + "[" * 100_000, "cannot be read"),
    ],
)
def test_bad_json_is_refused(text, message, tmp_path):
    with pytest.raises(InputError, match=message):
        read_vector(points(tmp_path, text))


def test_files_too_large_empty_or_missing_are_refused(tmp_path, monkeypatch):
    path = points(tmp_path, {"outer": TRIANGLE})
    with pytest.raises(InputError, match="no file"):
        read_vector(tmp_path / "nothing.svg")
    (tmp_path / "empty.svg").touch()
    with pytest.raises(InputError, match="is empty"):
        read_vector(tmp_path / "empty.svg")
    monkeypatch.setattr(vector, "_MOST_BYTES", 10)
    with pytest.raises(InputError, match="larger than"):
        read_vector(path)


def test_a_drawing_is_scaled_when_asked(tmp_path):
    path = points(tmp_path, {"unit": "mm", "outer": TRIANGLE})
    assert read_vector(path, 0.6).size == pytest.approx((0.6, 0.4))
    assert read_vector(path, 0.6, 0.2).size == pytest.approx((0.3, 0.2))
    for width in (0.0, -1.0, 1e5):
        with pytest.raises(InputError, match="between 1 mm and 100 m"):
            read_vector(path, width)


def test_json_with_several_shapes(tmp_path):
    square = [[400, 0], [500, 0], [500, 100], [400, 100]]
    hole = [[440, 40], [460, 40], [450, 60]]
    path = points(tmp_path, {"parts": [{"outer": square, "holes": [hole]}, {"outer": TRIANGLE}]})
    found = vector.read_vector(path, 1.0)
    assert [part.area for part in found.parts] == pytest.approx([4 * 0.03, 4 * 0.0098])
    assert found.size == pytest.approx((1.0, 0.4))
    assert [len(part.holes) for part in found.parts] == [0, 1]


def test_json_shapes_that_meet_are_refused(tmp_path):
    other = [[280, -10], [320, -10], [320, 30]]
    with pytest.raises(InputError, match=r"Two shapes meet at"):
        vector.read_vector(points(tmp_path, {"unit": "mm", "parts": [{"outer": TRIANGLE}, {"outer": other}]}))


@pytest.mark.parametrize("parts", [[], {}, [[0, 0]], [{"holes": []}]])
def test_senseless_parts_are_refused(parts, tmp_path):
    with pytest.raises(InputError, match="JSON file"):
        vector.read_vector(points(tmp_path, {"unit": "mm", "parts": parts}))
