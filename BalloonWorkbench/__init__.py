# SPDX-License-Identifier: LGPL-2.1-or-later
"""Film Balloon workbench: designs balloons from film that does not stretch.

In FreeCAD the functions of the Python API are here: BalloonWorkbench.from_picture(...), see docs/api.md.
"""

_RELEASE = {"__version__": "VERSION", "__date__": "DATE"}
_BALLOONS = (
    *("from_picture", "from_sketch", "from_profile", "from_panels", "from_body"),
    *("parts", "panels", "change", "inflate", "edit_outline", "findings", "repair"),
)
_MAKING = (
    *("export", "tool_paths", "artwork", "arrange", "print_pieces", "sketch", "nest", "keep_remnant"),
    *("assembly_sheet", "share", "study", "test_card", "keep_field", "compare", "fit_film"),
)
#: Each function, and the module of app/api that has it.
_API = dict.fromkeys(_BALLOONS, ".app.api.balloons") | dict.fromkeys(_MAKING, ".app.api.making")


def __getattr__(name: str) -> object:
    """The API needs FreeCAD, the engine does not: it is loaded when it is asked for. So is the version."""
    if name in _RELEASE:
        from BalloonWorkbench.core import version

        return getattr(version, _RELEASE[name])
    if name not in _API:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_API[name], __name__), name)
