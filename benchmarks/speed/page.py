# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/benchmarks.md from the measurements."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from speed import account, cases, evolver

#: What is aimed at.
COLD, COLD_WORST, GROWTH, WARM, NATIVE, MEMORY = 30.0, 60.0, 1.4, 6.0, 5.0, 1500.0
START = 50.0
DRAFT, FITTED = 0.1, 1.5  # s
AGAINST_EVOLVER = {2000: 25.0, 10000: 50.0}

_HEAD = """\
# Speed

Written by `make bench`; every number comes from one run on one machine, so that only ratios matter.
The unit is the yardstick: one numerical factorisation of the same tangent matrix (all positions and
directors) by CHOLMOD's supernodal Cholesky with OpenBLAS on one thread. Times are processor seconds
of all threads, medians over the repeats; a machine that is busy with other things lengthens them by
some ten per cent, and all of them alike.

{machine}

The balloons: outlines of 0.3 m (`tests/core/drawn_shapes.py`), film "{film}", {pressure:g} kPa, on
an even mesh. Cold is `inflate()` from the flat panel; warm is after a point of the rim was pulled
outward by {edit:.0f} % of the width (the rim follows as a Gaussian of {reach:.0f} % of the width),
from the state before. The whole process is meshing and cold inflation; its growth exponent is the
least-squares slope of log time over log vertices through all sizes (beside it, for the two largest
alone: there the factorisation of a plane mesh rules, which grows with the power 1.5 for anybody).
"""

_EVOLVER = """\
## Surface Evolver

The same mesh, film, pressure and start in Surface Evolver 2.70 (`{program}`, Debian), without
bending and without a sealed band, which it does not have: `benchmarks/speed/evolver.py` writes the
datafile and holds the script. Its facet energy `relaxed_elastic_A` is the same tension field; it is
led by conjugate gradients from a softer film. Two softenings are run and the faster one counts.

Like is compared with like, in processor seconds:

- At rest: each until it stops by itself; Evolver when its volume moves by less than 5e-5 in a long window
  of steps. The aim counts this, for it is what a user waits for: nobody knows the last volume before.
- To 0.1 %: each until its volume stays within 0.1 % of its own last one, found afterwards.
- With band: ours as the workbench runs it, with the sealed band that a real balloon has, until it stops by
  itself. A rim without a band crumples at the size of the mesh, which costs both programs many steps.

Volumes are those of the facets, without a band.

"""


_COMMANDS_TITLE = "Whole commands"
_COMMANDS = """\
## {title}

Processor time of a command and of all processes that it starts, FreeCAD's among them, on one core. The
yardstick here is a cold inflation of the disc at 2000 vertices, right before and after. To load the command
line, with Python and NumPy, took {loading:.2f} s.

{table}"""
_STROKES_TITLE = "From a stroke to the balloon"
_STROKES = """\
## {title}

{count} strokes in the paint window under Xvfb, drawn by Mesa without a graphics card, with the X server's own
mouse: a fish, then other shapes, some of them quick. By the clock, from the button that comes up to the end
of the frame that shows the balloon in the 3D view; the first two, {first} to the draft, begin as soon as the
window is there. Work is the processor time of all threads on the way, as a median. Run of {date}; processes
that wanted a processor before it: {load:.1f} on average.

{table}"""


def written(measured: dict[str, Any]) -> str:
    """The page."""
    parts = [
        _HEAD.format(
            machine=_machine(measured),
            film=cases.sealed_film().name,
            pressure=cases.PRESSURE / 1e3,
            edit=100 * cases.EDIT,
            reach=100 * cases.EDIT_REACH,
        ),
        "## Against the aims\n\n" + _table(("aim", "found", ""), _aims(measured)),
        _commands(measured["commands"], measured["loading"]),
        _strokes(measured["strokes"]),
        "## Cold and warm\n\n" + _solves(measured["solves"]),
        account.section(_done(measured["solves"]), _table),
    ]
    if measured["numpy"]:
        parts.append("## Native against NumPy\n\n" + _numpy(measured["numpy"]))
    if measured["evolver"]:
        parts.append(_EVOLVER.format(program=evolver.PROGRAM) + _evolver(measured["evolver"]))
    return "\n".join(parts)


