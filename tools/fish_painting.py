# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strokes of the painted example, for the document and for the pictures of the tutorial."""

import math

BODY, FIN, BELLY, STRIPE, DARK = "#1f78d8", "#ff8c1a", "#ffd21f", "#e01b3c", "#1c1c22"


def curve(*places, count=14):
    """A smooth line through places (Catmull and Rom), in parts of the paper."""
    points = []
    line = [places[0], *places, places[-1]]
    for before, start, end, after in zip(line, line[1:], line[2:], line[3:]):
        for step in range(count):
            t = step / count
            points.append(
                tuple(
                    0.5
                    * (
                        2 * b
                        + (c - a) * t
                        + (2 * a - 5 * b + 4 * c - d) * t * t
                        + (3 * b - a - 3 * c + d) * t**3
                    )
                    for a, b, c, d in zip(before, start, end, after)
                )
            )
    return [*points, places[-1]]


def circle(x, y, r, count=16):
    """A closed line round a place, in parts of the paper."""
    turns = [2 * math.pi * k / count for k in range(count + 1)]
    return [(x + r * math.cos(turn), y + r * math.sin(turn)) for turn in turns]


#: The rim in one stroke, from the mouth over the back, round the tail and back along the belly.
RIM = curve(
    (0.08, 0.53),
    (0.15, 0.38),
    (0.31, 0.26),
    (0.44, 0.20),
    (0.56, 0.27),
    (0.68, 0.38),
    (0.80, 0.30),
    (0.93, 0.24),
    (0.90, 0.40),
    (0.87, 0.50),
    (0.90, 0.61),
    (0.93, 0.77),
    (0.80, 0.70),
    (0.68, 0.61),
    (0.55, 0.71),
    (0.40, 0.78),
    (0.27, 0.73),
    (0.15, 0.66),
    (0.08, 0.53),
)
EYE, PUPIL = circle(0.235, 0.435, 0.036), circle(0.228, 0.437, 0.012, 10)
MOUTH = curve((0.085, 0.545), (0.13, 0.575), (0.18, 0.57))
STRIPES = [
    curve((x, 0.5 - h), (x + 0.035, 0.48), (x + 0.01, 0.5 + 0.9 * h))
    for x, h in ((0.37, 0.20), (0.49, 0.20), (0.61, 0.13))
]
TAIL_LINE = curve((0.70, 0.375), (0.735, 0.50), (0.70, 0.622))
FILLS = ((0.28, 0.60, BELLY), (0.84, 0.50, FIN))


def steps(side):
    """What the paint window would have made of it."""
    from BalloonWorkbench.gui.paint.painting.strokes import BRUSH, PEN, Fill, PaintStroke

    def stroke(tool, colour, places, width):
        return PaintStroke(tool, colour, points=[(side * x, side * y, width) for x, y in places])

    yield stroke(PEN, BODY, RIM, 16.0)
    yield stroke(PEN, BODY, TAIL_LINE, 12.0)
    for x, y, colour in FILLS:
        yield Fill(colour, side * x, side * y)
    for places in STRIPES:
        yield stroke(BRUSH, STRIPE, places, 38.0)
    yield stroke(PEN, DARK, EYE, 10.0)
    yield Fill("#ffffff", side * 0.25, side * 0.42)
    yield stroke(PEN, DARK, PUPIL, 16.0)
    yield stroke(PEN, DARK, MOUTH, 10.0)
