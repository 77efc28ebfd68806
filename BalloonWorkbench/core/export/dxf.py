# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern as DXF R2000: closed LWPOLYLINEs in millimetres, which every cutter program reads."""

from __future__ import annotations

import io

from BalloonWorkbench.core.export.sheet import LAYERS, lay_out
from BalloonWorkbench.core.packages import ezdxf
from BalloonWorkbench.core.pattern.pattern import Pattern


def dxf_bytes(pattern: Pattern) -> bytes:
    """The file's content; the same bytes for the same pattern.

    Layers are named like the roles. MissingPackageError without ezdxf.
    """
    package = ezdxf()
    sheet = lay_out(pattern)
    stamped = package.options.write_fixed_meta_data_for_testing
    package.options.write_fixed_meta_data_for_testing = True  # no dates and no random identifiers
    try:
        document = package.new("R2000", units=package.units.MM)
        for role in pattern.roles:
            document.layers.add(role.value, color=LAYERS[role].aci)
        space = document.modelspace()
        for path in sheet.paths:
            # The colour also on the entity: some programs look at the layer's, some at the entity's.
            look = {"layer": path.role.value, "color": LAYERS[path.role].aci}
            space.add_lwpolyline(path.points.tolist(), close=path.closed, dxfattribs=look)
        corner = (sheet.width, sheet.height)
        document.header["$MEASUREMENT"] = 1
        document.header["$LUNITS"] = 2
        document.header["$EXTMIN"], document.header["$EXTMAX"] = (0.0, 0.0, 0.0), (*corner, 0.0)
        document.header["$LIMMIN"], document.header["$LIMMAX"] = (0.0, 0.0), corner
        space.reset_extents((0.0, 0.0, 0.0), (*corner, 0.0))
        space.reset_limits((0.0, 0.0), corner)
        document.set_modelspace_vport(1.1 * max(corner), (0.5 * sheet.width, 0.5 * sheet.height))
        stream = io.StringIO(newline="\n")
        document.write(stream)
    finally:
        package.options.write_fixed_meta_data_for_testing = stamped
    return document.encode(stream.getvalue())
