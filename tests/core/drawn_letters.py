# SPDX-License-Identifier: LGPL-2.1-or-later
"""Letters and digits as outlines, in fonts of different kind.

Matplotlib brings the first two itself; the others are Debian packages of the validation.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from drawn_shapes import oriented

from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.packages import shapely

SIGNS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
FONTS = {
    "sans bold": "DejaVuSans-Bold.ttf",
    "serif bold": "DejaVuSerif-Bold.ttf",
    "slab bold": "RobotoSlab-Bold.otf",
    "script": "KaushanScript-Regular.otf",
}
_UNITS = 2000.0  # fine steps along the curves


def letter_outline(font: str, sign: str, height: float = 0.3) -> Outline:
    """The largest part of a sign with its holes, its larger dimension `height` [m]; dots are left away.

    Raises StopIteration where the font is not there.
    """
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    properties = FontProperties(fname=next(path for path in _font_files() if path.endswith(FONTS[font])))
    loops = TextPath((0.0, 0.0), sign, size=_UNITS, prop=properties).to_polygons(closed_only=True)
    areas = [_largest(shapely().Polygon(loop).buffer(0.0)) for loop in loops]
    body = max(areas, key=lambda area: area.area)
    low_x, low_y, high_x, high_y = body.bounds
    scale = height / max(high_x - low_x, high_y - low_y)

    def placed(area: Any, counter_clockwise: bool) -> Any:
        points = np.asarray(area.exterior.coords)[:-1] - (low_x, low_y)
        return oriented(scale * points, counter_clockwise)

    holes = [area for area in areas if area is not body and body.contains(area)]
    return Outline(placed(body, True), tuple(placed(hole, False) for hole in holes))


@cache
def _font_files() -> list[str]:
    from matplotlib import get_data_path
    from matplotlib.font_manager import findSystemFonts

    own = Path(get_data_path()) / "fonts" / "ttf"
    return [
        *map(str, sorted(own.glob("*.ttf"))),
        *sorted(findSystemFonts()),
        *sorted(findSystemFonts(fontext="otf")),
    ]


def _largest(area: Any) -> Any:
    return area if area.geom_type == "Polygon" else max(area.geoms, key=lambda part: part.area)
