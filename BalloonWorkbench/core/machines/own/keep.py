# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of the user's own machines: copied from one that is there, named, kept all or none, deleted."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

from BalloonWorkbench.core.errors import ExportError, InputError
from BalloonWorkbench.core.files.data_file import UNUSABLE, data_files, read_data, reason_of
from BalloonWorkbench.core.files.write import safe_name, write_files
from BalloonWorkbench.core.machines.machine import FOLDER, machine_of, machines, own_folder

_NAME = re.compile(r"[^\W_][\w -]{0,39}")
_OTHER = re.compile(r"[^\w -]+")


def own_name(title: str) -> str:
    """As what the file of a machine of this title is known: "My laser" is my-laser. InputError for none."""
    plain = " ".join(title.split())
    name = "-".join(plain.lower().split())
    if not _NAME.fullmatch(plain) or safe_name(name) != name:
        raise InputError(
            f"'{title}' cannot be the name of a machine: take up to 40 letters, digits, spaces and - only."
        )
    return name


def free_title(wish: str, taken: Collection[str] = ()) -> str:
    """A title like a wish, whose name no machine has; nor is it one of other names that are taken."""
    plain = " ".join(_OTHER.sub(" ", wish.partition("(")[0]).split())[:34].strip("_- ") or "Machine"
    names, number = {*_known_names(), *taken}, 2
    title = plain
    while own_name(title) in names:
        title, number = f"{plain} {number}", number + 1
    return title


def machine_data(name: str) -> dict[str, Any]:
    """What the file of a machine has that `machine` finds by this name."""
    plain = f"{'-'.join(name.lower().split())}.json"
    own = own_folder() / plain
    path = Path(name) if name.lower().endswith(".json") else own if own.is_file() else FOLDER / plain
    return dict(read_data(path))


def copied(data: Mapping[str, Any], title: str) -> dict[str, Any]:
    """The file of a machine of another title; what its files are called follows from that."""
    made = {key: value for key, value in data.items() if key != "file"}
    return made | {"name": own_name(title), "title": " ".join(title.split())}


def keep_machines(drafts: Sequence[tuple[str, Mapping[str, Any]]]) -> tuple[Path, ...]:
    """Write the files of machines, all or none; returns them.

    drafts  the name that each has had, "" of a new one, and what its file is to have; the file of another
            name goes
    Raises InputError for what makes no machine or a name that is taken, ExportError where it cannot be
    written.
    """
    folder, known = own_folder(), _known_names()
    contents: dict[str, bytes] = {}
    for before, data in drafts:
        name = f"{data['name']}.json"
        if name in contents or (data["name"] != before and data["name"] in known):
            raise InputError(f"There is a machine {data['title']} already: give this one another name.")
        contents[name] = machine_bytes(data)
    paths = write_files(folder, contents)
    for before, _ in drafts:
        if before and f"{before}.json" not in contents:
            delete_machine(before)
    return paths


def machine_bytes(data: Mapping[str, Any]) -> bytes:
    """The content of a machine's file, checked. Raises InputError."""
    try:
        machine_of(dict(data))
    except KeyError as error:
        raise InputError(f"{data.get('title')}: its file lacks {error}: add it.") from error
    except (*UNUSABLE, InputError) as error:
        raise InputError(f"{data.get('title')}: {reason_of(error)}") from error
    return (json.dumps(data, indent=2, ensure_ascii=False) + "\n").encode(errors="replace")


def delete_machine(name: str) -> None:
    """Remove the file of a machine of the user's own. Raises ExportError where that is not possible."""
    path = own_folder() / f"{name}.json"
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise ExportError(f"{path} cannot be deleted: {error.strerror}. See who may write there.") from error


def _known_names() -> set[str]:
    """The names that machines have: ours, the user's, and those of files that are of no use."""
    return {*machines(), *(path.stem for path in data_files(own_folder))}
