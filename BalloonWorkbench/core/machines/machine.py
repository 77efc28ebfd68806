# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machines we know: what their programs read, and how lines are told apart there.

One file each in resources/machines, and those of the user's own in a folder (`own_folder`), which come first.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.arcs.fit_arcs import TOLERANCE
from BalloonWorkbench.core.errors import InputError
from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, data_files, read_data, reason_of
from BalloonWorkbench.core.machines.layers import Line, check_laser, layers_of, number_in, one_of
from BalloonWorkbench.core.machines.marks.style import CROSSES, Marks, read_marks
from BalloonWorkbench.core.machines.tool import (
    CONTROLLERS,
    GRBL,
    LINUXCNC,
    MachineTool,
    changed,
    lacking,
    read_tool,
)
from BalloonWorkbench.core.options.making import NO_TABS, TabOptions, ToolOptions
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.units import INCH, MILLIMETRE, from_mm, number_text, parse_size, to_mm

FOLDER = RESOURCES / "machines"

#: Endings of the formats, and the versions that each has.
ENDINGS = {"dxf": "dxf", "svg": "svg", "pdf": "pdf", "hpgl": "plt", "lbrn2": "lbrn2", "gcode": "gcode"}
_VERSIONS = {"dxf": ("R2000", "R12"), "svg": ("",), "pdf": ("",), "hpgl": ("",), "lbrn2": ("",),
             "gcode": CONTROLLERS}  # fmt: skip
#: The bed of a machine that has none.
NO_LIMIT = "none"
_LEAST_BED, _MOST = 10.0, 1e5  # mm
#: Lengths of a machine's file, and from where to where they go [mm].
LIMITS = {
    "kerf_mm": (0.0, 20.0), "knife_offset_mm": (0.0, 20.0), "overcut_mm": (0.0, 100.0),
    "overrun_mm": (0.0, 1000.0), "least_radius_mm": (0.0, _MOST), "least_gap_mm": (0.0, _MOST),
    "tolerance_mm": (0.005, 0.5),
}  # fmt: skip
UNITS = {"mm": MILLIMETRE, "in": INCH}
#: After so many offsets a knife that came down turned by 175 degrees is 7 degrees off: the tangent of half
#: the angle falls by e for each.
_SWING = 6.0
#: What a machine does to the film that not every film takes; "" where nothing is known of it.
PROCESSES = ("", "laser", "heat-sealing")
#: What files are about whose name tells no more.
_PATTERN = "pattern"
_FILE_NAME = re.compile(r"[\w .-]{0,60}")


@dataclass(frozen=True)
class Machine:
    """What a machine's program wants.

    format     one of ENDINGS; version is R2000 or R12 for DXF, the controller for G-code
    unit       of the coordinates, "mm" or "in"
    arcs       arcs where they fit, else polylines only; tolerance how far they may be from the points [m]
    layers     the roles that are written
    bed        width and height that it can work on [m], None where there is no limit; the height of a roll is
               infinite
    kerf       width that the beam takes away; knife_offset of a swivel knife behind its axis; overcut of a
               closed cut and overrun of a closed weld past its start; least_radius and least_gap that it
               can follow [m]
    control_bar  a bar of 100 mm on the layer REGISTRATION
    process    one of PROCESSES
    tool       what a machine that reads G-code holds; None for all others
    file       name of its file without the ending, where it is not made from the machine's
    marks      by which it finds a print again
    remarks    on the machine's file, a sentence each
    tabs       what it leaves of each cut
    """

    name: str
    title: str
    note: str
    format: str
    version: str
    unit: str
    arcs: bool
    layers: Mapping[Role, Line]
    bed: tuple[float, float] | None
    kerf: float
    knife_offset: float
    overcut: float
    overrun: float
    least_radius: float
    least_gap: float
    control_bar: bool
    file: str = ""
    tolerance: float = TOLERANCE
    process: str = ""
    tool: MachineTool | None = None
    marks: Marks = CROSSES
    remarks: tuple[str, ...] = ()
    tabs: TabOptions = NO_TABS

    @property
    def spots(self) -> tuple[str, ...]:
        """The spot colours by which a print shop's program knows what is cut; most machines have none."""
        return tuple(dict.fromkeys(line.spot for line in self.layers.values() if line.spot))

    @property
    def file_name(self) -> str:
        """A name that tells the machine, and the unit where the format may leave it open."""
        return self.file_of(_PATTERN)

    def file_of(self, subject: str) -> str:
        """The same name about a certain thing, "fish-lightburn_mm.dxf"; a file that has a name keeps it."""
        unit = f"_{self.unit}" if self.format == "dxf" else ""
        stem = subject if self.file == _PATTERN else self.file or f"{subject}-{self.name}{unit}"
        return f"{stem}.{'ngc' if self.version == LINUXCNC else ENDINGS[self.format]}"


