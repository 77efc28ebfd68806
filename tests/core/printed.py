# SPDX-License-Identifier: LGPL-2.1-or-later
"""Printed balloons for the tests of artwork: pictures with dots, sheets, views of the inflated balloon."""

from __future__ import annotations

import numpy as np

from BalloonWorkbench.core.artwork.border import bordered
from BalloonWorkbench.core.artwork.picture import Picture, carried_on
from BalloonWorkbench.core.artwork.sheet import Print, Sheet, artwork_sheets
from BalloonWorkbench.core.geometry.raster import nearest_covers
from BalloonWorkbench.core.machines.marks.place import marked
from BalloonWorkbench.core.outline.outline import Outline
from BalloonWorkbench.core.pattern.build import build_pattern
from BalloonWorkbench.core.pattern.pattern import Pattern
from BalloonWorkbench.core.solver.inflation import Inflation

WHITE, FILM = (255, 255, 255, 255), (240, 200, 40, 255)
COLOURS = [(200, 30, 40, 255), (20, 120, 60, 255), (30, 60, 200, 255), (0, 0, 0, 255)]
DPI = 80.0
VIEW = 0.4e-3  # m, pixel of the views of the balloon
MM = 1e-3


def dotted(
    outline: Outline, pixel: float = 0.4 * MM, pitch: float = 32 * MM
) -> tuple[np.ndarray, np.ndarray]:
    """A picture of an outline on white paper, 20 pixels round it, with coloured dots inside, and their places
    (k, 2) m from the lower left corner of the outline."""
    from BalloonWorkbench.core.packages import shapely

    low, high = outline.outer.min(axis=0), outline.outer.max(axis=0)
    width, height = np.ceil((high - low) / pixel).astype(int) + 40
    x, y = np.meshgrid((np.arange(width) - 19.5) * pixel, (height - 20.5 - np.arange(height)) * pixel)
    package = shapely()
    area = package.Polygon(outline.outer - low, [hole - low for hole in outline.holes])
    pixels = np.where(package.contains_xy(area, x, y)[..., None], FILM, WHITE).astype(np.uint8)
    room = area.buffer(-12 * MM)
    places = [
        (a, b)
        for a in np.arange(0.0, high[0] - low[0], pitch)
        for b in np.arange(0.0, high[1] - low[1], pitch)
        if package.contains_xy(room, a, b)
    ]
    for k, (a, b) in enumerate(places):
        pixels[np.hypot(x - a, y - b) < 5 * MM] = COLOURS[k % 4]
    return pixels, np.array(places)


def exactly(pixels: np.ndarray, outline: Outline, pixel: float = 0.4 * MM) -> Picture:
    """A picture by `dotted` in its place, without looking for the shape in it."""
    low = outline.outer.min(axis=0) - 20.0 * pixel
    return Picture(carried_on(pixels, (pixels != WHITE).any(axis=2)), low, np.array([pixel, pixel]))


def inflated_view(
    sheet: Sheet, inflation: Inflation, low: np.ndarray, size: np.ndarray, pixel: float
) -> np.ndarray:
    """The printed balloon from the front, the nearest film in each pixel: by the renderer of the preview."""
    shape = (int(size[1] / pixel), int(size[0] / pixel))
    seen = (inflation.positions[:, :2] - low) / pixel
    seen[:, 1] = shape[0] - seen[:, 1]
    flat = inflation.panel.rest_positions
    triangles, middles = inflation.panel.triangles, (np.arange(shape[1]) + 0.5, np.arange(shape[0]) + 0.5)
    nearest = nearest_covers(seen, inflation.positions[:, 2], triangles, *middles)
    drawn = np.full((*shape, 2), np.nan)
    film = flat[triangles[nearest.number]]
    drawn[nearest.rows, nearest.columns] = (nearest.shares[..., None] * film).sum(axis=1)
    at = (np.nan_to_num(drawn) - sheet.origin) * sheet.dpi / 25.4e-3
    rows = np.clip(np.rint(len(sheet.pixels) - at[..., 1] - 0.5), 0, len(sheet.pixels) - 1).astype(int)
    columns = np.clip(np.rint(at[..., 0] - 0.5), 0, sheet.pixels.shape[1] - 1).astype(int)
    view = sheet.pixels[rows, columns]
    view[np.isnan(drawn[..., 0])] = 0
    return view


def dots_of(pixels: np.ndarray, pixel: float, near: np.ndarray) -> np.ndarray:
    """Middles (k, 2) m of the dots of a picture near places from its lower left corner."""
    x = (np.arange(pixels.shape[1]) + 0.5) * pixel
    y = (len(pixels) - np.arange(len(pixels)) - 0.5) * pixel
    found = []
    for k, (a, b) in enumerate(near):
        alike = np.abs(pixels[..., :3].astype(int) - COLOURS[k % 4][:3]).max(axis=2) < 40
        rows, columns = np.nonzero(alike & (np.hypot(x[None] - a, y[:, None] - b) < 10 * MM))
        assert len(rows), f"dot {k} is gone"
        found.append((x[columns].mean(), y[rows].mean()))
    return np.array(found)


def printed(
    inflation: Inflation, seam: Outline, picture: Picture, **options: object
) -> tuple[Sheet, Sheet, Pattern]:
    own = bordered(build_pattern(seam, 0.005))
    whole = marked(own)
    one = Print(inflation, own, np.zeros(2), picture, **options)
    return (*artwork_sheets([one], whole, DPI), whole)


def box_of(loop: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return loop.min(axis=0), np.ptp(loop, axis=0)
