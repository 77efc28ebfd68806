# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes from STL and OBJ files, as they are written."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.types import Floats, Ints

#: More would take more memory than there may be.
MOST_TRIANGLES = 4_000_000
_STL_HEADER, _STL_FACET = 84, 50
_AT_ONCE = 1 << 22  # bytes of text


@dataclass(frozen=True)
class RawMesh:
    """What a mesh file says: points (n, 3) in its unit, triangles (m, 3); unit: metres in it, None if it does
    not say."""

    points: Floats
    triangles: Ints
    unit: float | None = None


def check_count(count: int) -> None:
    """InputError for too many triangles, before there are any."""
    if count > MOST_TRIANGLES:
        raise InputError(
            f"The mesh has too many triangles, more than {MOST_TRIANGLES}. Simplify it in the program that it"
            " comes from."
        )


def lines_of(data: bytes) -> Iterator[list[bytes]]:
    """The words of each line of a text."""
    for first in _pieces(data):
        checkpoint()
        yield from (line.split() for line in first.splitlines())


def _pieces(data: bytes) -> Iterator[bytes]:
    """A text in parts that end where lines end."""
    first = 0
    while first < len(data):
        last = data.find(b"\n", first + _AT_ONCE) + 1 or len(data)
        yield data[first:last]
        first = last


def read_stl(data: bytes) -> RawMesh:
    """A binary or written STL file. InputError."""
    count = int.from_bytes(data[80:_STL_HEADER], "little") if len(data) >= _STL_HEADER else 0
    if len(data) == _STL_HEADER + _STL_FACET * count or not data.lstrip().startswith(b"solid"):
        if not count or len(data) < _STL_HEADER + _STL_FACET * count:
            raise InputError(
                "The STL file is damaged, as it ends too early, or no STL file at all. Save it once more."
            )
        check_count(count)
        facets = np.frombuffer(
            data, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")]), count, 84
        )
        points = facets["corners"].reshape(-1, 3).astype(np.float64)
    else:
        points = _written_stl(data)
    return RawMesh(points, np.arange(len(points), dtype=np.int32).reshape(-1, 3))


def _written_stl(data: bytes) -> Floats:
    parts: list[Floats] = []
    count = 0
    for piece in _pieces(data):
        checkpoint()
        words = [line.split()[1:4] for line in piece.splitlines() if b"vertex" in line.lower()]
        count += len(words)
        check_count(count // 3)
        parts.append(_numbers(words, "STL"))
    if not count or count % 3:
        raise InputError("The STL file is damaged: it has no triangles, or half of one. Save it once more.")
    return np.concatenate(parts)


def _numbers(words: list[list[bytes]], kind: str) -> Floats:
    """Points (k, 3) from the words of lines. InputError."""
    try:
        return np.array(words, dtype=np.float64).reshape(-1, 3)
    except ValueError:
        raise InputError(
            f"The {kind} file has a point that is no three numbers. Save it once more."
        ) from None


def read_obj(data: bytes) -> RawMesh:
    """The faces of an OBJ file; those with more than three corners are parted. InputError."""
    points: list[Floats] = []
    triangles: list[tuple[int, int, int]] = []
    count = 0
    for piece in _pieces(data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ")):
        checkpoint()
        lines = [line.split() for line in piece.splitlines()]
        words = [line[1:4] for line in lines if line[:1] == [b"v"]]
        points.append(_numbers(words, "OBJ"))
        before, count = count, count + len(words)
        for line in lines:
            before += line[:1] == [b"v"]
            if line[:1] == [b"f"]:
                corners = _obj_corners(line[1:], before)
                triangles += [(corners[0], one, other) for one, other in pairwise(corners[1:])]
        check_count(len(triangles))
    if not triangles or not count:
        raise InputError("The OBJ file has no faces. Save the body as a mesh of triangles.")
    return RawMesh(np.concatenate(points), np.array(triangles, dtype=np.int32))


def _obj_corners(words: list[bytes], count: int) -> list[int]:
    """Numbers of the points of a face, from 0; those below 0 are counted back from the last point."""
    try:
        numbers = [int(word.partition(b"/")[0]) for word in words]
    except ValueError:
        raise InputError("The OBJ file has a face that is no list of points. Save it once more.") from None
    return [number - 1 if number > 0 else count + number for number in numbers]
