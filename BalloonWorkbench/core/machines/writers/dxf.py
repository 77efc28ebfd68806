# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as DXF R2000 or R12: one polyline for each line, arcs as bulges, in the machine's unit."""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from BalloonWorkbench.core.machines.machine import UNITS, Machine
from BalloonWorkbench.core.machines.toolpaths import Path, Toolpaths, in_unit
from BalloonWorkbench.core.packages import ezdxf
from BalloonWorkbench.core.units import MILLIMETRE

#: Digits of coordinates and bulges: finer than any machine, and short.
_DIGITS = 6
#: A dash and a gap [mm].
_DASH = 4.0


def drawing_dxf(drawing: Toolpaths, machine: Machine) -> bytes:
    """The file's content; the same bytes for the same drawing.

    R2000 has LWPOLYLINE and tells the unit in its header; R12 has POLYLINE and knows no unit.
    MissingPackageError without ezdxf.
    """
    package = ezdxf()
    scaled = in_unit(drawing, UNITS[machine.unit])
    stamped = package.options.write_fixed_meta_data_for_testing
    package.options.write_fixed_meta_data_for_testing = True  # no dates and no random identifiers
    try:
        document = package.document.Drawing.new(machine.version)
        _describe(document, scaled, machine)
        space = document.modelspace()
        for path in scaled.paths:
            _add(space, path, machine)
        corner = (scaled.width, scaled.height)
        space.reset_extents((0.0, 0.0, 0.0), (*corner, 0.0))
        space.reset_limits((0.0, 0.0), corner)
        stream = io.StringIO(newline="\n")
        document.write(stream)
    finally:
        package.options.write_fixed_meta_data_for_testing = stamped
    return bytes(document.encode(stream.getvalue()))


def _describe(document: Any, drawing: Toolpaths, machine: Machine) -> None:
    """Header and tables, in agreement with the coordinates."""
    dash = _DASH * MILLIMETRE / UNITS[machine.unit]
    metric = machine.unit == "mm"
    if machine.version != "R12":
        document.header["$INSUNITS"] = 4 if metric else 1
        document.header["$MEASUREMENT"] = int(metric)
    document.header["$LUNITS"] = 2
    corner = (drawing.width, drawing.height)
    document.header["$EXTMIN"], document.header["$EXTMAX"] = (0.0, 0.0, 0.0), (*corner, 0.0)
    document.header["$LIMMIN"], document.header["$LIMMAX"] = (0.0, 0.0), corner
    document.set_modelspace_vport(1.1 * max(corner), (0.5 * drawing.width, 0.5 * drawing.height))
    for role in drawing.roles:
        line = machine.layers[role]
        if line.line != "CONTINUOUS" and line.line not in document.linetypes:
            document.linetypes.add(line.line, [1.5 * dash, dash, -0.5 * dash])
        if line.name not in document.layers:
            document.layers.add(line.name, color=line.aci, linetype=line.line)


def _add(space: Any, path: Path, machine: Machine) -> None:
    """One polyline; the colour also on the entity, because some programs look only there."""
    line = machine.layers[path.role]
    look = {"layer": line.name, "color": line.aci, "linetype": line.line}
    curve = path.curve
    bulges = curve.bulges if curve.closed else np.append(curve.bulges, 0.0)
    points = np.round(np.column_stack([curve.joints, bulges]), _DIGITS) + 0.0
    if machine.version == "R12":
        space.add_polyline2d(points.tolist(), format="xyb", close=curve.closed, dxfattribs=look)
    else:
        space.add_lwpolyline(points.tolist(), format="xyb", close=curve.closed, dxfattribs=look)
