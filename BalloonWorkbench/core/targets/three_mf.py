# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes from 3MF files: a ZIP with the bodies as XML, and where each of them stands."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import IO
from xml.etree import ElementTree

import numpy as np

from BalloonWorkbench.core.checkpoint import checkpoint
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.targets.mesh_files import RawMesh, check_count
from BalloonWorkbench.core.types import Floats, Ints

_UNITS = {
    "micron": 1e-6,
    "millimeter": 1e-3,
    "centimeter": 1e-2,
    "inch": 0.0254,
    "foot": 0.3048,
    "meter": 1.0,
}
_MOST_BYTES = 600 << 20
_DEEPEST, _MOST_COPIES = 20, 1000
_DAMAGED = "The 3MF file is damaged ({}). Save it once more."


@dataclass
class _Object:
    """A body, or what it is composed of: (number, its matrix (4, 3))."""

    points: list[tuple[float, float, float]] = field(default_factory=list)
    triangles: list[tuple[int, int, int]] = field(default_factory=list)
    parts: list[tuple[str, Floats]] = field(default_factory=list)


def read_3mf(data: bytes) -> RawMesh:
    """All bodies of a 3MF file in their places. InputError."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            names = [name for name in archive.namelist() if name.lower().endswith(".model")]
            names.sort(key=lambda name: name.lower() != "3d/3dmodel.model")
            if not names:
                raise InputError(_DAMAGED.format("there is no model in it"))
            if archive.getinfo(names[0]).file_size > _MOST_BYTES:
                raise InputError("The 3MF file is too large. Simplify the mesh in the program it comes from.")
            with archive.open(names[0]) as model:
                unit, objects, items = _parsed(model)
    except (zipfile.BadZipFile, ElementTree.ParseError, KeyError, ValueError, EOFError, OSError) as error:
        raise InputError(_DAMAGED.format(" ".join(str(error).split())[:100])) from None
    placed = (part for number, matrix in items for part in _placed(objects, number, matrix, 0))
    parts = list(islice(placed, _MOST_COPIES + 1))
    if not parts:
        raise InputError("The 3MF file has no bodies. Save the body as a mesh of triangles.")
    if len(parts) > _MOST_COPIES:
        raise InputError(f"The 3MF file has more than {_MOST_COPIES} bodies. Leave one of them in it.")
    check_count(sum(len(triangles) for _, triangles in parts))
    starts = np.cumsum([0, *(len(points) for points, _ in parts)])
    triangles = [own + start for (_, own), start in zip(parts, starts)]
    return RawMesh(np.concatenate([points for points, _ in parts]), np.concatenate(triangles), unit)


def _parsed(model: IO[bytes]) -> tuple[float, dict[str, _Object], list[tuple[str, Floats]]]:
    """The unit [m], the objects by their numbers, and which of them stand where."""
    unit, objects, items = 1e-3, dict[str, _Object](), list[tuple[str, Floats]]()
    current = _Object()
    for count, (event, element) in enumerate(ElementTree.iterparse(model, ("start", "end"))):
        if count % 100_000 == 0:
            checkpoint()
        name = element.tag.rpartition("}")[2]
        if event == "start" and name == "model":
            unit = _UNITS[element.get("unit", "millimeter")]
        elif event == "start" and name == "object":
            current = objects[element.attrib["id"]] = _Object()
        elif event == "end":
            _take(name, element, current, items)
            element.clear()
    return unit, objects, items


def _take(name: str, element: ElementTree.Element, current: _Object, items: list[tuple[str, Floats]]) -> None:
    """Add what an element says."""
    own = element.attrib
    if name == "vertex":
        current.points.append((float(own["x"]), float(own["y"]), float(own["z"])))
    elif name == "triangle":
        current.triangles.append((int(own["v1"]), int(own["v2"]), int(own["v3"])))
        check_count(len(current.triangles))
    elif name in ("component", "item"):
        numbers = [float(word) for word in own.get("transform", "1 0 0 0 1 0 0 0 1 0 0 0").split()]
        place = own["objectid"], np.array(numbers).reshape(4, 3)
        (current.parts if name == "component" else items).append(place)


def _placed(
    objects: dict[str, _Object], number: str, matrix: Floats, level: int
) -> Iterator[tuple[Floats, Ints]]:
    """The meshes that an object consists of, where a matrix puts them."""
    if level > _DEEPEST or number not in objects:
        raise InputError(_DAMAGED.format("a body consists of itself, or of one that is not there"))
    body = objects[number]
    if body.triangles:
        points = np.array(body.points, dtype=np.float64).reshape(-1, 3)
        triangles = np.array(body.triangles, dtype=np.int32)
        mirrored = np.linalg.det(matrix[:3]) < 0.0
        yield points @ matrix[:3] + matrix[3], triangles[:, ::-1] if mirrored else triangles
    for part, own in body.parts:
        yield from _placed(
            objects, part, np.vstack([own[:3] @ matrix[:3], own[3] @ matrix[:3] + matrix[3]]), level + 1
        )
