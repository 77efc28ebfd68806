# SPDX-License-Identifier: LGPL-2.1-or-later
"""theme.py light|dark   ->   prints a user.cfg: that of the tests, with a theme as this FreeCAD ships it.

FreeCAD 1.0 and 1.1 have packs of preferences "FreeCAD Light" and "FreeCAD Dark"; 0.20 has style sheets only.
"""

import sys
import xml.etree.ElementTree as ET
from pathlib import Path

_SHARED = Path("/usr/share/freecad/Gui")
_OLD = {"light": "", "dark": "Behave-dark.qss"}


def main(theme: str) -> None:
    """Print the file."""
    root = ET.parse(Path(__file__).resolve().parents[1] / "user.cfg").getroot()
    pack = _SHARED / "PreferencePacks" / f"FreeCAD {theme.title()}" / f"FreeCAD {theme.title()}.cfg"
    if pack.exists():
        _merge(root, ET.parse(pack).getroot())
    else:
        assert not _OLD[theme] or (_SHARED / "Stylesheets" / _OLD[theme]).exists()
        _merge(root, ET.fromstring(_style_sheet(_OLD[theme])))
    sys.stdout.write(ET.tostring(root, encoding="unicode"))


def _merge(into, source) -> None:
    for element in source:
        same = [e for e in into if (e.tag, e.get("Name")) == (element.tag, element.get("Name"))]
        if same and element.tag == "FCParamGroup":
            _merge(same[0], element)
        else:
            for old in same:
                into.remove(old)
            into.append(element)


def _style_sheet(name: str) -> str:
    """The parameters of a style sheet, as in a user.cfg."""
    inner = f'<FCText Name="StyleSheet">{name}</FCText>'
    for group in ("MainWindow", "Preferences", "BaseApp", "Root"):
        inner = f'<FCParamGroup Name="{group}">{inner}</FCParamGroup>'
    return f"<FCParameters>{inner}</FCParameters>"


if __name__ == "__main__":
    main(sys.argv[1])
