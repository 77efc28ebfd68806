# SPDX-License-Identifier: LGPL-2.1-or-later
"""Film Balloon workbench: designs balloons from film that does not stretch.

In FreeCAD the functions of the Python API are here: BalloonWorkbench.from_picture(...), see docs/api.md.
"""

_MANIFEST = ("__version__", "__date__")  # of package.xml, the one place for them
_API = (
    *("from_picture", "from_sketch", "parts", "change", "inflate", "findings", "repair"),
    *("export", "artwork", "sketch", "nest", "assembly_sheet"),
)


def __getattr__(name: str) -> object:
    """The API needs FreeCAD, the engine does not: it is loaded when it is asked for. So is the version."""
    if name in _MANIFEST:
        from pathlib import Path
        from xml.etree import ElementTree

        manifest = ElementTree.parse(Path(__file__).resolve().parents[1] / "package.xml")
        return manifest.findtext("{*}" + name.strip("_"))
    if name not in _API:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from BalloonWorkbench.app import api

    return getattr(api, name)