def own_folder() -> Path:
    """Where the user's own machines are: BALLOON_MACHINES, else .film-balloon/machines in the home folder."""
    chosen = os.environ.get("BALLOON_MACHINES")
    return Path(chosen) if chosen else Path.home() / ".film-balloon" / "machines"


def machines() -> dict[str, Machine]:
    """All machines by name: those for any program, then in alphabetical order; one of the user's own takes
    the place of ours. Own files of no use are left out, see `left_out`.

    Raises InputError when a data file of ours is of no use.
    """
    known = {path.stem: read_machine(path) for path in sorted(FOLDER.glob("*.json"))}
    known |= {path.stem: own for path, own in own_machines().items() if isinstance(own, Machine)}
    return {name: known[name] for name in sorted(known, key=lambda name: (name not in ANY.values(), name))}


def left_out() -> list[str]:
    """A sentence for each file in the user's folder that is of no use."""
    return [f"{error} It is left out." for error in own_machines().values() if isinstance(error, InputError)]


def own_machines() -> dict[Path, Machine | InputError]:
    """The user's machines by their files, or what is wrong with these."""
    own: dict[Path, Machine | InputError] = {}
    for path in data_files(own_folder):
        try:
            own[path] = read_machine(path)
        except InputError as error:
            own[path] = error
    return own


#: The machines that stand for any program, by format.
ANY = {"dxf": "any-dxf", "svg": "any-svg"}


def machine(name: str, bed: str | None = None) -> Machine:
    """The machine of this name, or the one that a file (.json) describes; with another bed, see parse_bed.

    Raises InputError with the known names when there is none.
    """
    chosen = _known_machine(name)
    return chosen if bed is None else replace(chosen, bed=parse_bed(bed))


def holding(machine: Machine, wishes: ToolOptions) -> Machine:
    """The machine with the tool that the user wishes; those that read no G-code hold what they hold.

    Raises InputError for a tool that makes no sense.
    """
    if machine.tool is None:
        return machine
    tool = changed(machine.tool, wishes)
    same = tool.kind == machine.tool.kind
    layers = machine.layers if same else layers_of({role.value: {} for role in tool.roles})
    return replace(machine, tool=tool, layers=layers, process=tool.process)


def complete(held: Machine) -> Machine:
    """The same machine; InputError where its tool lacks what only the user knows."""
    if held.tool and (missing := lacking(held.tool, held.version)):
        raise InputError(f"{held.title}: {missing}")
    return held


def parse_bed(text: str, plain: str = "") -> tuple[float, float] | None:
    """'600mmx400mm', '600mm' for a roll so wide, 'none' where there is no limit -> width and height [m].

    Numbers alone are in the plain unit; without one they are refused. InputError for what is no bed.
    """
    if text.strip().lower() == NO_LIMIT:
        return None
    has_unit = plain or set(text.lower()) & set('mcinft"')
    width, height = parse_size(text, plain)
    for length in (width, height):
        if not has_unit or (length is not None and not _LEAST_BED <= to_mm(length) <= _MOST):
            raise InputError(
                f"A bed is {number_text(_LEAST_BED)} mm to {number_text(_MOST)} mm wide and high: write"
                f" 600mmx400mm, 600mm for a roll, or {NO_LIMIT}."
            )
    return width, math.inf if height is None else height


def bed_text(bed: tuple[float, float] | None) -> str:
    """A bed as parse_bed reads it."""
    if bed is None:
        return NO_LIMIT
    return " x ".join(f"{number_text(to_mm(length), 6)} mm" for length in bed if math.isfinite(length))


def _known_machine(name: str) -> Machine:
    if name.lower().endswith(".json"):
        return read_machine(Path(name))
    known, plain = machines(), "-".join(name.lower().split())
    for path, own in own_machines().items():  # never ours in the place of the user's: its numbers are others
        if path.stem == plain and isinstance(own, InputError):
            raise own
    named = known.get(plain)
    if named is None:
        raise InputError(
            f'There is no machine "{name}": choose one of {", ".join(known)}, or give a .json file.'
        )
    return named


def read_machine(path: Path) -> Machine:
    """The machine described by a data file, checked; keys carry their units.

    Raises InputError that names the file and the value.
    """
    try:
        described = machine_of(read_data(path))
    except KeyError as error:
        raise InputError(f"The machine file {path.name} lacks {error}: add it.") from error
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"The machine file {path.name} is of no use: {reason_of(error)}") from error
    if described.name != path.stem:
        raise InputError(
            f'The machine file {path.name} calls itself "{described.name}": give both the same name.'
        )
    return described


#: Files made before notches, folds and drawn marks had layers of their own have one for all of them. It may
#: be one that is cut, and a fold goes across the neck: only notches are written there.
_MARK, _NOTCH = "MARK", Role.NOTCH.value
_KEYS = {
    "name", "title", "note", "format", "version", "unit", "arcs", "bed_mm", "kerf_mm", "knife_offset_mm",
    "overcut_mm", "overrun_mm", "control_bar", "file", "tolerance_mm", "least_radius_mm", "least_gap_mm",
    "layers", "process", "tool", "marks",
}  # fmt: skip


