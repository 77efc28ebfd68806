# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that nobody should be able to stumble over: damaged, hostile or merely odd. Each number gives one."""

from __future__ import annotations

import json
import math
import random
import struct
import zlib
from collections.abc import Callable

_HEADS = {
    "png": b"\x89PNG\r\n\x1a\n",
    "jpg": b"\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01",
    "bmp": b"BM",
    "webp": b"RIFF\x40\x00\x00\x00WEBPVP8 ",
    "svg": b'<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg">',
    "dxf": b"0\nSECTION\n2\nENTITIES\n",
    "json": b'{"unit": "mm", "outer": [',
}
_NUMBERS = (
    *("0", "-0", "1", "-1", "50", "1e-9", "1e9", "1e30", "1e308", "1e309", "-1e308", "5e-324", "nan", "inf"),
    *("", " ", "--1", "1e", "0x10", "１２", "1,5", "99999999999999999999999999", "1" * 400, "50%", "2em"),
)


def file(number: int) -> tuple[str, bytes]:
    """The ending and the content of one of these files; the same for the same number."""
    draw = random.Random(number)
    kind = _KINDS[number % len(_KINDS)]
    return kind(draw)


def _noise(draw: random.Random) -> tuple[str, bytes]:
    """Random bytes behind the head of a known kind; sometimes under another name."""
    kind = draw.choice(sorted(_HEADS))
    ending = kind if draw.random() < 0.8 else draw.choice([*sorted(_HEADS), "txt", ""])
    return ending, _HEADS[kind] + draw.randbytes(draw.choice((0, 1, 7, 60, 900, 20_000)))


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def _png(draw: random.Random) -> tuple[str, bytes]:
    """A small PNG whose head and content need not agree."""
    honest = draw.random() < 0.5
    sizes = (
        (0, 1, 2, 3, 40, 65, 200) if honest else (0, 1, 5, 3000, 9999, 10_001, 70_000, 2**31 - 1, 2**32 - 1)
    )
    width, height = draw.choice(sizes), draw.choice(sizes)
    depth, colour = (
        (8, draw.choice((0, 2, 4, 6))) if honest else (draw.choice((1, 4, 8, 16, 77)), draw.randrange(9))
    )
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(colour, 1)
    rows = min(height, 300)
    line = b"\0" + draw.choice((b"\0", b"\xff", draw.randbytes(1))) * min(width * channels, 4000)
    if honest and width > 20:
        lines = [
            b"\0" + b"".join(_dot(x, y, width, height) * channels for x in range(width))
            for y in range(height)
        ]
    else:
        lines = [line] * rows
    chunks = [
        _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, draw.choice((0, 0, 1)))),
        _chunk(b"IDAT", zlib.compress(b"".join(lines))),
        _chunk(b"IEND", b""),
    ]
    if draw.random() < 0.2:
        chunks.insert(draw.randrange(3), chunks[draw.randrange(3)])
    return "png", _HEADS["png"] + b"".join(chunks)


def _dot(x: int, y: int, width: int, height: int) -> bytes:
    return (
        b"\x20"
        if (x - width / 2) ** 2 + (y - height / 2) ** 2 < (0.35 * min(width, height)) ** 2
        else b"\xf0"
    )


def _bomb(draw: random.Random) -> tuple[str, bytes]:
    """Little that wants to become a lot."""
    deep = draw.choice((10, 900, 30_000))
    things = (
        ("png", _HEADS["png"] + _chunk(b"IHDR", struct.pack(">IIBBBBB", 50_000, 50_000, 8, 6, 0, 0, 0))
            + _chunk(b"IDAT", zlib.compress(b"\0" * 3_000_000)) + _chunk(b"IEND", b"")),
        ("svg", b"<svg>" + b"<g>" * deep + b"</g>" * deep + b"</svg>"),
        ("svg", b'<!DOCTYPE s [<!ENTITY a "aaaaaaaaaa">' + b"".join(
            b'<!ENTITY %c "%s">' % (98 + k, b"&%c;" % (97 + k) * 10) for k in range(9))
            + b"]><svg>&j;</svg>"),
        ("svg", b"<svg>" + b"".join(
            b'<g id="g%d">%s</g>' % (k, b'<use href="#g%d"/>' % (k - 1) * 10) for k in range(12))
            + b"</svg>"),
        ("svg", b'<svg><g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g></svg>'),
        ("svg", b'<svg><path d="M0 0' + b" L 1 1 5 9" * 20_000 + b'"/></svg>'),
        ("json", b"[" * deep),
        ("json", b'{"outer": ' + b"[" * deep + b"]" * deep + b"}"),
        ("json", b'{"outer": [' + b"[0, 0]," * 5_000 + b"[1, 1]]}"),
        ("json", b'{"outer": [[0, 0], [1' + b"0" * 5000 + b", 0], [0, 1]]}"),
        ("dxf", _dxf("LWPOLYLINE", [(90, "99999999"), *[(10, "1"), (20, "2")] * 3000])),
        ("dxf", _dxf("SPLINE", [(71, "3"), (72, "99999999"), (73, "99999999"), (74, "0"), (40, "1")])),
        ("dxf", b"  0\nSECTION\n  2\nBLOCKS\n  0\nBLOCK\n  2\nA\n 10\n0\n 20\n0\n"
            b"  0\nINSERT\n  2\nA\n 10\n0\n 20\n0\n"
            b"  0\nENDBLK\n  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n  0\nINSERT\n  2\nA\n 10\n0\n 20\n0\n"
            b" 70\n9999\n 71\n9999\n  0\nENDSEC\n  0\nEOF\n"),
    )  # fmt: skip
    return draw.choice(things)


def _number(draw: random.Random) -> str:
    return draw.choice(_NUMBERS) if draw.random() < 0.3 else f"{draw.uniform(-200, 200):.3f}"


