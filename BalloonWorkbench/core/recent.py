# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found lately, so that several steps may ask for the same thing."""

from __future__ import annotations

from typing import TypeVar

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class Recent(dict[_Key, _Value]):
    """The last so many values, by what they came from; the oldest go. Any thread may add one."""

    def __init__(self, most: int) -> None:
        super().__init__()
        self._most = most

    def __setitem__(self, key: _Key, value: _Value) -> None:
        super().__setitem__(key, value)
        for old in list(self)[: -self._most]:
            self.pop(old, None)
