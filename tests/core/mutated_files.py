# SPDX-License-Identifier: LGPL-2.1-or-later
"""Valid files that something happened to: cut short, bits turned, numbers exchanged, parts repeated."""

from __future__ import annotations

import random
import re
import struct
import zlib
from collections.abc import Callable

from valid_files import seeds

_EXTREMES = (
    *("0", "-0", "1", "-1", "0.5", "3", "1e-9", "1e6", "1e9", "1e12", "-1e12", "1e30", "1e308", "-1e308"),
    *("1e309", "5e-324", "nan", "inf", "-inf", "", "99999999", "-99999999", "2147483648", "x", "1" * 60),
)
_NUMBER = re.compile(rb"(?<![\w#.])-?\d+\.?\d*(?:[eE][-+]?\d+)?")
_ATTRIBUTE = re.compile(rb'([\w:]+)="([^"]*)"')
_ELEMENT = re.compile(rb"<(?:path|rect|circle|ellipse|polygon|polyline|use|line)\b[^>]*/>")


def file(number: int) -> tuple[str, bytes]:
    """The ending and the content of one of these files; the same for the same number."""
    draw = random.Random(f"mutated {number}")
    ending, content = seeds()[number % len(seeds())]
    for _ in range(draw.choice((1, 1, 1, 2, 4))):
        if content:
            content = draw.choice(_changes(ending, content))(draw, content)
    return ending, content


def _changes(ending: str, content: bytes) -> list[Callable[[random.Random, bytes], bytes]]:
    own = {
        "dxf": [_dxf_values, _dxf_values, _dxf_repeat, _dxf_names],
        "svg": [_svg_values, _svg_values, _svg_repeat],
    }
    if content.startswith(b"AutoCAD Binary"):
        return [_cut, _turn, _repeat, _drop, _doubles, _doubles]
    if content.startswith(b"\x89PNG"):
        return [_cut, _turn, _repeat, _drop, _chunks, _chunks]
    plain = [_cut, _turn, _repeat, _drop, _swap]
    if ending in ("jpg", "bmp", "webp"):
        return [*plain, _turn]
    return [*plain, _numbers, *own.get(ending, [_numbers])]


def _span(draw: random.Random, content: bytes, most: int = 4000) -> tuple[int, int]:
    first = draw.randrange(len(content))
    return first, min(len(content), first + draw.randrange(1, most))


def _cut(draw: random.Random, content: bytes) -> bytes:
    return content[: draw.randrange(len(content))]


