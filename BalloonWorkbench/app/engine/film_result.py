# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solver's result in the Balloon object, in full: for colour maps, animations and files.

The mesh that FreeCAD has keeps six digits and no flat panel. Here are the vertices of the panel, where they
are in the flat and in the inflated film, and in one text what was solved for.
"""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import FreeCAD as App

from BalloonWorkbench.app.properties.property_table import result

PROPERTIES = (
    result("VectorList", "PanelPoints", "Vertices of the flat panel", hidden=True),
    result("IntegerList", "PanelTriangles", "Vertices of each triangle", hidden=True),
    result("IntegerList", "PanelLines", "Vertices along all seams, then along all welds inside", hidden=True),
    result(
        "IntegerList",
        "PanelLineCounts",
        "Number of seams, then the number of vertices of each seam and weld",
        hidden=True,
    ),
    result("VectorList", "FilmPoints", "Vertices of the inflated upper film", hidden=True),
    result(
        "VectorList", "LowerFilmPoints", "Vertices of the lower film where both were simulated", hidden=True
    ),
    result(
        "IntegerList",
        "PanelSizes",
        "Of many panels, for each: number of vertices, of triangles and of loops",
        hidden=True,
    ),
    result(
        "IntegerList",
        "SeamRuns",
        "Of many panels, for each seam: both panels, number of vertices, then those of either side",
        hidden=True,
    ),
    result("FloatList", "SeamEase", "Of many panels, how much longer one side of a seam may be", hidden=True),
    result("String", "SolvedWith", "Film, model and solver of the result", hidden=True),
)


def store(obj, inflation, film, values: dict) -> None:
    """Write a result into the object; values: those of its own properties, by name, that led to it."""
    import numpy as np

    assembly = inflation.assembly
    panels = assembly.panels
    loops = [loop for panel in panels for loop in panel.loops]
    lines = (*loops, *inflation.panel.welds)
    lower = inflation.lower if inflation.lower is not None else np.empty((0, 3))
    rest = np.concatenate([panel.rest_positions for panel in panels])
    flat = np.column_stack([rest, np.zeros(len(rest))])
    obj.PanelPoints, obj.FilmPoints, obj.LowerFilmPoints = map(_vectors, (flat, inflation.positions, lower))
    obj.PanelTriangles = np.concatenate([panel.triangles for panel in panels]).ravel().tolist()
    obj.PanelLines = [vertex for line in lines for vertex in line.tolist()]
    obj.PanelLineCounts = [len(loops), *map(len, lines)]
    obj.PanelSizes = [] if assembly.mirror else _sizes(panels)
    obj.SeamRuns = [] if assembly.mirror else _runs(assembly.seams)
    obj.SeamEase = [] if assembly.mirror else [seam.ease for seam in assembly.seams]
    obj.SolvedWith = json.dumps(
        {
            "film": {key: value for key, value in asdict(film).items() if key != "start_values"},
            "report": _report_data(inflation.report),
            "volume": inflation.volume,
            "values": values,
        }
    )


def is_known(obj) -> bool:
    """There is a result: not so in an empty balloon."""
    return bool(obj.SolvedWith)


def shape(obj) -> tuple:
    """The Assembly of the result and where its vertices are (n, 3) m: quickly, without what the film does."""
    return _assembly(obj), _metres(obj.FilmPoints)


def stored(obj):
    """The Inflation kept by `store` and its Film. Raises InputError where there is none, see `is_known`."""
    import numpy as np

    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.film.film import Film, Look
    from BalloonWorkbench.core.results.film_state import film_state
    from BalloonWorkbench.core.solver.inflation import Inflation, SolveReport
    from BalloonWorkbench.core.solver.lift import Lift
    from BalloonWorkbench.core.solver.model import Model
    from BalloonWorkbench.core.solver.start import vertex_normals

    if not is_known(obj):
        raise InputError(f"{obj.Label} has no result yet: recompute it.")
    data = json.loads(obj.SolvedWith)
    assembly, positions = shape(obj)
    report = data["report"]
    lift = report.get("lift")
    solved = {
        **report,
        "model": Model(**report["model"]),
        **({} if lift is None else {"lift": Lift(lift["gradient"], np.array(lift["held"], dtype=np.int32))}),
    }
    inflation = Inflation(
        assembly,
        positions,
        np.concatenate(
            [
                vertex_normals(own, panel)
                for own, panel in zip(np.split(positions, assembly.offsets[1:-1]), assembly.panels)
            ]
        ),
        np.zeros((sum(len(panel.triangles) for panel in assembly.panels), 2)),
        data["volume"],
        SolveReport(**solved),
        _metres(obj.LowerFilmPoints) if obj.LowerFilmPoints else None,
    )
    made_of = data["film"]
    film = Film(**{**made_of, "sources": tuple(made_of["sources"]), "look": Look(**made_of["look"])})
    return replace(inflation, tensions=film_state(inflation, film).tensions), film


def _assembly(obj):
    """The panels of the result: one that stands for its mirror image, too, or all with their seams."""
    import numpy as np

    from BalloonWorkbench.core.panels.assembly import Assembly
    from BalloonWorkbench.core.panels.panel import Panel
    from BalloonWorkbench.core.panels.seam import Run, Seam

    seams, *counts = obj.PanelLineCounts
    lines = np.split(np.array(obj.PanelLines, dtype=np.int32), np.cumsum(counts)[:-1])
    points, triangles = (
        _metres(obj.PanelPoints)[:, :2],
        np.array(obj.PanelTriangles, dtype=np.int32).reshape(-1, 3),
    )
    if not obj.PanelSizes:
        return Assembly.mirrored(Panel(points, triangles, tuple(lines[:seams]), tuple(lines[seams:])))
    sizes = np.array(obj.PanelSizes).reshape(-1, 3)
    ends = np.cumsum(sizes, axis=0)
    panels = tuple(
        Panel(
            points[end[0] - size[0] : end[0]],
            triangles[end[1] - size[1] : end[1]],
            tuple(lines[end[2] - size[2] : end[2]]),
        )
        for size, end in zip(sizes, ends)
    )
    runs, joined = np.array(obj.SeamRuns, dtype=np.int32), []
    for ease in obj.SeamEase:
        one, other, count = runs[:3].tolist()
        joined.append(Seam(Run(one, runs[3 : 3 + count]), Run(other, runs[3 + count : 3 + 2 * count]), ease))
        runs = runs[3 + 2 * count :]
    return Assembly(panels, tuple(joined))


def _sizes(panels) -> list[int]:
    return [
        size
        for panel in panels
        for size in (len(panel.rest_positions), len(panel.triangles), len(panel.loops))
    ]


def _runs(seams) -> list[int]:
    flat: list[int] = []
    for seam in seams:
        flat += [seam.first.panel, seam.second.panel, len(seam.first.vertices)]
        flat += [*seam.first.vertices.tolist(), *seam.second.vertices.tolist()]
    return flat


def _report_data(report) -> dict:
    """How it was solved, as plain data."""
    data = asdict(report)
    if data.get("lift"):
        data["lift"]["held"] = data["lift"]["held"].tolist()
    return data


def changed_since(obj, values: dict) -> list[str]:
    """Names of those values that differ from the ones the result was solved with."""
    before = json.loads(obj.SolvedWith)["values"] if is_known(obj) else {}
    return [name for name, value in before.items() if values.get(name, value) != value]


def drawing(obj):
    """The drawing that the balloon was fitted to: the outline, at the size that the goal has found."""
    from BalloonWorkbench.app.shapes import part_shapes

    outline = part_shapes.stored(obj.Outline, "Loop")
    width = json.loads(obj.Report)["input"]["width_mm"]
    drawn = obj.Outline.SizeX.Value
    scale = width / drawn if obj.SizeGoal != "Width" and drawn else 1.0
    return outline.map(lambda loop: loop * scale)


def design(obj):
    """The result of two equal panels as the core's Design. Raises what `stored` raises."""
    from BalloonWorkbench.app.shapes import part_shapes
    from BalloonWorkbench.core.design.design import Design, Residual
    from BalloonWorkbench.core.design.silhouette import silhouette
    from BalloonWorkbench.core.units import from_mm

    inflation, _ = stored(obj)
    apart = (obj.ResidualMean.Value, obj.ResidualP95.Value, obj.ResidualMax.Value)
    return Design(
        target=drawing(obj),
        pattern=part_shapes.stored(obj, "Seam"),
        inflation=inflation,
        silhouette=silhouette(inflation),
        residual=Residual(*map(from_mm, apart)),
        passes=obj.Passes,
        meshes=1,
        seconds=0.0,
        reached=obj.Reached,
        warnings=(),
    )


def _vectors(points) -> list:
    import numpy as np

    from BalloonWorkbench.core.units import to_mm

    return [App.Vector(*point) for point in to_mm(np.asarray(points, dtype=float)).tolist()]


def _metres(vectors):
    import numpy as np

    from BalloonWorkbench.core.units import from_mm

    return from_mm(np.array([tuple(vector) for vector in vectors], dtype=float).reshape(-1, 3))
