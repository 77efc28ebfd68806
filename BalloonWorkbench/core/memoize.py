# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finished results, so that several steps of the work may ask for the same one: the only memory there is.

Invariant: a result belongs to the exact value of its request, all arguments to the last bit, and is what
working it out anew would give. So it does not matter who asked for what before, or in which thread.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import update_wrapper
from inspect import signature
from pathlib import Path
from typing import Any, Generic, ParamSpec, TypeVar

import numpy as np

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")

#: Arguments that watch the work, or end it, and do not change what comes of it.
_WATCHING = ("progress", "budget")
_memories: list[Memoized[..., Any]] = []
#: Results of another process, by the name of the function.
_handed_over: dict[str, dict[bytes, Any]] = {}


class Memoized(Generic[_Arguments, _Result]):
    """A function of values whose last results are kept. What it raises is not."""

    def __init__(self, function: Callable[_Arguments, _Result], most: int) -> None:
        self._function, self._most = function, most
        self._signature = signature(function)
        self.name = f"{function.__module__}.{function.__qualname__}"
        self._results: dict[bytes, _Result] = dict(_handed_over.get(self.name, {}))
        _memories.append(self)
        update_wrapper(self, function)

    def __call__(self, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> _Result:
        """What the function returns."""
        key = self._key(*args, **kwargs)
        with suppress(KeyError):  # not asked and looked up: another thread may let it go between
            return self._results[key]
        result = self._results[key] = self._function(*args, **kwargs)
        for old in list(self._results)[: -self._most]:
            self._results.pop(old, None)
        return result

    def knows(self, *args: _Arguments.args, **kwargs: _Arguments.kwargs) -> bool:
        """The result is there at once."""
        return self._key(*args, **kwargs) in self._results

    def _key(self, *args: Any, **kwargs: Any) -> bytes:
        bound = self._signature.bind(*args, **kwargs)
        bound.apply_defaults()
        digest = hashlib.sha256()
        for name, value in bound.arguments.items():
            if name not in _WATCHING:
                for part in _parts(value):
                    digest.update(len(part).to_bytes(8, "little"))
                    digest.update(part)
        return digest.digest()


def memoized(
    most: int,
) -> Callable[[Callable[_Arguments, _Result]], Memoized[_Arguments, _Result]]:
    """Keep the last so many results of a function whose arguments are values: numbers, texts, arrays,
    dataclasses, and tuples of those."""
    return lambda function: Memoized(function, most)


def results() -> dict[str, dict[bytes, Any]]:
    """All results that are known, to be handed to another process of the same program."""
    return {memory.name: dict(memory._results) for memory in _memories if memory._results}


def hand_over(results: dict[str, dict[bytes, Any]]) -> None:
    """Know what another process of the same program has worked out."""
    _handed_over.update(results)
    for memory in _memories:
        memory._results |= results.get(memory.name, {})


def forget() -> None:
    """Forget all results: the next ones are worked out."""
    _handed_over.clear()
    for memory in _memories:
        memory._results.clear()


def _parts(value: Any) -> Iterator[bytes]:
    """All of a value, in bytes; fields of a dataclass that are not compared are no part of it."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, np.ndarray):
        yield f"{value.dtype.str}{value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, (tuple, list, Mapping)) or is_dataclass(value):
        items = _items(value)
        yield f"{type(value).__qualname__} of {len(items)}".encode()
        for item in items:
            yield from _parts(item)
    elif value is None or isinstance(value, (bool, int, float, str, bytes, Enum, Path)):
        yield f"{type(value).__name__} {value!r}".encode(errors="surrogatepass")
    else:
        raise TypeError(f"{type(value).__name__} is no value that a result can be kept for")


def _items(value: Any) -> list[Any]:
    if isinstance(value, Mapping):
        return list(value.items())
    if is_dataclass(value):
        return [getattr(value, field.name) for field in fields(value) if field.compare]
    return list(value)
