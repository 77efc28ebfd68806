# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small files that want to become a lot, and large ones that people have: each by name."""

from __future__ import annotations

import io
import json
import math
import random
from collections.abc import Callable

import numpy as np

_HEAD = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 500">'
_SQUARE = '<rect width="50" height="50"/>'


def _dxf(draw: Callable, version: str = "R2010") -> tuple[str, bytes]:
    import ezdxf

    document = ezdxf.new(version)
    document.header["$INSUNITS"] = 4
    document.modelspace().add_circle((0, 0), 50)
    draw(document.modelspace())
    text = io.StringIO()
    document.write(text)
    return "dxf", text.getvalue().encode()


def _svg(body: str) -> tuple[str, bytes]:
    return "svg", f"{_HEAD}{body}</svg>".encode()


def _far_spline(space) -> None:
    draw = random.Random(1)
    space.add_open_spline([(draw.uniform(-1e12, 1e12), draw.uniform(-1e12, 1e12)) for _ in range(60)])


def _nested(space, empty: bool = True, skew: bool = False) -> None:
    blocks = space.doc.blocks
    first = blocks.new("B0")
    if not empty:
        first.add_circle((0, 0), 1)
    scales = {"xscale": 2, "yscale": 1, "rotation": 30} if skew else {}
    for level in range(1, 10):
        block = blocks.new(f"B{level}")
        for k in range(10):
            block.add_blockref(f"B{level - 1}", (k, 0), scales)
    space.add_blockref("B9", (0, 0))


def _inside_itself(space) -> None:
    block = space.doc.blocks.new("B")
    block.add_blockref("B", (1, 0), {"xscale": 2, "rotation": 30})
    space.add_blockref("B", (0, 0))


def _rows(space) -> None:
    space.doc.blocks.new("B")
    insert = space.add_blockref("B", (0, 0))
    insert.dxf.row_count, insert.dxf.column_count = 9999, 9999
    insert.dxf.row_spacing, insert.dxf.column_spacing = 1, 1


def _holes(count: int) -> tuple[str, bytes]:
    columns = 100
    holes = [
        [[1 + 3 * (k % columns), 1 + 3 * (k // columns)], [3 + 3 * (k % columns), 1 + 3 * (k // columns)],
         [2 + 3 * (k % columns), 3 + 3 * (k // columns)]] for k in range(count)
    ]  # fmt: skip
    height = 3 * (count // columns) + 2
    outer = [[0, 0], [302, 0], [302, height], [0, height]]
    return "json", json.dumps({"unit": "mm", "outer": outer, "holes": holes}).encode()


def _rings(count: int) -> tuple[str, bytes]:
    """Circles around each other."""
    turn = 2 * math.pi * np.arange(100) / 100
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    loops = [(ring * (10 + k)).round(4).tolist() for k in range(count)]
    text = "".join("M" + " ".join(f"{x},{y}" for x, y in loop) + "z" for loop in loops)
    return _svg(f'<path d="{text}"/>')


def _deep_picture() -> tuple[str, bytes]:
    """6000 x 6000 points of four times 16 bits, with a disc."""
    import cv2

    pixels = np.full((6000, 6000, 4), 65535, np.uint16)
    cv2.circle(pixels, (3000, 3000), 2000, (0, 0, 40_000, 65_535), -1)
    return "png", cv2.imencode(".png", pixels, [cv2.IMWRITE_PNG_COMPRESSION, 1])[1].tobytes()


def _grain() -> tuple[str, bytes]:
    import cv2

    noise = np.random.default_rng(3).integers(0, 2, (1600, 1600), dtype=np.uint8) * 255
    noise[:40], noise[-40:], noise[:, :40], noise[:, -40:] = 255, 255, 255, 255
    return "png", cv2.imencode(".png", noise)[1].tobytes()


def _two_deep(count: int) -> str:
    group = '<g transform="rotate(0) translate(0 0)">'
    return group * 150 + _SQUARE * count + "</g>" * 150


#: Each file by its name.
FILES: dict[str, Callable[[], tuple[str, bytes]]] = {
    "spline at 1e12": lambda: _dxf(_far_spline),
    "nested empty blocks": lambda: _dxf(_nested),
    "nested skew blocks": lambda: _dxf(lambda space: _nested(space, skew=True)),
    "nested full blocks": lambda: _dxf(lambda space: _nested(space, empty=False)),
    "block in itself": lambda: _dxf(_inside_itself),
    "rows and columns": lambda: _dxf(_rows),
    "through many points": lambda: _dxf(lambda space: space.add_spline([(k, k % 7) for k in range(9000)])),
    "tags without end": lambda: ("dxf", b"0\nSECTION\n2\nENTITIES\n" + b"0\nLINE\n8\n0\n10\n1\n" * 900_000),
    "circles": lambda: _svg("".join(f'<circle cx="{k}" cy="9" r="9e9"/>' for k in range(2500))),
    "blanks of a style": lambda: _svg(f"<style>a{' ' * 6000}b</style>{_SQUARE}"),
    "style without rules": lambda: _svg(f"<style>{'a{}' * 100_000}{'/*' * 100_000}</style>{_SQUARE}"),
    "style of many": lambda: _svg(f"<style>rect{{{'fill:red;' * 9000}}}</style>{_SQUARE * 5000}"),
    "blanks of a transform": lambda: _svg(f'<g transform="{"rotate " * 2000}{" " * 90_000}">{_SQUARE}</g>'),
    "digits": lambda: _svg(f'<path d="M0 0L{"1" * 300_000} 5"/>'),
    "deep transforms": lambda: _svg(_two_deep(20_000)),
    "tiny subpaths": lambda: _svg(
        '<path d="' + "".join(f"M{k % 500} {k // 500}h.5v.5z" for k in range(200_000)) + '"/>'
    ),
    "many rectangles": lambda: _svg(
        "".join(f'<rect x="{k % 300 * 3}" y="{k // 300 * 3}" width="2" height="2"/>' for k in range(90_000))
    ),
    "attributes": lambda: _svg("<g " + " ".join(f'a{k}=""' for k in range(1_200_000)) + "/>"),
    "rings": lambda: _rings(200),
    "8000 holes": lambda: _holes(8000),
    "lists of nothing": lambda: ("json", b'{"outer": [' + b"[]," * 9_000_000 + b"[]]}"),
    "large photograph": _deep_picture,
    "grain": _grain,
}
