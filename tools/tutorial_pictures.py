# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the commands of docs/tutorial-machines.md and makes its pictures from their files, in docs/images."""

from __future__ import annotations

import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "tutorial-machines.md"
IMAGES = ROOT / "docs" / "images"
#: What the page asks to be copied, from resources/examples.
INPUTS = ("pictures/fish.png", "pictures/star.png", "profiles/airship.json")
_DOTS = 80
_MOVE = re.compile(r"^G([0-3])\b(?=.*[XY])")
_AXIS = re.compile(r"([XYIJ])(-?[\d.]+)")


def commands(page: Path = PAGE) -> list[list[str]]:
    """The arguments of all commands of a page, in their order."""
    text = page.read_text(encoding="utf-8").replace("\\\n", " ")
    found = re.findall(r"^    python -m BalloonWorkbench (.+)$", text, re.MULTILINE)
    return [shlex.split(line) for line in found]


def main() -> None:
    """Everything in build/tutorial-machines, then the pictures."""
    folder = ROOT / "build" / "tutorial-machines"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in INPUTS:
        shutil.copy(ROOT / "resources" / "examples" / name, folder)
    home = {**os.environ, "PYTHONPATH": str(ROOT), "BALLOON_MACHINES": str(folder / "machines")}
    for arguments in commands():
        subprocess.run(
            [sys.executable, "-m", "BalloonWorkbench", *arguments], check=True, cwd=folder, env=home
        )
    _card(folder / "card" / "test-card.json")
    _moves(folder / "fish" / "pattern-tip-pe.gcode", "weld", "#c81e4a")
    _moves(folder / "airship" / "pattern-laser-pe.gcode", "laser", "#b42318")
    _print(folder / "star")
    _page(folder / "fish" / "assembly.pdf", 2, "fish", 1.0)
    _page(folder / "airship" / "assembly.pdf", 2, "airship", 0.56)


def _figure(width: float, height: float) -> tuple[Any, Any]:
    """A white page of so many mm, which axes fill."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width / 25.4, height / 25.4), dpi=_DOTS, facecolor="white")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    return figure, axes


def _save(figure: Any, name: str) -> None:
    figure.savefig(IMAGES / f"tutorial-machines-{name}.png", metadata={"Software": None})


def _card(file: Path) -> None:
    """The plan of a test card."""
    from BalloonWorkbench.core.machines.machine import machine_of
    from BalloonWorkbench.core.pattern.pattern import Role
    from BalloonWorkbench.core.test_cards.card import make_card
    from BalloonWorkbench.core.units import parse_temperature, to_mm

    plain = machine_of(json.loads(file.read_text(encoding="utf-8"))["machine"])
    heat = [parse_temperature(f"{celsius}C") for celsius in (230, 240, 250)]
    tried = {"feed": [150.0, 200.0, 300.0], "tip_temperature": heat, "depth": [2e-4]}
    card = make_card(plain, tried)
    width, height = (to_mm(side) for side in card.size)
    figure, axes = _figure(width + 10.0, height + 10.0)
    for contour in card.plan.contours:
        weld = contour.role is Role.SEAL
        look = {"color": "#c81e4a", "lw": 3.0} if weld else {"color": "#1f2937", "lw": 0.8}
        axes.plot(*to_mm(contour.line).T, **look)
    axes.set(xlim=(-5.0, width + 5.0), ylim=(-5.0, height + 5.0), aspect="equal")
    _save(figure, "card")


def _moves(file: Path, name: str, colour: str) -> None:
    """The way of a tool: at work thick, between lines thin."""
    lines: list[tuple[bool, list[tuple[float, float]]]] = []
    at = {"X": 0.0, "Y": 0.0}
    for line in file.read_text(encoding="utf-8").splitlines():
        move = _MOVE.match(line)
        if move is None:
            continue
        works, start = move[1] != "0", (at["X"], at["Y"])
        words = {axis: float(number) for axis, number in _AXIS.findall(re.split("[;(]", line)[0])}
        at |= {axis: words[axis] for axis in ("X", "Y") if axis in words}
        if not lines or lines[-1][0] != works:
            lines.append((works, [start]))
        end = at["X"], at["Y"]
        lines[-1][1].extend([end] if move[1] in "01" else _arc(start, end, words, move[1] == "3"))
    points = [point for _, each in lines for point in each]
    width, height = (max(point[k] for point in points) + 5.0 for k in (0, 1))
    scale = 150.0 / width
    figure, axes = _figure(150.0, scale * height)
    for works, each in lines:
        look = {"color": colour, "lw": 1.6} if works else {"color": "#94a3b8", "lw": 0.7, "ls": "--"}
        axes.plot(*zip(*each), **look)
    axes.set(xlim=(0.0, width), ylim=(0.0, height), aspect="equal")
    _save(figure, name)


def _arc(
    start: tuple[float, float], end: tuple[float, float], words: dict[str, float], left: bool
) -> list[tuple[float, float]]:
    """Points along an arc, whose centre counts from its start."""
    x, y = start[0] + words.get("I", 0.0), start[1] + words.get("J", 0.0)
    first, last = (math.atan2(place[1] - y, place[0] - x) for place in (start, end))
    turn = (last - first) % math.tau if left else -((first - last) % math.tau)
    radius = math.hypot(start[0] - x, start[1] - y)
    angles = [first + turn * (k + 1) / 24 for k in range(24)]
    return [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles]


def _print(folder: Path) -> None:
    """The print of the front, and over it the line along which it is cut."""
    import ezdxf
    from matplotlib.image import imread
    from PIL import Image

    Image.MAX_IMAGE_PIXELS = None
    pixels = imread(folder / "artwork-front.png")
    drawing = ezdxf.readfile(folder / "print-front-pattern-silhouette_mm.dxf")
    width, height = (25.4 / 300.0 * pixels.shape[k] for k in (1, 0))
    figure, axes = _figure(110.0, 110.0 * height / width)
    axes.imshow(pixels[::4, ::4], extent=(0.0, width, 0.0, height))
    lines: dict[str, list[list[tuple[float, float]]]] = {}
    for line in drawing.modelspace().query("POLYLINE"):
        lines.setdefault(line.dxf.layer, []).append([(point[0], point[1]) for point in line.points()])
    marks = [point for line in lines["REGISTRATION"] for point in line]
    left, right = min(x for x, _ in marks), max(x for x, _ in marks)
    beside = 0.5 * (width - (right - left))  # the print has so much round the marks, the bar is below them
    up = height - beside - max(y for _, y in marks)
    for line in lines["CUT"]:
        places = [(x - left + beside, y + up) for x, y in [*line, line[0]]]
        axes.plot(*zip(*places), color="#b42318", lw=1.2)
    axes.set(xlim=(0.0, width), ylim=(0.0, height), aspect="equal")
    _save(figure, "print")


def _page(file: Path, number: int, name: str, share: float) -> None:
    """A page of a sheet, so much of it from above."""
    from PIL import Image

    target = IMAGES / f"tutorial-machines-{name}"
    command = ["pdftoppm", "-r", str(_DOTS), "-f", str(number), "-l", str(number), "-singlefile", "-png"]
    subprocess.run([*command, str(file), str(target)], check=True)
    with Image.open(f"{target}.png") as shown:
        width, height = shown.size
        part = shown.crop((0, 0, width, int(share * height))).quantize(64)
    part.save(f"{target}.png", optimize=True)


if __name__ == "__main__":
    main()
