# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user wants a new balloon to begin with; kept in FreeCAD's parameters, read and written here alone.

Only commands of the window look at them: a macro or a program gives the same balloon on every machine.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import FreeCAD as App

from BalloonWorkbench.app import host
from BalloonWorkbench.app.properties.property_table import Property, shown_value

PATH = "User parameter:BaseApp/Preferences/Mod/BalloonWorkbench"
_BEDS = f"{PATH}/Beds"  # by the name of the machine, as text
_TABS, _TABS_BELOW = f"{PATH}/Tabs", f"{PATH}/TabsBelow"  # the same, as lengths in mm
#: FreeCAD's own, about its tree.
_SYNC, _TREE = "SyncView", "User parameter:BaseApp/Preferences/TreeView"
_RECENT, _CARD = "RecentExportFolder", "RecentTestCard"
_MACHINE = "FilmBalloonMachine"  # of a document
_GENERAL, _OPENED = "User parameter:BaseApp/Preferences/General", "FileOpenSavePath"  # FreeCAD's own
_folders: dict[str, str] = {}  # where files went, by the document


class Item(NamedTuple):
    """One preference: its key, what it is without the user, and the property that begins with it, if any."""

    key: str
    default: str | float | bool
    part: str = ""  # outline, balloon or pattern
    prop: Property | None = None


def _items() -> tuple[Item, ...]:
    from BalloonWorkbench.app import balloon, outline, pattern

    return (
        *(
            Item(item.name, _default(item), part, item)
            for part, module in (("balloon", balloon), ("outline", outline), ("pattern", pattern))
            for item in module.PROPERTIES
            if item.preference
        ),
        Item("ExportFolder", ""),
        Item("Machine", "any-dxf"),
        Item("OfferSolver", True),
    )


def _default(item: Property) -> str | float | bool:
    """What a new object begins with."""
    if item.type == "Enumeration":
        return item.option.begins or item.option.title(item.option.default)
    return 0.0 if item.value is None else item.value


def items() -> dict[str, Item]:
    """All preferences by key, in the order of the page."""
    return {item.key: item for item in _items()}


def get(key: str) -> Any:
    """The user's value, or the usual one where there is none or it makes no sense (any more)."""
    item, group = items()[key], App.ParamGet(PATH)
    if isinstance(item.default, bool):
        return group.GetBool(key, item.default)
    if isinstance(item.default, str):
        value = group.GetString(key, item.default)
        allowed = choices(key)
        return value if not allowed or value in allowed else item.default
    value = group.GetFloat(key, item.default)
    option = item.prop.option
    least = shown_value(option, option.least)
    return value if least <= value < float("inf") else item.default


def put(key: str, value) -> None:
    """Keep a value; the usual one is not kept, so that it may change with a new release."""
    item, group = items()[key], App.ParamGet(PATH)
    kind = (
        "Bool" if isinstance(item.default, bool) else "String" if isinstance(item.default, str) else "Float"
    )
    if value == item.default:
        getattr(group, f"Rem{kind}")(key)
    else:
        getattr(group, f"Set{kind}")(key, type(item.default)(value))


def bed(machine) -> tuple[float, float] | None:
    """The bed that the user has given a machine [m], else that of its file; None where there is no limit."""
    from BalloonWorkbench.core.errors import InputError
    from BalloonWorkbench.core.machines.machine import parse_bed

    try:
        return parse_bed(App.ParamGet(_BEDS).GetString(machine.name, ""))
    except InputError:  # none is kept, or it makes no sense
        return machine.bed


def put_bed(machine, size: tuple[float, float] | None) -> None:
    """Keep the bed of a machine [m]; that of its file is not kept."""
    from BalloonWorkbench.core.machines.machine import bed_text

    group = App.ParamGet(_BEDS)
    if size == machine.bed:
        group.RemString(machine.name)
    else:
        group.SetString(machine.name, bed_text(size))


def forget_bed(name: str) -> None:
    """The bed of a machine is that of its file again."""
    App.ParamGet(_BEDS).RemString(name)