def _turn(draw: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    for _ in range(draw.choice((1, 3, 30))):
        changed[draw.randrange(len(changed))] ^= 1 << draw.randrange(8)
    return bytes(changed)


def _drop(draw: random.Random, content: bytes) -> bytes:
    first, last = _span(draw, content)
    return content[:first] + content[last:]


def _repeat(draw: random.Random, content: bytes) -> bytes:
    first, last = _span(draw, content)
    times = min(draw.choice((1, 10, 1000)), 1 + 400_000 // (last - first))
    return content[:last] + content[first:last] * times + content[last:]


def _swap(draw: random.Random, content: bytes) -> bytes:
    tokens = re.split(rb"(\s+)", content)
    for _ in range(draw.choice((1, 5))):
        one, other = draw.randrange(len(tokens)), draw.randrange(len(tokens))
        tokens[one], tokens[other] = tokens[other], tokens[one]
    return b"".join(tokens)


def _numbers(draw: random.Random, content: bytes) -> bytes:
    places = [match.span() for match in _NUMBER.finditer(content)]
    for first, last in sorted(draw.sample(places, min(len(places), draw.choice((1, 2, 10)))), reverse=True):
        content = content[:first] + draw.choice(_EXTREMES).encode() + content[last:]
    return content


def _doubles(draw: random.Random, content: bytes) -> bytes:
    """Numbers of eight bytes anywhere behind the head."""
    changed = bytearray(content)
    for _ in range(draw.choice((1, 3, 10))):
        at = draw.randrange(22, max(23, len(changed) - 8))
        number = draw.choice((0.0, 1e12, -1e308, float("nan"), float("inf"), 5e-324, 1e9))
        changed[at : at + 8] = struct.pack("<d", number)
    return bytes(changed)


def _entities(content: bytes) -> tuple[list[list[bytes]], int, int]:
    """Lines of a DXF file by twos, and where its blocks begin and its entities end."""
    lines = content.split(b"\n")
    pairs = [lines[k : k + 2] for k in range(0, len(lines) - 1, 2)]
    names = [pair[1].strip() for pair in pairs]
    first = names.index(b"BLOCKS") if b"BLOCKS" in names else 0
    last = names.index(b"OBJECTS") if b"OBJECTS" in names else len(names)
    return pairs, min(first, last - 1), max(last, 1)


def _dxf_values(draw: random.Random, content: bytes) -> bytes:
    """Values of blocks and entities, whatever they are for."""
    pairs, first, last = _entities(content)
    for _ in range(draw.choice((1, 2, 10))):
        if first < last <= len(pairs):
            pairs[draw.randrange(max(first, 0), last)][-1] = draw.choice(_EXTREMES).encode()
    return b"\n".join(line for pair in pairs for line in pair) + b"\n"


def _dxf_repeat(draw: random.Random, content: bytes) -> bytes:
    """An entity many times."""
    pairs, first, last = _entities(content)
    begins = [k for k in range(max(first, 0), min(last, len(pairs))) if pairs[k][0].strip() == b"0"]
    if len(begins) < 2:
        return content
    chosen = draw.randrange(len(begins) - 1)
    entity = pairs[begins[chosen] : begins[chosen + 1]] * draw.choice((1, 30, 1000))
    pairs[begins[chosen] : begins[chosen]] = entity[:40_000]
    return b"\n".join(line for pair in pairs for line in pair) + b"\n"


def _dxf_names(draw: random.Random, content: bytes) -> bytes:
    """A block inside itself or another one, and many copies of it."""
    pairs, first, last = _entities(content)
    for pair, following in zip(pairs[max(first, 0) : last], pairs[max(first, 0) + 1 : last]):
        if len(pair) == 2 and pair[0].strip() == b"2" and pair[1].strip() in (b"LEAF", b"BRANCH"):
            if draw.random() < 0.4:
                pair[1] = draw.choice((b"LEAF", b"BRANCH", b"nothing"))
            elif draw.random() < 0.3 and following[0].strip() == b"10":
                pair[1] += b"\n 70\n%d\n 71\n%d" % (draw.choice((3, 90, 9999)), draw.choice((3, 90, 9999)))
    return b"\n".join(line for pair in pairs for line in pair) + b"\n"


def _svg_values(draw: random.Random, content: bytes) -> bytes:
    """Values of attributes: numbers, or those of other attributes."""
    matches = list(_ATTRIBUTE.finditer(content))
    for match in sorted(
        draw.sample(matches, min(len(matches), draw.choice((1, 3)))), key=lambda m: -m.start()
    ):
        value = match[2]
        if draw.random() < 0.5:
            value = _NUMBER.sub(
                lambda m: draw.choice(_EXTREMES).encode() if draw.random() < 0.5 else m[0], value
            )
        else:
            value = draw.choice(
                (draw.choice(matches)[2], b" " * 6000, value * 50, b"url(#s)", b"#s", b"weld")
            )
        content = content[: match.start(2)] + value + content[match.end(2) :]
    return content


def _svg_repeat(draw: random.Random, content: bytes) -> bytes:
    """Elements many times, beside each other or around them."""
    elements = list(_ELEMENT.finditer(content))
    if not elements:
        return content
    match, times = draw.choice(elements), draw.choice((2, 50, 3000))
    inner = match[0] * times if draw.random() < 0.6 else b"<g>" * times + match[0] + b"</g>" * times
    return content[: match.start()] + inner + content[match.end() :]


def _chunks(draw: random.Random, content: bytes) -> bytes:
    """Chunks of a PNG changed, left out or repeated, with sums that agree."""
    chunks, at = [], 8
    while at + 12 <= len(content):
        (size,) = struct.unpack(">I", content[at : at + 4])
        chunks.append((content[at + 4 : at + 8], content[at + 8 : at + 8 + size]))
        at += 12 + size
    if not chunks:
        return content
    which = draw.randrange(len(chunks))
    kind, body = chunks[which]
    if kind == b"IHDR" and len(body) == 13 and draw.random() < 0.8:
        width, height, *rest = struct.unpack(">IIBBBBB", body)
        sizes = (1, 17, 5000, 9000, 70_000, 2**31 - 1)
        width, height = (draw.choice((now, draw.choice(sizes))) for now in (width, height))
        rest[draw.randrange(5)] = draw.choice((0, 1, 2, 3, 4, 6, 8, 16))
        chunks[which] = kind, struct.pack(">IIBBBBB", width, height, *rest)
    elif body and draw.random() < 0.7:
        chunks[which] = kind, _turn(draw, body)
    else:
        chunks[which : which + 1] = [chunks[which]] * draw.choice((0, 2))
    return content[:8] + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in chunks
    )
