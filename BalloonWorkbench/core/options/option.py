# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an option is, and how a dataclass declares one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, fields, replace
from enum import Enum
from functools import cache
from typing import Any

from BalloonWorkbench.core.files.data_file import RESOURCES, UNUSABLE, data_files, read_data


class Kind(Enum):
    """What kind of value an option has; the engine has it in SI units."""

    LENGTH = "length"
    HEIGHT = "height"  # a length that may be below 0
    ANGLE = "angle"
    PRESSURE = "pressure"
    VOLUME = "volume"
    MASS = "mass"
    TEMPERATURE = "temperature"
    NUMBER = "number"
    COUNT = "count"
    FLAG = "flag"
    CHOICE = "choice"
    TEXT = "text"
    FILE = "file"


@dataclass(frozen=True)
class Option:
    """One option.

    default     None where the engine finds the value
    text        what it is, a line for people
    typed       the same on the command line, where it takes something else
    group       of properties in a document; topic: in the help of the command line
    label       of its field in a panel; without one it has none. page: of which panel
    prop        name of the document property, "" for none; else the name in capitals: NotchDepth
    flag        on the command line, "" for none; else --notch-depth. Of a yes or no it takes the other one
    metavar     in the help of the command line, where the kind's says too little
    choices     what may be chosen: the values, with titles for people
    least, most of numbers; step: of a field in the user's unit; decimals of a plain number
    scale       a plain number in the document counts in these
    switch      the yes or no that it stands for too on the command line: "none", or being given at all
    rivals      those with the same word exclude each other on the command line
    plain       unit of a number that is typed without one
    needs       the property without which it has no effect
    begins      with what a new document object begins, where that is not the default
    weighs      what a pattern weighs depends on it
    preference  its label on the page of preferences, where a new balloon begins with what the user prefers
    """

    kind: Kind
    default: Any
    text: str
    group: str
    topic: str = ""
    name: str = ""
    typed: str = ""
    label: str = ""
    page: str = ""
    prop: str | None = None
    flag: str | None = None
    metavar: str = ""
    choices: Callable[[], Mapping[Any, str]] | Mapping[Any, str] | None = None
    least: float = 0.0
    most: float = 1e9
    step: float | None = None
    decimals: int = 3
    scale: float = 1.0
    switch: str = ""
    rivals: str = ""
    plain: str = ""
    needs: str = ""
    begins: Any = None
    weighs: bool = True
    preference: str = ""

    @property
    def property_name(self) -> str:
        """Name of the document property; empty without one."""
        return "".join(map(str.capitalize, self.name.split("_"))) if self.prop is None else self.prop

    @property
    def flag_name(self) -> str:
        """As it is typed on the command line; empty where it is not."""
        return "--" + self.name.replace("_", "-") if self.flag is None else self.flag

    @property
    def api_name(self) -> str:
        """Its name in the Python API: that of the property in small letters; empty without one."""
        return snake(self.property_name)

    @property
    def titles(self) -> dict[Any, str]:
        """What may be chosen: the values, with titles for people."""
        return dict(self.choices() if callable(self.choices) else self.choices or {})

    @property
    def key(self) -> str:
        """Its name among all that may be typed on the command line."""
        return self.flag_name.lstrip("-").replace("-", "_")

    def title(self, value: Any) -> str:
        """The title of a choice."""
        return self.titles[value]

    def value(self, title: str) -> Any:
        """The choice with a title."""
        return next(value for value, known in self.titles.items() if known == title)


def snake(name: str) -> str:
    """MeshSize to mesh_size."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


@dataclass(frozen=True)
class Section:
    """Options that belong together: their group, the page of the panel where it is not the object's, and
    what the help of the command line calls them where it is not the group.
    """

    group: str
    page: str = ""
    topic: str = ""

    def __call__(self, kind: Kind, default: Any, text: str, **more: Any) -> Any:
        """A field of a dataclass that is an option; see `Option` for what more may be said."""
        declared = Option(kind, default, text, self.group, self.topic or self.group, page=self.page, **more)
        return field(default=default, metadata={"option": declared})


@cache
def titles_in(name: str, first: str = "") -> Mapping[str, str]:
    """Names and titles of what a folder or file of resources describes; what is of no use there has none."""
    place = RESOURCES / name
    known: dict[str, str] = {}
    for path in data_files(lambda: place) if place.is_dir() else [place]:
        with suppress(*UNUSABLE):
            data = read_data(path)
            described = {data["name"]: data} if place.is_dir() else data
            known |= {each: str(entry["title"]) for each, entry in described.items()}
    return {each: known[each] for each in sorted(known, key=lambda each: (each != first, each))}


@cache
def options_of(declaring: type) -> tuple[Option, ...]:
    """The options that a dataclass declares, in their order."""
    return tuple(
        replace(item.metadata["option"], name=item.name)
        for item in fields(declaring)
        if "option" in item.metadata
    )


def option_of(declaring: type, name: str) -> Option:
    """One of them."""
    return next(option for option in options_of(declaring) if option.name == name)


def unusual(options: Any) -> dict[str, Any]:
    """The options of a dataclass that are not as usual, by name."""
    own = ((option, getattr(options, option.name)) for option in options_of(options.__class__))
    return {option.name: value for option, value in own if value != option.default}
