# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files written by their formats, of points (n, 3) in millimetres and triangles (m, 3)."""

from __future__ import annotations

import io
import struct
import zipfile
from collections.abc import Callable

from BalloonWorkbench.core.types import Floats, Ints


def stl(points: Floats, triangles: Ints) -> bytes:
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *points[triangle].ravel(), 0) for triangle in triangles)
    return b"solid but binary".ljust(80) + struct.pack("<I", len(triangles)) + facets


def written_stl(points: Floats, triangles: Ints) -> bytes:
    facets = "".join(
        "facet normal 0 0 0\n outer loop\n"
        + "".join(" vertex {:.6e} {:.6e} {:.6e}\n".format(*point) for point in points[triangle])
        + " endloop\nendfacet\n"
        for triangle in triangles
    )
    return f"solid name\n{facets}endsolid name\n".encode()


def obj(points: Floats, triangles: Ints) -> bytes:
    lines = ["# a body", *("v {} {} {} 0.5 0.5 0.5".format(*point) for point in points), "vn 0 0 1", "g one"]
    half = len(triangles) // 2
    lines += ["f " + " ".join(f"{k + 1}//1" for k in triangle) for triangle in triangles[:half]]
    lines += ["f " + " ".join(f"{k - len(points)}" for k in triangle) for triangle in triangles[half:]]
    return "\r\n".join(lines).encode()


def ply(order: str) -> Callable[[Floats, Ints], bytes]:
    def write(points: Floats, triangles: Ints) -> bytes:
        header = (
            f"ply\nformat {order} 1.0\ncomment c\nelement vertex {len(points)}\nproperty float x\n"
            "property float y\nproperty float z\nproperty uchar red\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
        )
        if order == "ascii":
            body = "".join("{} {} {} 7\n".format(*point) for point in points)
            return (header + body + "".join("3 {} {} {}\n".format(*row) for row in triangles)).encode()
        sign = "<" if "little" in order else ">"
        rows = [struct.pack(sign + "3fB", *point, 7) for point in points]
        rows += [struct.pack(sign + "B3i", 3, *row) for row in triangles]
        return header.encode() + b"".join(rows)

    return write


def three_mf(points: Floats, triangles: Ints) -> bytes:
    """In centimetres, the body shifted by a component and turned over by an item."""
    vertices = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*(0.1 * point)) for point in points)
    faces = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*row) for row in triangles)
    model = (
        '<?xml version="1.0"?><model unit="centimeter"'
        ' xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
        f'<resources><object id="1"><mesh><vertices>{vertices}</vertices>'
        f"<triangles>{faces}</triangles></mesh>"
        '</object><object id="2"><components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/>'
        '</components></object></resources><build><item objectid="2" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>'
        "</build></model>"
    )
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr("3D/3dmodel.model", model)
    return file.getvalue()


WRITERS: dict[str, tuple[str, Callable[[Floats, Ints], bytes]]] = {
    "binary STL": ("stl", stl),
    "written STL": ("stl", written_stl),
    "OBJ": ("obj", obj),
    "written PLY": ("ply", ply("ascii")),
    "PLY": ("ply", ply("binary_little_endian")),
    "other PLY": ("ply", ply("binary_big_endian")),
    "3MF": ("3mf", three_mf),
}
