# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces with their pictures as one binary glTF 2.0 file (GLB).

https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html: a header, a JSON chunk that describes, and a BIN
chunk with all numbers and pictures.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.artwork.files import png_bytes
from BalloonWorkbench.core.scenes.surface_mesh import Finish, SurfaceMesh
from BalloonWorkbench.core.types import Floats

_HEADER, _CHUNK = struct.Struct("<III"), struct.Struct("<II")
_MAGIC, _VERSION, _JSON, _BIN = 0x46546C67, 2, 0x4E4F534A, 0x004E4942
_FLOAT, _SHORT, _LONG = 5126, 5123, 5125  # types of numbers
_VERTICES, _INDICES = 34962, 34963  # what a view of the buffer is for
_CLAMP, _LINEAR, _SMOOTH = 33071, 9729, 9987  # of a picture: past its edges, enlarged, made smaller
_PNG_DPI = 300.0
_UP = np.array([0.0, 0.0, 1.0])


def glb_bytes(title: str, balloons: Mapping[str, Sequence[SurfaceMesh]]) -> bytes:
    """The file of balloons by their names; the same bytes for the same. Their middle is the origin.

    Surfaces of one finish are one primitive; each balloon is a node.
    """
    parts = [mesh.positions for meshes in balloons.values() for mesh in meshes]
    everything = np.concatenate(parts)
    middle = 0.5 * (everything.min(axis=0) + everything.max(axis=0))
    file = _Gltf()
    nodes = [{"name": _letters(name), "mesh": file.mesh(meshes, middle)} for name, meshes in balloons.items()]
    return file.written(title, nodes)


class _Gltf:
    """A file that is being put together: its lists of things that refer to each other by number."""

    def __init__(self) -> None:
        self._bin = bytearray()
        self._lists: dict[str, list[dict[str, Any]]] = {}
        self._numbers: dict[int, int] = {}  # of finishes and pictures by identity

    def _add(self, name: str, what: dict[str, Any]) -> int:
        self._lists.setdefault(name, []).append(what)
        return len(self._lists[name]) - 1

    def mesh(self, meshes: Sequence[SurfaceMesh], middle: Floats) -> int:
        """The number of a mesh with a primitive for each finish."""
        of_finish: dict[int, list[SurfaceMesh]] = {}
        for mesh in meshes:
            of_finish.setdefault(id(mesh.finish), []).append(mesh)
        primitives = [self._primitive(each, middle) for each in of_finish.values()]
        return self._add("meshes", {"primitives": primitives})

    def _primitive(self, meshes: Sequence[SurfaceMesh], middle: Floats) -> dict[str, Any]:
        starts = np.cumsum([0, *(len(mesh.positions) for mesh in meshes)])
        indices = np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts)])
        normals = np.concatenate([mesh.normals for mesh in meshes])
        # a vertex of triangles without an area has no normal; the format asks for one
        normals = np.where(np.linalg.norm(normals, axis=1, keepdims=True) > 0.5, normals, _UP)
        attributes = {
            "POSITION": self._vertices(
                np.concatenate([mesh.positions for mesh in meshes]) - middle, ends=True
            ),
            "NORMAL": self._vertices(normals),
        }
        finish = meshes[0].finish
        if finish.picture is not None:
            attributes["TEXCOORD_0"] = self._vertices(np.concatenate([mesh.places for mesh in meshes]))
        return {
            "attributes": attributes,
            "indices": self._indices(indices.ravel(), int(starts[-1])),
            "material": self._material(finish),
        }

    def _vertices(self, values: Floats, *, ends: bool = False) -> int:
        """The number of what reads values (n, k) of vertices; with their least and largest."""
        numbers = values.astype("<f4")
        view = self._view(numbers.tobytes(), target=_VERTICES)
        kind = f"VEC{numbers.shape[1]}"
        accessor = {"bufferView": view, "componentType": _FLOAT, "count": len(numbers), "type": kind}
        if ends:
            accessor |= {"min": numbers.min(axis=0).tolist(), "max": numbers.max(axis=0).tolist()}
        return self._add("accessors", accessor)

    def _indices(self, indices: NDArray[Any], vertices: int) -> int:
        kind, code = ("<u2", _SHORT) if vertices < 65_535 else ("<u4", _LONG)
        view = self._view(indices.astype(kind).tobytes(), target=_INDICES)
        return self._add(
            "accessors", {"bufferView": view, "componentType": code, "count": len(indices), "type": "SCALAR"}
        )

    def _view(self, content: bytes, **more: int) -> int:
        start = len(self._bin)
        self._bin += content + b"\0" * (-len(content) % 4)
        return self._add(
            "bufferViews", {"buffer": 0, "byteOffset": start, "byteLength": len(content), **more}
        )

    def _material(self, finish: Finish) -> int:
        if id(finish) not in self._numbers:
            surface: dict[str, Any] = {
                "baseColorFactor": [*map(_linear, finish.colour), finish.opacity],
                "metallicFactor": finish.metal,
                "roughnessFactor": finish.rough,
            }
            if finish.picture is not None:
                surface["baseColorTexture"] = {"index": self._texture(finish)}
            material = {"pbrMetallicRoughness": surface, "doubleSided": finish.inside}
            if finish.opacity < 1.0:
                material["alphaMode"] = "BLEND"
            self._numbers[id(finish)] = self._add("materials", material)
        return self._numbers[id(finish)]

    def _texture(self, finish: Finish) -> int:
        picture = finish.picture
        assert picture is not None
        if id(picture) not in self._numbers:
            if not self._lists.get("samplers"):
                sides = {"wrapS": _CLAMP, "wrapT": _CLAMP, "magFilter": _LINEAR, "minFilter": _SMOOTH}
                self._add("samplers", sides)
            view = self._view(png_bytes(picture.pixels, _PNG_DPI))
            image = self._add("images", {"bufferView": view, "mimeType": "image/png"})
            self._numbers[id(picture)] = self._add("textures", {"sampler": 0, "source": image})
        return self._numbers[id(picture)]

    def written(self, title: str, nodes: list[dict[str, Any]]) -> bytes:
        """The content of the file."""
        described = {
            "asset": {"version": "2.0", "generator": "BalloonWorkbench"},
            "scene": 0,
            "scenes": [{"name": _letters(title), "nodes": [*range(len(nodes))]}],
            "nodes": nodes,
            **self._lists,
            "buffers": [{"byteLength": len(self._bin)}],
        }
        text = json.dumps(described, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        length = _HEADER.size + 2 * _CHUNK.size + len(text) + len(self._bin)
        return b"".join(
            (
                _HEADER.pack(_MAGIC, _VERSION, length),
                _CHUNK.pack(len(text), _JSON),
                text,
                _CHUNK.pack(len(self._bin), _BIN),
                bytes(self._bin),
            )
        )


def _linear(value: float) -> float:
    """A colour as on screens (sRGB) in parts of its light."""
    return round(value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4, 6)


def _letters(name: str) -> str:
    """A name with a sign for each letter that is none, as in names of files from other systems."""
    return name.encode(errors="replace").decode()
