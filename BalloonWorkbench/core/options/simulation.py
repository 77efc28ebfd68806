# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a balloon is inflated, and what is simulated."""

from __future__ import annotations

from dataclasses import dataclass

from BalloonWorkbench.core.options.option import Kind, Section

INFLATION = Section("Inflation")
SOLVER, SIMULATION = Section("Inflation", page="Solver"), Section("Simulation", page="Solver")
#: How a weld bends in its plane.
ELASTIC, CRUMPLED = "elastic", "crumpled"


# fmt: off
@dataclass(frozen=True)
class InflationOptions:
    """What a balloon is inflated to, and how fine.

    pressure [Pa]; mesh_size [m] and backend None where the engine chooses; correct False keeps the outline
    itself as the pattern; a volume [m3] takes the place of the pressure.
    """

    correct: bool = INFLATION(Kind.CHOICE, True,
        "Correct the pattern until the balloon looks like the drawing, or not", label="Mode", prop="Mode",
        flag="", choices={True: "Fit to drawing", False: "Inflate as drawn"})
    pressure: float = INFLATION(Kind.PRESSURE, 2000.0, "Pressure inside, above that outside",
        label="Pressure", least=1e-3, step=0.1, rivals="load", preference="Pressure")
    volume: float | None = SOLVER(Kind.VOLUME, None, "Volume of the balloon, from which the pressure follows",
        label="Volume", prop="TargetVolume", flag="--gas-volume", rivals="load")
    mesh_size: float | None = SOLVER(Kind.LENGTH, None, "Size of the triangles; 0 is automatic",
        label="Mesh size", preference="Mesh size (0: automatic)")
    backend: str | None = SOLVER(Kind.CHOICE, None,
        "Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly",
        label="Solver", flag="--solver",
        choices={None: "Automatic", "native": "Native", "numpy": "NumPy", "newmark": "Newmark"},
        rivals="solver", preference="Solver")


@dataclass(frozen=True)
class ModelOptions:
    """What is simulated; values other than these are for comparison.

    tension_field  the film wrinkles; False: it carries compression, like a plain shell
    bending        DKT bending; without it the step count grows with the mesh
    bending_floor  smallest flexural rigidity, in p w^3 with w the typical width of the panel: below it the
                   step count grows with the mesh and nothing visible changes
    two_panels     both panels are simulated, tied at the seam; False: one, with its rim in the plane of
                   symmetry
    weld           how it bends in its plane: as an elastic band, or as film that crumples freely; a real one
                   is between these bounds
    """

    tension_field: bool = SIMULATION(Kind.CHOICE, True,
        "Film that wrinkles where it is compressed, or a shell that does not, for comparison", label="Model",
        prop="Model", flag="--plain-shell", choices={True: "Tension field", False: "Plain shell"})
    bending: bool = SIMULATION(Kind.FLAG, True, "The film resists bending", label="Bending stiffness",
        flag="--no-bending", typed="Film without bending stiffness")
    bending_floor: float = SIMULATION(Kind.NUMBER, 1e-6,
        "Least bending stiffness, in units of the usual least one", scale=1e-6, metavar="D",
        typed="Least bending stiffness in p w^3, w the typical width")
    two_panels: bool = SIMULATION(Kind.FLAG, False,
        "Simulate both panels instead of one and its mirror image", label="Both panels")
    weld: str = SIMULATION(Kind.CHOICE, ELASTIC,
        "Weld that resists bending in its plane, or film that crumples there freely, the worst for a ring",
        label="Weld", choices={ELASTIC: "Elastic", CRUMPLED: "Crumpled"})