def _svg(draw: random.Random) -> tuple[str, bytes]:
    """Elements and attributes as they may be, with numbers as they may not."""

    def numbers(count: int) -> str:
        return " ".join(_number(draw) for _ in range(count))

    def path() -> str:
        return " ".join(
            draw.choice("MmLlHhVvCcSsQqTtAaZzX") + numbers(draw.randrange(8))
            for _ in range(draw.randrange(1, 9))
        )

    def element() -> str:
        style = draw.choice(
            ("", 'fill="none"', 'style="display:none"', f'transform="{transform()}"', 'class="a"')
        )
        return draw.choice(
            (
                f'<path d="{path()}" {style}/>',
                f'<polygon points="{numbers(draw.randrange(12))}" {style}/>',
                f'<rect x="{numbers(1)}" width="{numbers(1)}" height="9" rx="{numbers(1)}" {style}/>',
                f'<circle cx="{numbers(1)}" cy="{numbers(1)}" r="{numbers(1)}" {style}/>',
                f'<ellipse rx="{numbers(1)}" ry="{numbers(1)}" {style}/>',
                f'<line x1="{numbers(1)}" x2="5" {style}/>',
                f'<g id="weld" {style}>{"<path/>" * draw.randrange(3)}<line x2="{numbers(1)}"/></g>',
                '<text x="1">Aa</text>',
                '<image href="file:///nothing.png"/>',
                f'<use href="#{draw.choice(("weld", "nothing", ""))}" x="{numbers(1)}"/>',
            )
        )

    def transform() -> str:
        name = draw.choice(("translate", "scale", "rotate", "matrix", "skewX", "nonsense"))
        return f"{name}({numbers(draw.randrange(7))})"

    size = draw.choice(("", f'width="{numbers(1)}mm"', f'width="{numbers(1)}" height="9"', 'width="auto"'))
    box = draw.choice(("", f'viewBox="{numbers(4)}"', 'viewBox="0 0 100 100"'))
    body = "".join(element() for _ in range(draw.randrange(1, 7)))
    return "svg", _cut(draw, f'<svg xmlns="http://www.w3.org/2000/svg" {size} {box}>{body}</svg>'.encode())


def _dxf(entity: str, pairs: list[tuple[int, str]]) -> bytes:
    lines = "".join(f"{code:>3}\n{value}\n" for code, value in pairs)
    return f"  0\nSECTION\n  2\nENTITIES\n  0\n{entity}\n  8\n0\n{lines}  0\nENDSEC\n  0\nEOF\n".encode()


def _entities(draw: random.Random) -> tuple[str, bytes]:
    """A DXF entity with group codes and values at random."""
    kinds = (
        "LINE",
        "ARC",
        "CIRCLE",
        "ELLIPSE",
        "SPLINE",
        "LWPOLYLINE",
        "POLYLINE",
        "INSERT",
        "POINT",
        "HATCH",
    )
    codes = (
        10,
        20,
        30,
        11,
        21,
        40,
        41,
        42,
        50,
        51,
        62,
        70,
        71,
        72,
        73,
        74,
        90,
        210,
        220,
        230,
        8,
        999,
        -5,
        1071,
    )
    pairs = [(draw.choice(codes), _number(draw)) for _ in range(draw.randrange(30))]
    return "dxf", _cut(draw, _dxf(draw.choice(kinds), pairs))


def _value(draw: random.Random, depth: int = 0) -> object:
    """Anything that JSON can hold."""
    plain: tuple[object, ...] = (
        *(
            None,
            True,
            0,
            -1,
            1.5,
            1e300,
            10**40,
            10**400,
            "mm",
            "",
            "ü☺",
            [],
            {},
            [0, 0],
            [[0, 0], [9, 0], [0, 9]],
        ),
        *(
            draw.uniform(-99, 99),
            [[draw.uniform(-99, 99), draw.uniform(-99, 99)] for _ in range(draw.randrange(9))],
        ),
    )
    if depth > 2 or draw.random() < 0.6:
        return draw.choice(plain)
    if draw.random() < 0.5:
        return [_value(draw, depth + 1) for _ in range(draw.randrange(4))]
    names = ("unit", "outer", "holes", "welds", "parts", "x")
    return {draw.choice(names): _value(draw, depth + 1) for _ in range(draw.randrange(4))}


def _points(draw: random.Random) -> tuple[str, bytes]:
    """An outline in JSON, nearly right."""
    count = draw.randrange(3, 12)
    size = draw.choice((1e-6, 1e-2, 1.0, 100.0, 100.0, 100.0, 1e6, 1e150))
    outer: list[object] = [
        [size * math.cos(6.283 * k / count) * draw.uniform(0.3, 1), size * math.sin(6.283 * k / count)]
        for k in range(count)
    ]
    text: dict[str, object] = {"unit": "mm", "outer": outer}
    for name in ("unit", "holes", "welds", "parts", "outer"):
        if draw.random() < 0.2:
            text[name] = _value(draw)
    if draw.random() < 0.3:
        outer[draw.randrange(count)] = _value(draw)
    return "json", _cut(draw, json.dumps(text, ensure_ascii=draw.random() < 0.5).encode())


def _cut(draw: random.Random, content: bytes) -> bytes:
    """The content, now and then shortened, or with a byte changed."""
    chance, at = draw.random(), draw.randrange(len(content))
    if chance < 0.1:
        return content[:at]
    return content[:at] + draw.randbytes(1) + content[at + 1 :] if chance < 0.2 else content


_KINDS: tuple[Callable[[random.Random], tuple[str, bytes]], ...] = (
    *(_noise, _png, _svg, _entities, _points, _bomb, _svg, _points, _entities, _png),
)
