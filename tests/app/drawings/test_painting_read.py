# SPDX-License-Identifier: LGPL-2.1-or-later
"""A painting is read as any picture, but who painted a closed line is not told that it was a pen's."""

import struct
import sys
import zlib
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2] / "core"))

from drawn_pictures import coloured, drawn, png, ring

from BalloonWorkbench.app.drawings.drawing_file import KEY, is_painting, read_drawing
from BalloonWorkbench.core.tracing.segment import AS_PEN


def with_strokes(content):
    """A PNG with a text in it, as the paint window writes it."""
    body = b"tEXt" + KEY.encode() + b"\0strokes"
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    head = content.index(b"IDAT") - 4
    return content[:head] + chunk + content[head:]


def test_a_painted_line_is_not_said_to_be_a_pen_drawing(tmp_path):
    content = png(coloured(drawn(ring(100, 100, 80, 75), 200, 200)))
    found = []
    for name, each in (("picture.png", content), ("painting.png", with_strokes(content))):
        (tmp_path / name).write_bytes(each)
        drawing, _ = read_drawing(str(tmp_path / name), 200.0, 0.0)
        found.append(drawing.parts[0])
    assert not is_painting(tmp_path / "picture.png")
    assert is_painting(tmp_path / "painting.png")
    assert AS_PEN in found[0].notes
    assert AS_PEN not in found[1].notes
    assert (found[0].outer == found[1].outer).all()
