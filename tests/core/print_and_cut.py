# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cutter with a camera does, for the tests: reads the marks of a file, finds them in a picture of the
print that was shifted, turned and scaled, and maps the cut by them. Nothing of ours helps it.
"""

from __future__ import annotations

import io
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import cv2
import ezdxf
import ezdxf.path
import numpy as np
import shapely
from svgelements import Path as Course

Lines = dict[str, list[np.ndarray]]
PICTURE_DPI = 300.0
PIXEL = 25.4 / PICTURE_DPI  # mm
#: The paper in the machine: turned by 1.3 degrees, 1 % larger, shifted [mm].
TURN, SCALE, SHIFT = np.radians(1.3), 1.01, np.array([9.3, 11.7])
_BLACK, _WHITE = 60, 255


def lines_of(content: bytes, name: str) -> Lines:
    """The lines (n, 2) mm of a DXF or SVG by layer, y up; closed ones with their first point again."""
    found: Lines = {}
    if name.endswith(".dxf"):
        for each in ezdxf.read(io.StringIO(content.decode("cp1252"))).modelspace():
            points = np.array([(at.x, at.y) for at in ezdxf.path.make_path(each).flattening(0.002)])
            found.setdefault(each.dxf.layer, []).append(points)
        return found
    root = ElementTree.fromstring(content)
    assert root.get("width", "").endswith("mm")
    height = float(root.get("viewBox", "").split()[3])
    for layer in root:
        for each in layer:
            course = Course(each.get("d"))
            ends = np.array([(one.end.x, one.end.y) for one in course if one.end is not None])
            even = np.array([(at.x, at.y) for at in map(course.point, np.linspace(0.0, 1.0, 2000))])
            line = np.array([0.0, height]) + (ends if len(ends) < 9 else even) * (1.0, -1.0)
            found.setdefault(layer.get("id", ""), []).append(line)
    return found


def marks_of(lines: list[np.ndarray]) -> np.ndarray:
    """Where the marks (k, 2) mm of a file are: middles of crosses, discs and squares, bends of corners."""
    places = []
    for line in lines:
        area = shapely.Polygon(line) if len(line) > 3 else None
        if area is None:
            continue  # a line of a cross; its circle stands for it
        low, high = np.array(area.bounds[:2]), np.array(area.bounds[2:])
        if max(high - low) > 4.0 * min(high - low):
            continue  # a bar
        places.append(_bend(line[:-1]) if area.area < 0.5 * np.prod(high - low) else 0.5 * (low + high))
    return np.array(places)


def _bend(points: np.ndarray) -> np.ndarray:
    """Where the middles of the two lines of a corner meet: amid the inner corner and the outer one by it."""
    hull = shapely.Polygon(points).convex_hull
    inner = points[np.argmax([hull.exterior.distance(shapely.Point(at)) for at in points])]
    away = np.hypot(*(points - inner).T)
    away[away == 0.0] = np.inf
    outer = points[np.argsort(away)[0]]
    return 0.5 * (inner + outer)


def photographed(pdf: Path, page: int = 1) -> np.ndarray:
    """The printed page as the machine sees it: grey, shifted, turned, and larger by 1 %."""
    pages = ["-f", str(page), "-l", str(page), "-singlefile"]
    command = ["pdftocairo", "-png", "-gray", "-r", f"{PICTURE_DPI:g}", *pages, str(pdf), "-"]
    printed = cv2.imdecode(
        np.frombuffer(subprocess.run(command, capture_output=True, check=True).stdout, np.uint8),
        cv2.IMREAD_GRAYSCALE,
    )
    height, width = printed.shape
    turn = SCALE * np.array([[np.cos(TURN), np.sin(TURN)], [-np.sin(TURN), np.cos(TURN)]])
    # whole numbers are the middles of pixels; some room below for what turning lifts
    moved = np.column_stack([turn, SHIFT / PIXEL + (0.0, abs(np.sin(TURN)) * width)])
    size = (int(1.06 * width) + 300, int(1.06 * height) + 300)
    return cv2.warpAffine(printed, moved, size, flags=cv2.INTER_CUBIC, borderValue=(_WHITE,))


def seen(picture: np.ndarray) -> np.ndarray:
    """The marks (k, 2) mm in a picture, as `marks_of` has them; y up from its lower left corner."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats((picture < _BLACK).astype(np.uint8))
    places = []
    for number in range(1, count):
        left, top, width, height, area = stats[number]
        if area * PIXEL**2 < 2.0 or max(width, height) > 4 * min(width, height):
            continue  # dust, or a bar
        room = 4
        window = (slice(top - room, top + height + room), slice(left - room, left + width + room))
        dark = (_WHITE - picture[window].astype(float)) * ~((labels[window] > 0) & (labels[window] != number))
        rows, columns = np.indices(dark.shape)
        thin = area < 0.35 * width * height and not _has_middle(dark)
        x, y = _corner(dark) if thin else (np.average(columns, weights=dark), np.average(rows, weights=dark))
        places.append((x + left - room, y + top - room))
    at = np.array(places)
    return PIXEL * np.column_stack([at[:, 0] + 0.5, len(picture) - at[:, 1] - 0.5])


