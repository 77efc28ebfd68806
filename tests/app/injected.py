# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults put into the engine: one of its functions raises at its n-th call what nobody foresees."""

import functools
import importlib
import inspect
import pkgutil
import random
import sys
from collections import Counter

import BalloonWorkbench.core

ERRORS = (ZeroDivisionError, MemoryError, IndexError, RuntimeError, AssertionError)
#: What tells of faults, and what only stands for a constant.
_LEFT_OUT = (
    "core.faults",
    "core.errors",
    "core.types",
    "core.packages",
    "core.memoize",
    "core.pages.fonts",
)


class Engine:
    """While it is entered, each function and method of the engine is counted, and one may be made to fail."""

    def __init__(self):
        self.calls = Counter()
        self.fired = False
        self._place, self._left, self._error = "", 0, RuntimeError
        self._put_back = []

    def __enter__(self):
        for module in pkgutil.walk_packages(BalloonWorkbench.core.__path__, "BalloonWorkbench.core."):
            importlib.import_module(module.name)
        ours = [module for name, module in sys.modules.items() if name.startswith("BalloonWorkbench.")]
        for module in ours:
            name = module.__name__.partition(".")[2]
            if name.startswith("core.") and name not in _LEFT_OUT:
                self._wrap_all(name, module, ours)
        return self

    def __exit__(self, *_):
        for owner, name, value in reversed(self._put_back):
            setattr(owner, name, value)

    def arm(self, place, nth, error):
        """The function fails once, at its n-th call from now on."""
        self.fired = False
        self._place, self._left, self._error = place, nth, error

    def disarm(self):
        self._place = ""

    def _wrap_all(self, name, module, ours):
        for own, value in list(vars(module).items()):
            if getattr(value, "__module__", "") != module.__name__:
                continue
            if inspect.isfunction(value) or hasattr(value, "cache_clear") or hasattr(value, "knows"):
                wrapped = self._wrapped(f"{name}.{own}", value)
                for user in ours:
                    for known in [known for known, held in vars(user).items() if held is value]:
                        self._put(user, known, wrapped)
            elif inspect.isclass(value) and not issubclass(value, BaseException):
                for method, function in list(vars(value).items()):
                    if inspect.isfunction(function) and not method.startswith("__"):
                        self._put(value, method, self._wrapped(f"{name}.{own}.{method}", function))

    def _put(self, owner, name, value):
        self._put_back.append((owner, name, vars(owner)[name]))
        setattr(owner, name, value)

    def _wrapped(self, place, function):
        @functools.wraps(function)
        def call(*given, **named):
            self.calls[place] += 1
            if place == self._place:
                self._left -= 1
                if self._left == 0:
                    self.fired = True
                    raise self._error("put in by a test")
            return function(*given, **named)

        for name in ("cache_clear", "cache_info", "knows"):
            if hasattr(function, name):
                setattr(call, name, getattr(function, name))
        return call


def chosen(calls, count, seed):
    """So many places of those that were called: function, which call, and what it raises; always the same."""
    dice = random.Random(seed)
    places = sorted(calls)
    dice.shuffle(places)
    found = []
    for number in range(count):
        place = places[number % len(places)]
        nth = dice.choice((1, 1, (calls[place] + 1) // 2, calls[place]))
        found.append((place, nth, ERRORS[(number + seed) % len(ERRORS)]))
    return found
