# SPDX-License-Identifier: LGPL-2.1-or-later
"""Valid files with much of what DXF, SVG, JSON and pictures can have: what the broken ones begin as."""

from __future__ import annotations

import io
import json
import math
from functools import lru_cache

import cv2
import ezdxf
import numpy as np

VERSIONS = ("R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018")


@lru_cache(maxsize=1)
def seeds() -> list[tuple[str, bytes]]:
    """Ending and content of each; the same each time."""
    drawings = [(version, binary) for version in VERSIONS for binary in (False, True)]
    return [
        *(("dxf", dxf(version, kind, binary)) for version, binary in drawings for kind in (0, 1)),
        *(("svg", text.encode()) for text in _SVG),
        *(("json", json.dumps(text).encode()) for text in _JSON),
        *_pictures(),
    ]


def dxf(version: str, kind: int, binary: bool = False) -> bytes:
    """Loops, holes and welds (0), or with them what is drawn in other ways (1)."""
    document = ezdxf.new(version)
    document.header["$INSUNITS"] = 4
    space = document.modelspace()
    space.add_polyline2d([(0, 0, 0.3), (100, 0, 0), (100, 60, -0.2), (0, 60, 0)], format="xyb", close=True)
    space.add_circle((30, 30), 8)
    document.layers.add("weld")
    space.add_line((50, 20), (70, 20), dxfattribs={"layer": "weld"})
    space.add_point((80, 40), dxfattribs={"layer": "weld"})
    leaf = document.blocks.new("LEAF")
    leaf.add_circle((0, 0), 3)
    leaf.add_arc((0, 0), 5, 20, 90)
    branch = document.blocks.new("BRANCH")
    branch.add_blockref("LEAF", (1, 2), {"xscale": 2, "yscale": 1, "rotation": 30})
    space.add_blockref("BRANCH", (150, 30), {"rotation": 20})
    space.add_blockref(
        "LEAF", (200, 0), {"row_count": 2, "column_count": 2, "row_spacing": 20, "column_spacing": 20}
    )
    if kind:
        _more(document, space)
    if binary:
        stream = io.BytesIO()
        document.write(stream, fmt="bin")
        return stream.getvalue()
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode(document.output_encoding, "dxfreplace")


def _more(document, space) -> None:
    space.add_text("Hello")
    space.add_polyline3d([(0, 100, 3), (10, 100, 3), (10, 110, 3)], close=True)
    space.add_linear_dim(base=(0, -20), p1=(0, 0), p2=(100, 0)).render()
    space.add_solid([(0, 120), (5, 120), (0, 125)])
    if document.dxfversion == "AC1009":
        return
    space.add_lwpolyline([(0, 200, 0.5), (50, 200, 0), (50, 230, 0)], format="xyb", close=True)
    space.add_ellipse((80, 215), (20, 0), 0.4)
    space.add_open_spline([(0, 300), (0, 340), (60, 340), (60, 300)])
    space.add_rational_spline([(80, 300), (80, 340), (120, 340), (120, 300)], [1, 2, 0.5, 1])
    space.add_spline([(150, 300), (160, 330), (190, 310)])
    space.add_mtext("Several\nlines")
    space.add_3dface([(0, 400, 0), (10, 400, 5), (10, 410, 0), (0, 410, 0)])
    space.add_mline([(0, 500), (50, 500), (50, 520)])
    hatch = space.add_hatch()
    hatch.set_pattern_fill("ANSI31", scale=0.5)
    hatch.paths.add_polyline_path([(0, 600), (10, 600), (10, 610)], is_closed=True)
    edges = hatch.paths.add_edge_path()
    edges.add_arc((30, 600), 10, 0, 180)
    edges.add_line((20, 600), (40, 600))


_HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
_SVG = (
    f'{_HEAD}width="100mm" height="80mm" viewBox="0 0 100 80"><title>A fish</title>'
    '<g id="layer1" transform="translate(5,5) rotate(10)"><path style="fill:#f00" '
    'd="M10,10 C20,0 40,0 50,10 S80,20 70,40 Q40,70 20,50 T10,30 z M25,20 a5,5 0 1,0 10,0 5 5 0 1 0 -10 0z"/>'
    '<circle id="weld" cx="50" cy="30" r="2"/></g></svg>',
    f'{_HEAD}width="200" height="160"><style>/* plain */ .a {{ fill: none; stroke: black }} rect, #b '
    '{ fill: blue }</style><defs><clipPath id="c"><rect width="90" height="70"/></clipPath>'
    '<linearGradient id="g"><stop offset="0" stop-color="red"/></linearGradient><symbol id="s">'
    '<rect width="20" height="10" rx="3"/></symbol>'
    '</defs><rect x="10" y="10" width="100" height="90" rx="8" fill="url(#g)" clip-path="url(#c)"/>'
    '<use xlink:href="#s" x="30" y="40" transform="scale(1.5) skewX(5)"/><ellipse class="a" cx="80" cy="70" '
    'rx="12" ry="6" transform="rotate(20 80 70)"/><polyline class="a" points="120,10 150,10 150,40"/></svg>',
    f'{_HEAD}viewBox="0 0 300 300"><g><g opacity=".5"><polygon points="0,0 200,0 200,150 100,250 0,150"/></g>'
    '<polygon points="50,50 90,50 70,90"/><line x1="5" x2="9" y1="5" y2="9"/><text x="9">Aa</text></g></svg>',
)
_CIRCLE = [[round(100 * math.cos(0.1 * k), 3), round(100 * math.sin(0.1 * k), 3)] for k in range(62)]
_JSON = (
    {
        "unit": "mm",
        "outer": _CIRCLE,
        "holes": [[[10, 10], [20, 10], [15, 20]]],
        "welds": [[[-50, 0], [-20, 0]]],
    },
    {"parts": [{"outer": [[0, 0], [300, 0], [150, 200]]}, {"outer": [[400, 0], [500, 0], [500, 90]]}]},
)


def _pictures() -> list[tuple[str, bytes]]:
    """A disc and a bar in 8 and 16 bits, grey, with colours, a palette and transparency, also interlaced."""
    from PIL import Image

    y, x = np.mgrid[:90, :120]
    inside = ((x - 60) ** 2 + (y - 45) ** 2 < 30**2) | ((abs(y - 45) < 6) & (abs(x - 60) < 50))
    grey = np.where(inside, 40, 250).astype(np.uint8)
    colours = np.dstack([grey, grey // 2 + 100, grey])
    clear = np.dstack([colours, np.where(inside, 255, 0).astype(np.uint8)])
    arrays = [grey, colours, clear, grey.astype(np.uint16) * 257, clear.astype(np.uint16) * 257]
    made = [("png", cv2.imencode(".png", array)[1].tobytes()) for array in arrays]
    made += [(kind, cv2.imencode(f".{kind}", colours)[1].tobytes()) for kind in ("jpg", "bmp", "webp")]
    for mode in ("P", "1", "LA"):
        stream = io.BytesIO()
        Image.fromarray(grey).convert(mode).save(stream, "PNG")
        made.append(("png", stream.getvalue()))
    stream = io.BytesIO()
    Image.fromarray(colours).save(stream, "JPEG", progressive=True)
    return [*made, ("jpg", stream.getvalue())]