def _has_middle(dark: np.ndarray) -> bool:
    rows, columns = (length // 2 for length in dark.shape)
    return bool(dark[rows - 4 : rows + 5, columns - 4 : columns + 5].max() > 128)


def _corner(dark: np.ndarray) -> tuple[float, float]:
    """Where two lines of a window meet, each through the middles of its darkness."""
    rows, columns = np.indices(dark.shape)
    heaviest = [dark[: len(dark) // 3].sum() > dark[-(len(dark) // 3) :].sum()]
    heaviest.append(dark[:, : dark.shape[1] // 3].sum() > dark[:, -(dark.shape[1] // 3) :].sum())
    y_bend, x_bend = (0 if first else length - 1 for first, length in zip(heaviest, dark.shape))
    along_x = np.abs(np.arange(dark.shape[1]) - x_bend) > 0.4 * dark.shape[1]
    along_y = np.abs(np.arange(dark.shape[0]) - y_bend) > 0.4 * dark.shape[0]

    def fitted(weights: np.ndarray, across: np.ndarray, at: np.ndarray) -> tuple[float, float]:
        total = weights.sum(axis=0)
        kept = total > 0.6 * np.median(total[total > 100.0])  # not the soft end of the line
        slope, offset = np.polyfit(at[kept], (weights * across).sum(axis=0)[kept] / total[kept], 1)
        return float(slope), float(offset)

    flat, y0 = fitted(dark[:, along_x], rows[:, along_x], np.flatnonzero(along_x))
    steep, x0 = fitted(dark[along_y].T, columns[along_y].T, np.flatnonzero(along_y))
    x = (x0 + steep * y0) / (1.0 - steep * flat)
    return x, y0 + flat * x


def mapped(points: np.ndarray, drawn: np.ndarray, found: np.ndarray) -> np.ndarray:
    """Points of a file in the picture, by marks there and here in the same order: two give place, turn and
    size, more an affine map."""
    if len(drawn) == 2:
        (a, b), (c, d) = (pair @ (1.0, 1j) for pair in (drawn, found))
        image = c + (points @ (1.0, 1j) - a) * (d - c) / (b - a)
        return np.column_stack([image.real, image.imag])
    known = np.column_stack([drawn, np.ones(len(drawn))])
    return np.column_stack([points, np.ones(len(points))]) @ np.linalg.lstsq(known, found, rcond=None)[0]


def matched(drawn: np.ndarray, found: np.ndarray) -> np.ndarray:
    """What was found, in the order of what was drawn."""
    assert len(found) == len(drawn), (len(found), len(drawn))
    away = np.linalg.norm((drawn - drawn.mean(axis=0))[:, None] - (found - found.mean(axis=0))[None], axis=2)
    nearest = away.argmin(axis=1)
    assert len(set(nearest.tolist())) == len(drawn)
    assert away.min(axis=1).max() < 12.0
    return found[nearest]


def off_border(line: np.ndarray, picture: np.ndarray) -> np.ndarray:
    """How far [mm] a closed line (n, 2) mm of the picture is from the border of the print, every 3 mm where
    it is straight enough to tell."""
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    places = np.arange(0.0, along[-1], 3.0)

    def at(way: np.ndarray) -> np.ndarray:
        way = np.mod(way, along[-1])
        return np.column_stack([np.interp(way, along, line[:, k]) for k in (0, 1)])

    before, here, after = at(places - 1.2), at(places), at(places + 1.2)
    a, b = here - before, after - here
    straight = np.abs(np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(axis=1))) < 0.1
    tangent = (after - before)[straight]
    normal = np.column_stack([tangent[:, 1], -tangent[:, 0]])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    steps = np.arange(-0.8, 0.8, 0.01)
    probes = here[straight][:, None] + steps[None, :, None] * normal[:, None]
    columns = (probes[..., 0] / PIXEL - 0.5).astype(np.float32)
    rows = (len(picture) - probes[..., 1] / PIXEL - 0.5).astype(np.float32)
    values = cv2.remap(picture, columns, rows, cv2.INTER_LINEAR).astype(float)
    dark = values < 0.5 * (values.min(axis=1) + values.max(axis=1))[:, None]
    crossed = np.diff(dark.astype(int), axis=1) != 0
    clear = (values.max(axis=1) - values.min(axis=1) > 50.0) & crossed.any(axis=1)
    assert clear.mean() > 0.9
    return np.abs(steps[crossed.argmax(axis=1)])[clear]


def disagreement(lines: Lines, drawn: np.ndarray, picture: np.ndarray) -> float:
    """The most [mm] by which the cut is off the border of the print, or a mark off where it was found."""
    found = matched(drawn, seen(picture))
    off = [off_border(mapped(cut, drawn, found), picture).max() for cut in lines["CUT"]]
    return max(*off, float(np.hypot(*(mapped(drawn, drawn, found) - found).T).max()))
