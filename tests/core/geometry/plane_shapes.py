# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops whose lengths, areas and distances are known."""

import numpy as np


def rectangle(width, height, x=0.0, y=0.0):
    return np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])


def circle(radius, count=400, x=0.0, y=0.0):
    angle = 2 * np.pi * np.arange(count) / count
    return np.column_stack([x + radius * np.cos(angle), y + radius * np.sin(angle)])
