# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are told apart by what is in them."""

import json
import shutil

import drawn_pictures as pictures
import ezdxf
import pytest

from BalloonWorkbench.core.errors import BalloonError, InputError
from BalloonWorkbench.core.readers.read import read_outline

SVG = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm"><rect width="40mm" height="20mm"/></svg>"""


def files(folder):
    shutil.copy(pictures.EXAMPLES[0], folder / "picture")
    (folder / "svg").write_text(SVG, encoding="utf-8-sig")
    (folder / "json").write_text(json.dumps({"unit": "cm", "outer": [[0, 0], [4, 0], [4, 2], [0, 2]]}))
    document = ezdxf.new()
    document.header["$INSUNITS"] = 4
    document.modelspace().add_lwpolyline([(0, 0), (40, 0), (40, 20), (0, 20)], close=True)
    document.saveas(folder / "dxf")


@pytest.mark.parametrize("suffix", ["", ".txt", ".png", ".dxf", ".SVG"])
@pytest.mark.parametrize("kind", ["picture", "svg", "json", "dxf"])
def test_the_content_says_what_a_file_is(kind, suffix, tmp_path):
    files(tmp_path)
    path = (tmp_path / kind).rename(tmp_path / f"drawing of {kind}{suffix}")
    outline, found = read_outline(path, 0.08)
    assert found == kind
    assert outline.size[0] == pytest.approx(0.08)
    if kind != "picture":
        outline, _ = read_outline(path)
        assert outline.size == pytest.approx((0.04, 0.02), rel=1e-5)
        assert outline.area == pytest.approx(8e-4, rel=1e-5)


def test_a_decoder_is_used_for_pictures(tmp_path):
    files(tmp_path)
    seen = []

    def decode(path):
        seen.append(path)
        return pictures.coloured(pictures.drawn(pictures.disc(50, 50, 30), 100, 100))

    outline, kind = read_outline(tmp_path / "picture", None, 0.1, decode)
    assert kind == "picture"
    assert seen == [tmp_path / "picture"]
    assert outline.area == pytest.approx(3.1416 * 0.05**2, rel=0.01)


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("empty.png", b"", "is empty"),
        ("letter.txt", b"Dear grandmother", "not a drawing"),
        ("letter.png", b"Dear grandmother", "not a picture"),
        ("letter.svg", b"Dear grandmother", "damaged"),
        ("letter.dxf", b"Dear grandmother", "not a DXF"),
        ("letter.json", b"Dear grandmother", "cannot be read"),
        ("archive", bytes(range(256)), "not a drawing"),
    ],
)
def test_other_files_are_refused(name, data, message, tmp_path):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(InputError, match=message):
        read_outline(path, 0.3)


def test_missing_files_and_folders_are_refused(tmp_path):
    with pytest.raises(InputError, match="no file"):
        read_outline(tmp_path / "nothing.png", 0.3)
    with pytest.raises(InputError, match="cannot be read"):
        read_outline(tmp_path, 0.3)


def test_no_file_cut_short_does_more_than_complain(tmp_path):
    files(tmp_path)
    for kind in ("picture", "svg", "json", "dxf"):
        whole = (tmp_path / kind).read_bytes()
        for part in range(1, 20):
            path = tmp_path / "cut"
            path.write_bytes(whole[: len(whole) * part // 20])
            try:
                outline, _ = read_outline(path, 0.08)
            except BalloonError as error:
                assert "\n" not in str(error)
            else:
                assert outline.size[0] == pytest.approx(0.08)