def with_strokes(text: str, measured: dict[str, Any] | None) -> str:
    """The page with its part about strokes, or with it for the first time."""
    return _with(text, _STROKES_TITLE, _strokes(measured))


def with_commands(text: str, measured: list[dict[str, Any]], loading: float) -> str:
    """The page with its part about whole commands, or with it for the first time."""
    return _with(text, _COMMANDS_TITLE, _commands(measured, loading))


def _with(text: str, title: str, part: str) -> str:
    head, aims, *rest = (other for other in text.split("\n## ") if not other.startswith(title))
    return "\n## ".join([head, aims, part.removeprefix("## "), *rest])


def _commands(measured: list[dict[str, Any]], loading: float) -> str:
    aims = ["" if one["aim"] is None else f"{one['aim']:g} s" for one in measured]
    rows = [
        (one["command"], f"{one['cpu']:.2f} s", f"**{one['yardsticks']:.1f}**", aim)
        for one, aim in zip(measured, aims, strict=True)
    ]
    head = ("command", "processor time", "yardsticks", "aim, of an idle processor")
    return _COMMANDS.format(title=_COMMANDS_TITLE, table=_table(head, rows), loading=loading)


def with_account(text: str, measured: dict[str, Any]) -> str:
    """The page with a new account of where the time goes."""
    return account.replaced(text, account.section(measured["solves"], _table, _machine(measured) + "\n\n"))


def _strokes(measured: dict[str, Any] | None) -> str:
    """From a stroke to the balloon on the screen."""
    if measured is None:
        return f"## {_STROKES_TITLE}\n\nNot measured: that takes FreeCAD and Xvfb.\n"
    rows = []
    for what, aim in (("draft", DRAFT), ("fitted", FITTED)):
        times = [one[what] for one in measured["rows"] if one[what] is not None]
        work = [one[f"{what}_work"] for one in measured["rows"] if one[what] is not None]
        median = float(np.median(times))
        rows.append(
            (
                f"{what} balloon",
                f"**{1e3 * median:.0f} ms**",
                f"{1e3 * min(times):.0f} to {1e3 * max(times):.0f} ms",
                f"{len([time for time in times if time > aim])} of {len(times)}",
                f"{1e3 * np.median(work):.0f} ms",
                f"{1e3 * aim:.0f} ms",
                "met" if median <= aim and len(times) == len(measured["rows"]) else "**missed**",
            )
        )
    head = ("from the end of a stroke to the", "median", "all", "longer than the aim", "work", "aim", "")
    first = ", ".join(f"{1e3 * one['draft']:.0f} ms" for one in measured["rows"][:2] if one["draft"])
    return _STROKES.format(
        title=_STROKES_TITLE,
        count=len(measured["rows"]),
        table=_table(head, rows),
        first=first,
        date=measured["date"],
        load=measured["load"],
    )


def _table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def _machine(measured: dict[str, Any]) -> str:
    machine = measured["machine"]
    return (
        f"Run of {measured['date']}: {machine['processor']}, {machine['threads']} threads,"
        f" {machine['system']}, Python {machine['python']}, NumPy {machine['numpy']},"
        f" SciPy {machine['scipy']}. Processes that wanted a processor: {measured['load_before']:.1f} on"
        f" average before the run, {measured['load_after']:.1f} after it."
    )


