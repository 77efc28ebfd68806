# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes with values as VTK files (.vtu), and series of them in time (.pvd), which ParaView opens.

The XML format of VTK: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
"""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.types import Floats, Ints

Values = Mapping[str, NDArray[Any]]

_TRIANGLE = 5  # VTK's number for this shape of cell


def vtu_bytes(points: Floats, triangles: Ints, point_data: Values, cell_data: Values) -> bytes:
    """A VTK file of points (n, 3) and triangles (m, 3) with values by name: (n,) or (n, 3); (m,) or (m, 3).

    Real numbers are stored in single precision.
    """
    ends = 3 * np.arange(1, len(triangles) + 1, dtype=np.int32)
    kinds = np.full(len(triangles), _TRIANGLE, dtype=np.uint8)
    lines = [
        '<?xml version="1.0"?>',
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt32">',
        "<UnstructuredGrid>",
        f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(triangles)}">',
        *("<PointData>", *(_array(name, data) for name, data in point_data.items()), "</PointData>"),
        *("<CellData>", *(_array(name, data) for name, data in cell_data.items()), "</CellData>"),
        *("<Points>", _array("Points", points), "</Points>"),
        "<Cells>",
        _array("connectivity", triangles.reshape(-1)),
        _array("offsets", ends),
        _array("types", kinds),
        "</Cells>",
        "</Piece>",
        "</UnstructuredGrid>",
        "</VTKFile>",
    ]
    return ("\n".join(lines) + "\n").encode("ascii")


def pvd_bytes(times: Sequence[float], names: Sequence[str]) -> bytes:
    """A series of files in time [s]."""
    parts = [
        f'<DataSet timestep="{time:.9g}" part="0" file="{name}"/>'
        for time, name in zip(times, names, strict=True)
    ]
    lines = ['<?xml version="1.0"?>', '<VTKFile type="Collection" version="0.1">', "<Collection>"]
    return ("\n".join([*lines, *parts, "</Collection>", "</VTKFile>"]) + "\n").encode("ascii")


def _array(name: str, values: NDArray[Any]) -> str:
    """A block of numbers: base64 of their count of bytes and the bytes."""
    if values.dtype.kind == "f":
        kind, raw = "Float32", values.astype("<f4").tobytes()
    elif values.dtype.itemsize == 1:
        kind, raw = "UInt8", values.astype("u1").tobytes()
    else:
        kind, raw = "Int32", values.astype("<i4").tobytes()
    text = base64.b64encode(np.uint32(len(raw)).astype("<u4").tobytes() + raw).decode("ascii")
    width = values.shape[1] if values.ndim == 2 else 1
    return (
        f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" format="binary">'
        f"{text}</DataArray>"
    )
