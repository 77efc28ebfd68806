# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for machines read back by programs and readers that are not ours: the lines in their order [mm]."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import ezdxf
import ezdxf.path
import numpy as np
import shapely
from read_back import line, once_round, page_lines, svg_lines

from BalloonWorkbench.core.machines.machine import Machine
from BalloonWorkbench.core.machines.machine_file import machine_file
from BalloonWorkbench.core.pattern.pattern import Pattern, Role
from BalloonWorkbench.core.units import to_mm

CUTS = (Role.CUT, Role.CUT_INNER)

#: Lines of a file in their order, with what is done along them [mm].
Read = list[tuple[Role, shapely.Geometry]]


def read_dxf(content: bytes, made_for: Machine, _folder: Path) -> Read:
    document = ezdxf.read(io.StringIO(content.decode("cp1252")))
    scale = 25.4 if made_for.unit == "in" else 1.0
    roles = {look.name: role for role, look in made_for.layers.items()}
    found = []
    for entity in document.modelspace():
        way = ezdxf.path.make_path(entity).flattening(0.002 / scale, segments=4)
        closed = entity.is_closed if made_for.version == "R12" else entity.closed
        found.append((roles[entity.dxf.layer], (np.array([(p.x, p.y) for p in way]) * scale, closed)))
    return _lines(found, made_for)


def read_svg(content: bytes, made_for: Machine, _folder: Path) -> Read:
    read, _ = svg_lines(content.decode())
    return _by_colour(read, made_for)


def read_pdf(content: bytes, made_for: Machine, folder: Path) -> Read:
    (folder / "page.pdf").write_bytes(content)
    read, _ = page_lines(folder / "page.pdf", 1, folder)
    return _by_colour(read, made_for)


def _by_colour(read: list[tuple[str, shapely.Geometry]], made_for: Machine) -> Read:
    roles = {look.rgb: role for role, look in made_for.layers.items()}
    return _lines(
        [(roles[rgb], (shapely.get_coordinates(each), each.is_ring)) for rgb, each in read], made_for
    )


def read_hpgl(content: bytes, made_for: Machine, _folder: Path) -> Read:
    found, pen, points = [], 0, [(0.0, 0.0)]
    for name, numbers in re.findall(r"(IN|PA|SP|PU|PD)([\d,-]*);", content.decode()):
        values = [float(number) / 40.0 for number in numbers.split(",") if number]
        if name == "PD":
            points += list(zip(values[::2], values[1::2]))
        elif name in ("PU", "SP"):
            if len(points) > 1:
                found.append(_by_pen(np.array(points), pen, made_for))
            points = [(values[0], values[1])] if name == "PU" else points[-1:]
            pen = int(numbers) if name == "SP" else pen
    return _lines(found, made_for)


def read_lightburn(content: bytes, made_for: Machine, _folder: Path) -> Read:
    """In the order of the layers' priorities; a layer's name tells what is done on it."""
    root = ElementTree.fromstring(content)
    layers = {each.find("index").get("Value"): each for each in root.findall("CutSetting")}
    roles = {look.name: role for role, look in made_for.layers.items()}
    found = []
    for shape in root.findall("Shape"):
        layer = layers[shape.get("CutIndex")]
        name = re.sub(r"-\d+$", "", layer.find("name").get("Value").split()[0])
        points = re.findall(r"V([-\d.]+) ([-\d.]+)c0x1c1x1", shape.find("VertList").text)
        closed = shape.find("PrimList").text == "LineClosed"
        turn = int(layer.find("priority").get("Value"))
        found.append((turn, (roles[name], (np.array(points, dtype=float), closed))))
    return _lines([each for _, each in sorted(found, key=lambda pair: pair[0])], made_for)


def _by_pen(points: np.ndarray, pen: int, made_for: Machine) -> tuple[Role, tuple[np.ndarray, bool]]:
    """A line that comes round is a cut, where its pen has one; the pen may have others too."""
    way = shapely.LineString(points)
    back = way.interpolate(max(way.length - to_mm(made_for.overcut), 0.0))
    comes_round = way.length > 5.0 and back.distance(shapely.Point(points[0])) < 0.05
    roles = [role for role, look in made_for.layers.items() if look.pen == pen]
    role = next((each for each in roles if (each in CUTS) == comes_round), roles[0])
    return role, (points, comes_round and not made_for.overcut)


READERS: dict[str, Callable[[bytes, Machine, Path], Read]] = {
    "dxf": read_dxf, "svg": read_svg, "pdf": read_pdf, "hpgl": read_hpgl,
    "lbrn2": read_lightburn,
}  # fmt: skip


def _lines(found: list[tuple[Role, tuple[np.ndarray, bool]]], made_for: Machine) -> Read:
    """Cuts as rings, also those that go on past their start."""
    overcut = to_mm(made_for.overcut)
    read: Read = []
    for role, (way, closed) in found:
        points = way[:-1] if closed and np.allclose(way[0], way[-1], rtol=0.0, atol=1e-5) else way
        ring = role in CUTS and overcut and not made_for.knife_offset
        read.append((role, once_round(points, overcut) if ring else line(points, closed)))
    return read


def written(pattern: Pattern, made_for: Machine, folder: Path) -> Read:
    return READERS[made_for.format](machine_file(pattern, made_for), made_for, folder)