def machine_of(data: dict[str, Any]) -> Machine:
    """The machine that the content of a file describes, checked. Raises InputError, or one of UNUSABLE."""
    strange = sorted(set(data) - _KEYS)
    if strange:
        raise InputError(f'nobody knows "{strange[0]}": it may be one of {", ".join(sorted(_KEYS))}.')
    kind = one_of(data["format"], tuple(ENDINGS), "format")
    tool = _tool(data, kind)
    marked = dict(data["layers"])
    if _NOTCH in marked:
        marked.pop(_MARK, None)
    described = Machine(
        name=str(data["name"]),
        title=str(data["title"]),
        note=str(data["note"]),
        format=kind,
        version=one_of(data["version"], _VERSIONS[kind], "version"),
        unit=one_of(data["unit"], tuple(UNITS), "unit"),
        arcs=_truth(data["arcs"], "arcs"),
        layers=layers_of({_NOTCH if key == _MARK else key: line for key, line in marked.items()}),
        bed=_bed(data["bed_mm"]),
        kerf=_length(data["kerf_mm"], "kerf_mm"),
        knife_offset=_length(data["knife_offset_mm"], "knife_offset_mm"),
        overcut=_overcut(data),
        overrun=_length(data["overrun_mm"], "overrun_mm"),
        least_radius=_length(data["least_radius_mm"], "least_radius_mm"),
        least_gap=_length(data["least_gap_mm"], "least_gap_mm"),
        control_bar=_truth(data["control_bar"], "control_bar"),
        file=str(data.get("file", "")),
        tolerance=_length(data.get("tolerance_mm", to_mm(TOLERANCE)), "tolerance_mm"),
        process=one_of(data.get("process", tool.process if tool else ""), PROCESSES, "process"),
        tool=tool,
        marks=read_marks(data),
        remarks=_remarks(data),
    )
    if not _FILE_NAME.fullmatch(described.file):
        raise InputError(
            f'the file name "{described.file}" may have letters, digits, spaces, _, - and . only.'
        )
    if kind in ("hpgl", "pdf", "lbrn2", "gcode") and described.unit != "mm":
        raise InputError(f'a {kind.upper()} file has a unit of its own: give "unit": "mm".')
    check_laser([(line.name, line.pen, line.laser) for line in described.layers.values()], kind == "lbrn2")
    if kind != "pdf" and described.spots:
        raise InputError('only a PDF has spot colours: give "format": "pdf", or leave them out.')
    if kind == "hpgl" and described.arcs:
        raise InputError('HPGL is written as polylines: give "arcs": false.')
    if tool is not None and tool.turning_axis:
        _check_turning(described)
    return described


def _check_turning(described: Machine) -> None:
    """InputError for a tool that the machine cannot turn, or that turns already."""
    if described.version == GRBL:
        raise InputError(
            "GRBL knows X, Y and Z only: leave turning_axis out, or take LinuxCNC or Marlin where an axis"
            " turns the tool."
        )
    if described.knife_offset > 0.0:
        raise InputError(
            "A tool that an axis turns does not swivel behind it: set knife_offset_mm to 0, or leave"
            " turning_axis out."
        )


def _tool(data: dict[str, Any], kind: str) -> MachineTool | None:
    """The tool of a machine that reads G-code, which has one."""
    if (kind == "gcode") != ("tool" in data):
        raise InputError("G-code, and no other format, has a tool: give both or none.")
    return read_tool(data["tool"]) if "tool" in data else None


def _remarks(data: dict[str, Any]) -> tuple[str, ...]:
    """What to say about a machine's file that may be used as it is."""
    if _MARK not in data["layers"]:
        return ()
    return (
        f"The layer MARK of the machine file {data['name']}.json takes notches only. Rename it NOTCH, and"
        " where your machine can draw, add the layers FOLD and PEN.",
    )


def _overcut(data: dict[str, Any]) -> float:
    """As it is given, else what a swivel knife takes to swing into its direction."""
    return _length(data.get("overcut_mm", _SWING * data["knife_offset_mm"]), "overcut_mm")


def _truth(value: object, what: str) -> bool:
    if not isinstance(value, bool):
        raise InputError(f"{what} is {value!r}: write true or false.")
    return value


def _bed(value: object) -> tuple[float, float] | None:
    if value is None:
        return None
    if not (isinstance(value, list) and len(value) == 2):
        raise InputError(
            f"bed_mm is {value!r}: give [width, height], [width, null] for a roll, or null where there is no"
            " limit."
        )
    width, height = value
    return _length(width, "bed_mm"), math.inf if height is None else _length(height, "bed_mm")


def _length(value: object, what: str) -> float:
    return from_mm(number_in(value, what, *LIMITS.get(what, (_LEAST_BED, _MOST))))