def machine(doc) -> str:
    """The machine for which this document was exported last, else the one that the user prefers."""
    last = dict(doc.Meta).get(_MACHINE, "")
    return last if last in choices("Machine") else get("Machine")


def put_machine(doc, name: str) -> None:
    """Remember the machine for which a document was exported; the document keeps it."""
    if dict(doc.Meta).get(_MACHINE) != name:
        doc.Meta = {**doc.Meta, _MACHINE: name}


def tabs(name: str) -> tuple[float, float]:
    """The tabs that the user has given a machine, and below which size of pieces [mm]; 0 is none, and all."""
    width, below = (App.ParamGet(group).GetFloat(name, 0.0) for group in (_TABS, _TABS_BELOW))
    return width, below


def put_tabs(name: str, width: float, below: float) -> None:
    """Keep the tabs of a machine [mm]."""
    for group, value in ((_TABS, width), (_TABS_BELOW, below)):
        App.ParamGet(group).SetFloat(name, value)


def export_folder(doc) -> Path:
    """Where files go: the folder that the user prefers, else the last one for this document, else beside it,
    else the last one for any document, else the home folder. There may be no document.
    """
    if get("ExportFolder"):
        return Path(get("ExportFolder"))
    file, name = (doc.FileName, doc.Name) if doc is not None else ("", "")
    document = Path(file).parent if file else ""
    known = (_folders.get(file or name, ""), document, App.ParamGet(PATH).GetString(_RECENT, ""))
    return next((Path(folder) for folder in known if folder and Path(folder).is_dir()), Path.home())


def put_export_folder(doc, folder) -> None:
    """Remember where a document's file went."""
    _folders[doc.FileName or doc.Name] = str(folder)
    App.ParamGet(PATH).SetString(_RECENT, str(folder))


def recent_card() -> str:
    """The file of the test card that was written last; empty where it is not there any more."""
    path = App.ParamGet(PATH).GetString(_CARD, "")
    return path if path and Path(path).is_file() else ""


def put_recent_card(path) -> None:
    """Remember the file of a test card."""
    App.ParamGet(PATH).SetString(_CARD, str(path))


def open_folder() -> str:
    """Where FreeCAD has opened or saved a file last; empty where it has not."""
    return App.ParamGet(_GENERAL).GetString(_OPENED, "")


def put_open_folder(folder: str) -> None:
    """Let FreeCAD and the workbench ask for the next file there."""
    App.ParamGet(_GENERAL).SetString(_OPENED, folder)


def choices(key: str) -> list[str]:
    """What a preference may be; empty where it is a number, a switch or free text."""
    from BalloonWorkbench.app.properties import film
    from BalloonWorkbench.core.machines.machine import machines

    if key == "Film":
        return [name for name in film.names() if name != film.CUSTOM]
    if key == "Machine":
        return list(machines())
    prop = items()[key].prop
    return list(prop.entries()) if prop and prop.entries else []


def begin(parts) -> None:
    """Give the objects of a new balloon the user's preferences; nothing is computed."""
    for item in items().values():
        if item.prop and get(item.key) != item.default:
            setattr(getattr(parts, item.part), item.key, get(item.key))


def settings():
    """The engine's settings for a balloon that begins with the preferences and is no document object yet."""
    from BalloonWorkbench.app.properties.film import known_films
    from BalloonWorkbench.app.properties.property_table import engine_value
    from BalloonWorkbench.core.job import Settings
    from BalloonWorkbench.core.options.option import options_of
    from BalloonWorkbench.core.options.simulation import InflationOptions

    known = items()
    begun = {
        option.name: engine_value(option, get(option.property_name))
        for option in options_of(InflationOptions)
        if option.property_name in known
    }
    return Settings(film=known_films()[get("Film")], **begun)


def syncs_views() -> bool:
    """Whether FreeCAD brings the 3D view of what is selected to the front, as it does since 1.0."""
    return bool(App.ParamGet(_TREE).GetBool(_SYNC, host.syncs_views()))


def put_syncs_views(on: bool) -> None:
    """Let FreeCAD do so, or not."""
    App.ParamGet(_TREE).SetBool(_SYNC, on)