def _done(solves: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [one for one in solves if "cold" in one]


def _rods(one: dict[str, Any], kind: str = "cold") -> float:
    return float(one[kind]["cpu"] / one["yardstick"]["factor_seconds"])


def _beyond(one: dict[str, Any]) -> float | None:
    """Bytes a vertex at the peak, without what our factorisation of the same matrix takes by itself."""
    if one["peak_bytes"] is None:
        return None
    return float(one["peak_bytes"] - one["yardstick"]["ours"]["peak_bytes"]) / one["vertices"]


def growth(solves: list[dict[str, Any]]) -> dict[str, tuple[float, float]]:
    """Exponents of the processor time of meshing and cold inflation in the number of vertices, by shape.

    Over all sizes, and between the two largest.
    """
    found = {}
    for shape in dict.fromkeys(one["shape"] for one in solves):
        mine = [one for one in _done(solves) if one["shape"] == shape]
        if len(mine) > 1:
            count = np.log([one["vertices"] for one in mine])
            whole = np.log([one["mesh"]["cpu"] + one["cold"]["cpu"] for one in mine])
            last = (whole[-1] - whole[-2]) / (count[-1] - count[-2])
            found[shape] = float(np.polyfit(count, whole, 1)[0]), float(last)
    return found


#: An aim, what was measured, and whether that meets it.
Aim = tuple[str, str, bool]


def _aims(measured: dict[str, Any]) -> list[tuple[str, str, str]]:
    solves = measured["solves"]
    aims = [*_cold_aims(solves), *_growth_aim(solves), *_warm_aim(solves), *_native_aim(measured["numpy"])]
    aims += [*_memory_aim(solves), *_evolver_aims(measured["evolver"])]
    if measured["start_ms"] is not None:
        start = measured["start_ms"]
        aims.append(
            (f"start of FreeCAD: below {START:g} ms for the workbench", f"{start:.0f} ms", start < START)
        )
    return [(aim, value, "met" if met else "**missed**") for aim, value, met in aims]


def _cold_aims(solves: list[dict[str, Any]]) -> Iterator[Aim]:
    done = _done(solves)
    shapes = list(dict.fromkeys(one["shape"] for one in done))
    worst = {shape: max(_rods(one) for one in done if one["shape"] == shape) for shape in shapes}
    left_out = len(solves) - len(done)
    usual = max(worst[shape] for shape in shapes if shape != "star") if set(shapes) - {"star"} else 0.0
    yield (
        f"cold: at most {COLD:g} yardsticks at every size (disc, square)",
        f"at most {usual:.0f}" + (f"; {left_out} sizes left out" if left_out else ""),
        usual <= COLD and not left_out,
    )
    yield (
        f"cold, the worst outline: at most {COLD_WORST:g}",
        f"{max(worst.values()):.0f}",
        max(worst.values()) <= COLD_WORST,
    )


def _growth_aim(solves: list[dict[str, Any]]) -> Iterator[Aim]:
    powers = growth(solves)
    if powers:
        yield (
            f"growth exponent of the whole process: at most {GROWTH:g}",
            ", ".join(f"{shape} {power:.2f} (last {last:.2f})" for shape, (power, last) in powers.items()),
            max(power for power, _ in powers.values()) <= GROWTH,
        )


def _warm_aim(solves: list[dict[str, Any]]) -> Iterator[Aim]:
    warm = [_rods(one, "warm") for one in _done(solves)]
    yield f"warm edit: at most {WARM:g} yardsticks", f"{min(warm):.1f} to {max(warm):.1f}", max(warm) <= WARM


def _native_aim(in_numpy: list[dict[str, Any]]) -> Iterator[Aim]:
    if in_numpy:
        ratios = [one["cold"]["cpu"] / one["native_cpu"] for one in in_numpy]
        yield (
            f"native at least {NATIVE:g} times faster than NumPy",
            f"{min(ratios):.1f} to {max(ratios):.1f}",
            min(ratios) >= NATIVE,
        )


def _memory_aim(solves: list[dict[str, Any]]) -> Iterator[Aim]:
    large = [one for one in _done(solves) if one["vertices"] > 1500]
    beyond = [memory for one in large if (memory := _beyond(one)) is not None]
    if beyond:
        most = max(beyond)
        yield (
            f"memory beyond the factor: below {MEMORY / 1e3:g} kB a vertex",
            f"at most {most / 1e3:.1f} kB",
            most < MEMORY,
        )


def _evolver_aims(solves: list[dict[str, Any]]) -> Iterator[Aim]:
    for size, aim in AGAINST_EVOLVER.items():
        ratios = [one["evolver"]["total"] / one["cold"]["cpu"] for one in solves if one["wanted"] == size]
        if ratios:
            yield (
                f"at most 1/{aim:g} of Surface Evolver's time at {size} vertices",
                ", ".join(f"1/{ratio:.0f}" for ratio in ratios) + " (both at rest)",
                min(ratios) >= aim,
            )


def _solves(solves: list[dict[str, Any]]) -> str:
    head = (
        "outline",
        "vertices",
        "yardstick, ms",
        "our factorisation, yardsticks",
        "cold, yardsticks",
        "cold, s",
        "on the clock, s",
        "steps (factorisations)",
        "warm, yardsticks",
        "warm steps",
        "meshing, s",
        "peak memory, kB a vertex",
        "beyond the factor",
    )
    rows = []
    for one in solves:
        if "cold" not in one:
            rows.append(
                (one["shape"], str(one["wanted"]), f"left out: {one['expected']:.0f} s expected", *[""] * 10)
            )
            continue
        cold, warm, beyond = one["cold"], one["warm"], _beyond(one)
        rows.append(
            (
                one["shape"],
                str(one["vertices"]),
                f"{1e3 * one['yardstick']['factor_seconds']:.3g}",
                f"{one['yardstick']['ours']['factor_seconds'] / one['yardstick']['factor_seconds']:.2f}",
                f"**{_rods(one):.1f}**" + _unfinished(cold),
                f"{cold['cpu']:.3g} ({cold['cpu_least']:.3g} to {cold['cpu_most']:.3g})",
                f"{cold['wall']:.3g}",
                f"{cold['steps']} ({cold['factorisations']})",
                f"**{_rods(one, 'warm'):.1f}**" + _unfinished(warm),
                f"{warm['steps']} ({warm['factorisations']})",
                f"{one['mesh']['cpu']:.2g}",
                "" if one["peak_bytes"] is None else f"{one['peak_bytes'] / one['vertices'] / 1e3:.1f}",
                "" if beyond is None else f"{beyond / 1e3:.1f}",
            )
        )
    note = (
        "\nOur factorisation is the solver's own, of the same matrix on one thread. Peak memory is the growth"
        " of the process during the first cold solve; beyond the factor is what remains of it without the"
        " same growth of a fresh process that does nothing but analyse, factor and solve with this matrix"
        " once, on as many threads as the solver takes.\n"
    )
    return _table(head, rows) + note


def _unfinished(run: dict[str, Any]) -> str:
    return "" if run["converged"] else " (not converged)"


def _numpy(runs: list[dict[str, Any]]) -> str:
    rows = [
        (
            one["shape"],
            str(one["vertices"]),
            f"{one['native_cpu']:.3g}",
            f"{one['cold']['cpu']:.3g}",
            f"**{one['cold']['cpu'] / one['native_cpu']:.1f}**",
        )
        for one in runs
    ]
    return _table(("outline", "vertices", "native, s", "NumPy, s", "ratio"), rows)


def _evolver(runs: list[dict[str, Any]]) -> str:
    head = (
        "outline",
        "vertices",
        "ours at rest, s",
        "Evolver at rest, s",
        "**ours / Evolver, at rest**",
        "ours to 0.1 %, s",
        "Evolver to 0.1 %, s",
        "ours / Evolver, to 0.1 %",
        "ours with band, s",
        "ours with band / Evolver at rest",
        "steps: ours, Evolver's",
        "our volume / L^3",
        "Evolver's",
        "difference",
    )
    rows = []
    for one in runs:
        theirs = one["evolver"]
        ours, early, sealed = one["cold"], one["visible"], one["sealed"]
        rows.append(
            (
                one["shape"],
                str(one["vertices"]),
                f"{ours['cpu']:.3g}" + _unfinished(ours),
                f"{theirs['total']:.3g}" + _unfinished(theirs),
                f"**1/{theirs['total'] / ours['cpu']:.0f}**",
                f"{early['cpu']:.3g}",
                f"{theirs['seconds']:.3g}",
                f"1/{theirs['seconds'] / early['cpu']:.0f}",
                f"{sealed['cpu']:.3g}" + _unfinished(sealed),
                f"1/{theirs['total'] / sealed['cpu']:.0f}",
                f"{ours['steps']}, {theirs['all_steps']}",
                f"{one['facet_volume']:.6f}",
                f"{theirs['volume']:.6f}",
                f"{100 * (one['facet_volume'] / theirs['volume'] - 1):+.2f} %",
            )
        )
    return _table(head, rows)
