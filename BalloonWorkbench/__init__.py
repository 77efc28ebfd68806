# SPDX-License-Identifier: LGPL-2.1-or-later
"""Film Balloon workbench: designs balloons from film that does not stretch.

In FreeCAD the functions of the Python API are here: BalloonWorkbench.from_picture(...), see docs/api.md.
"""

_RELEASE = {"__version__": "VERSION", "__date__": "DATE"}
_API = (
    *("from_picture", "from_sketch", "from_profile", "from_panels", "from_body"),
    *("parts", "panels", "change", "inflate", "edit_outline", "findings", "repair"),
    *("export", "tool_paths", "artwork", "sketch", "nest", "keep_remnant", "assembly_sheet", "share"),
    *("study", "test_card", "keep_field", "compare", "fit_film"),
)


def __getattr__(name: str) -> object:
    """The API needs FreeCAD, the engine does not: it is loaded when it is asked for. So is the version."""
    if name in _RELEASE:
        from BalloonWorkbench.core import version

        return getattr(version, _RELEASE[name])
    if name not in _API:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from BalloonWorkbench.app import api

    return getattr(api, name)
