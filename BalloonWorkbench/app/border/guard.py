# SPDX-License-Identifier: LGPL-2.1-or-later
"""The border to FreeCAD: what it calls by name in our objects, views and observers never raises.

An exception there would be a traceback in the report view, and FreeCAD goes on with half of the work done.
"""

from __future__ import annotations

from functools import wraps

import FreeCAD as App

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.core import faults

faults.surroundings["FreeCAD"] = ".".join(App.Version()[:3])


def _none(*_arguments):
    return None


#: What FreeCAD calls, and what it is answered when that fails, from what it has given.
_CALLED = {
    **dict.fromkeys(("execute", "onChanged", "onDocumentRestored"), _none),
    **dict.fromkeys(("attach", "updateData", "setupContextMenu", "getIcon"), _none),
    "getDisplayModes": lambda _vobj: [],
    "setDisplayMode": lambda mode: mode,
    "doubleClicked": lambda _vobj: True,
    **dict.fromkeys(("loadSettings", "saveSettings", "addSelection", "setSelection"), _none),
}


class Guarded:
    """Base of all that FreeCAD calls by name; observers' names begin with "slot"."""

    def __init_subclass__(cls, **options):
        super().__init_subclass__(**options)
        for name, method in list(vars(cls).items()):
            if name in _CALLED or name.startswith("slot"):
                setattr(cls, name, guarded(method, _CALLED.get(name, _none)))


def guarded(method, answer=_none):
    """The method with a border around it: what it raises is told, and `answer` returned."""

    @wraps(method)
    def call(self, *arguments):
        try:
            return method(self, *arguments)
        except faults.UNFORESEEN as error:
            hooks.show_error(faults.as_balloon_error(error, f"in {type(self).__name__}.{method.__name__}"))
            return answer(*arguments)

    return call
