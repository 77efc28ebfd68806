# SPDX-License-Identifier: LGPL-2.1-or-later
"""How each role looks where a machine does not say otherwise: in files, in pictures and in the 3D view."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.pattern.pattern import Role


@dataclass(frozen=True)
class Layer:
    """How a role is drawn: AutoCAD colour index and RGB. Cutters go by the name or by one of the colours."""

    aci: int
    rgb: str


LAYERS = {
    Role.CUT: Layer(1, "#ff0000"),
    Role.CUT_INNER: Layer(5, "#0000ff"),
    Role.SEAL: Layer(6, "#ff00ff"),
    Role.WELD: Layer(3, "#00a000"),
    Role.NOTCH: Layer(30, "#ff8000"),
    Role.FOLD: Layer(150, "#0080ff"),
    Role.PEN: Layer(34, "#804000"),
    Role.ENGRAVE: Layer(7, "#000000"),
    Role.PRINT: Layer(8, "#808080"),
    Role.REGISTRATION: Layer(4, "#00ffff"),
}
