# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of seams as JSON: what is written is read again, and what is none is one sentence."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.outline.budget import Budget
from BalloonWorkbench.core.seam_edits.edit import CUT, LINE, MERGE, NEAR, SeamEdit, no_direction
from BalloonWorkbench.core.seam_edits.read_seams import edit_text, edits_in, edits_of, read_seams


@pytest.mark.parametrize(
    "edit",
    [
        SeamEdit(
            CUT,
            np.array([[0.1, -0.2, 0.3], [0.0, 0.05, 0.0]]),
            no_direction(),
            ("3", "Face 7"),
            (1.0, 2.0, 0.5),
        ),
        SeamEdit(LINE, np.eye(3), np.array([0.0, 0.6, 0.8]), side=NEAR),
        SeamEdit(MERGE, np.zeros((0, 3)), no_direction(), ("a", "b"), mirrored=False),
    ],
    ids=["cut", "line", "merge"],
)
def test_what_is_written_is_read_again(edit: SeamEdit) -> None:
    (again,) = edits_of([edit_text(edit)])
    np.testing.assert_allclose(again.points, edit.points, atol=1e-9)
    np.testing.assert_allclose(again.direction, edit.direction, atol=1e-9)
    for name in ("kind", "panels", "side", "mirrored"):
        assert getattr(again, name) == getattr(edit, name)
    assert again.size == pytest.approx(edit.size)


def test_units() -> None:
    text = {"unit": "in", "seams": [{"do": "cut", "at": [[1, 0, 0], [0, 2, 0]]}]}
    (edit,) = read_seams(json.dumps(text).encode(), Budget())
    np.testing.assert_allclose(edit.points, [[0.0254, 0.0, 0.0], [0.0, 0.0508, 0.0]])


@pytest.mark.parametrize(
    "seams",
    [
        "{",
        "[]",
        '{"seams": 3}',
        '{"seams": [3]}',
        '{"seams": [{"do": "glue"}]}',
        '{"seams": [{"do": "cut", "at": 3}]}',
        '{"seams": [{"do": "cut", "at": [[0, 0]]}]}',
        '{"seams": [{"do": "cut", "at": [[0, 0, NaN]]}]}',
        '{"seams": [{"do": "cut", "at": [[0, 0, true]]}]}',
        '{"seams": [{"do": "cut", "at": [[0, 0, 1' + 400 * "0" + "]]}]}",
        '{"seams": [{"do": "cut", "where": []}]}',
        '{"seams": [{"do": "merge", "panels": [1, 2]}]}',
        '{"seams": [{"do": "line", "side": "far"}]}',
        '{"seams": [{"do": "line", "along": [0, 1]}]}',
        '{"seams": [{"do": "merge", "mirrored": "no"}]}',
        '{"unit": "ell", "seams": []}',
        '{"seams": ' + 3000 * "[" + 3000 * "]" + "}",
    ],
)
def test_what_is_no_edit_is_one_sentence(seams: str) -> None:
    with pytest.raises(InputError) as caught:
        read_seams(seams.encode(), Budget())
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 1000


def test_files(tmp_path: Path) -> None:
    assert edits_in(None) == ()
    with pytest.raises(InputError, match="There is no file"):
        edits_in(str(tmp_path / "no.json"))
