# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes from PLY files, written or binary, as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.mesh_files import RawMesh, check_count
from BalloonWorkbench.core.types import Floats, Ints

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"}
_TYPES |= {"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"}
_TYPES |= {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_DAMAGED = "The PLY file is damaged: {} Save it once more."
_LONGEST_HEADER = 1 << 16


@dataclass
class _Element:
    """A list of things in the file: how many, and the properties of each, (name, type, type of its count)."""

    name: str
    count: int
    properties: list[tuple[str, str, str]] = field(default_factory=list)


def read_ply(data: bytes) -> RawMesh:
    """The faces of a PLY file; those with more than three corners are parted. InputError."""
    end = data.find(b"end_header", 0, _LONGEST_HEADER)
    if end < 0:
        raise InputError(_DAMAGED.format("its header has no end."))
    order, elements = _header(data[:end].decode("ascii", "replace"))
    body = data[data.find(b"\n", end) + 1 :]
    points, corners = np.zeros((0, 3)), None
    reader = _Written(body) if not order else _Binary(body, order)
    for element in elements:
        checkpoint()
        check_count(element.count // 3)
        if element.name == "vertex":
            points = reader.columns(element, ("x", "y", "z"))
        elif element.name == "face":
            corners = reader.lists(element, ("vertex_indices", "vertex_index"))
            break
        else:
            reader.lists(element, ())
    if corners is None or not len(corners) or not len(points):
        raise InputError("The PLY file has no faces. Save the body as a mesh of triangles.")
    return RawMesh(points, corners)


def _header(text: str) -> tuple[str, list[_Element]]:
    order, elements = None, list[_Element]()
    try:
        for line in text.splitlines():
            words = line.split()
            if words[:1] == ["format"]:
                order = _ORDERS[words[1]]
            elif words[:1] == ["element"]:
                elements.append(_Element(words[1], int(words[2])))
            elif words[:2] == ["property", "list"]:
                elements[-1].properties.append((words[4], _TYPES[words[3]], _TYPES[words[2]]))
            elif words[:1] == ["property"]:
                elements[-1].properties.append((words[2], _TYPES[words[1]], ""))
    except (IndexError, KeyError, ValueError):
        raise InputError(_DAMAGED.format("its header cannot be understood.")) from None
    if order is None or any(element.count < 0 for element in elements):
        raise InputError(_DAMAGED.format("its header cannot be understood."))
    return order, elements


class _Binary:
    """Reads elements one after the other."""

    def __init__(self, data: bytes, order: str) -> None:
        self._data, self._order, self._at = data, order, 0

    def columns(self, element: _Element, names: tuple[str, ...]) -> Floats:
        """Properties (k, d) of an element that has no lists."""
        if any(counted for _, _, counted in element.properties):
            raise InputError(_DAMAGED.format("its points have lists."))
        rows = self._rows(
            element, [(str(k), self._order + kind) for k, (_, kind, _) in enumerate(element.properties)]
        )
        known = [name for name, _, _ in element.properties]
        if not set(names) <= set(known):
            raise InputError(_DAMAGED.format("its points have no x, y and z."))
        return np.column_stack([rows[str(known.index(name))].astype(np.float64) for name in names])

    def lists(self, element: _Element, names: tuple[str, ...]) -> Ints:
        """The triangles (k, 3) of an element with these lists; all of its bytes are taken."""
        as_triangles: list[tuple[str, ...] | tuple[str, str, int]] = []
        for k, (_, kind, counted) in enumerate(element.properties):
            if counted:
                as_triangles += [(f"n{k}", self._order + counted), (str(k), self._order + kind, 3)]
            else:
                as_triangles.append((str(k), self._order + kind))
        of_lists = [k for k, (_, _, counted) in enumerate(element.properties) if counted]
        own = [k for k in of_lists if element.properties[k][0] in names]
        size = np.dtype(as_triangles).itemsize * element.count
        if self._at + size <= len(self._data):
            start = self._at
            rows = self._rows(element, as_triangles)
            if all((rows[f"n{k}"] == 3).all() for k in of_lists):
                return rows[str(own[0])].astype(np.int32) if own else np.zeros((0, 3), dtype=np.int32)
            self._at = start
        return self._uneven(element, own[0] if own else -1)

    def _uneven(self, element: _Element, own: int) -> Ints:
        """The same, thing by thing."""
        triangles: list[tuple[int, int, int]] = []
        for _ in range(element.count):
            for k, (_, kind, counted) in enumerate(element.properties):
                count = int(self._take(counted, 1)[0]) if counted else 1
                values = self._take(kind, count)
                if k == own:
                    triangles += _fan(values.tolist())
        return np.array(triangles, dtype=np.int32).reshape(-1, 3)

    def _take(self, kind: str, count: int) -> NDArray[Any]:
        dtype = np.dtype(self._order + kind)
        if count < 0 or self._at + count * dtype.itemsize > len(self._data):
            raise InputError(_DAMAGED.format("it ends too early."))
        values = np.frombuffer(self._data, dtype, count, self._at)
        self._at += count * dtype.itemsize
        return values

    def _rows(self, element: _Element, fields: Sequence[Any]) -> NDArray[Any]:
        dtype = np.dtype(list(fields))
        if self._at + dtype.itemsize * element.count > len(self._data):
            raise InputError(_DAMAGED.format("it ends too early."))
        rows = np.frombuffer(self._data, dtype, element.count, self._at)
        self._at += dtype.itemsize * element.count
        return rows


class _Written:
    """The same from a text, one thing a line."""

    def __init__(self, data: bytes) -> None:
        self._lines = (words for line in data.splitlines() if (words := line.split()))

    def _next(self) -> list[bytes]:
        try:
            return next(self._lines)
        except StopIteration:
            raise InputError(_DAMAGED.format("it ends too early.")) from None

    def columns(self, element: _Element, names: tuple[str, ...]) -> Floats:
        """Properties (k, d) of an element that has no lists."""
        known = [name for name, _, _ in element.properties]
        if not set(names) <= set(known):
            raise InputError(_DAMAGED.format("its points have no x, y and z."))
        places = [known.index(name) for name in names]
        try:
            rows = [
                [float(words[k]) for k in places] for words in (self._next() for _ in range(element.count))
            ]
        except (ValueError, IndexError):
            raise InputError(_DAMAGED.format("a point is no three numbers.")) from None
        return np.array(rows, dtype=np.float64).reshape(-1, len(names))

    def lists(self, element: _Element, names: tuple[str, ...]) -> Ints:
        """The triangles (k, 3) of an element with these lists; all of its lines are taken."""
        triangles: list[tuple[int, int, int]] = []
        try:
            for _ in range(element.count):
                words, at = self._next(), 0
                for name, _, counted in element.properties:
                    count = int(words[at]) if counted else 1
                    at += bool(counted)
                    if name in names and counted:
                        triangles += _fan([int(word) for word in words[at : at + count]])
                    at += count
        except (ValueError, IndexError):
            raise InputError(_DAMAGED.format("a face is no list of points.")) from None
        return np.array(triangles, dtype=np.int32).reshape(-1, 3)


def _fan(corners: list[int]) -> list[tuple[int, int, int]]:
    """Triangles of a face."""
    return [(corners[0], one, other) for one, other in pairwise(corners[1:])]
