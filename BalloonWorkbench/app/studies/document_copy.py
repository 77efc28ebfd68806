# SPDX-License-Identifier: LGPL-2.1-or-later
"""A copy of a document for the processes that work out its variants, the same file for the same content."""

from __future__ import annotations

import hashlib
import os
import tempfile
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from xml.etree import ElementTree

from BalloonWorkbench.core.errors import ExportError

#: Properties that are looks, or follow from another one, which FreeCAD 1.1 sees to when it opens a document;
#: those that our objects work out like their results.
_LOOKS = frozenset({"Visibility", "Label2", "TreeRank", "AttacherEngine"})
_WORKED_OUT = frozenset({"Shape", "Mesh", "Placement"})
#: How many copies a folder has: more than a study is worked out from while its document is changed.
_KEPT = 8


def copy_of(doc, folder: Path, left_out: Iterable[object], varied: Iterable[str]) -> Path:
    """The file of a copy in a folder, written where there is none of the same content yet.

    left_out  objects that decide nothing: the study and its table
    varied    properties that each row gives, as `Varied.key`
    Raises ExportError.
    """
    skipped = {*varied, *(f"{obj.Name}.{name}" for obj in doc.Objects for name in _worked_out(obj))}
    names = {obj.Name for obj in left_out}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            written = Path(scratch) / "copy.FCStd"
            doc.saveCopy(str(written))
            path = folder / f"{_digest(written, names, skipped)}.FCStd"
            if not path.is_file():
                os.replace(written, path)
        os.utime(path)
        _remove_all_but(_KEPT, folder)
    except OSError as error:
        raise ExportError(
            f"Cannot write to '{folder}' ({error.strerror or error}): choose another folder for the study."
        ) from None
    return path


def _remove_all_but(count: int, folder: Path) -> None:
    """Leave so many copies, the last ones that were asked for."""
    copies = sorted(folder.glob("*.FCStd"), key=lambda copy: (-copy.stat().st_mtime_ns, copy.name))
    for copy in copies[count:]:
        copy.unlink()


def _worked_out(obj) -> list[str]:
    """The properties of an object of ours that follow from the others, as the editor shows them."""
    own = getattr(getattr(obj, "Proxy", None), "properties", ())
    if not own:
        return []
    fixed = [item.name for item in own if item.result or "ReadOnly" in obj.getEditorMode(item.name)]
    return [*fixed, *_WORKED_OUT]


def _digest(path: Path, names: set[str], skipped: set[str]) -> str:
    """The same for documents with the same objects, but for some of them and some of their properties."""
    digest = hashlib.sha256()
    with zipfile.ZipFile(path) as archive:
        sums = {entry.filename: entry.CRC for entry in archive.infolist()}
        root = ElementTree.fromstring(archive.read("Document.xml"))
        for obj in root.iterfind("./ObjectData/Object"):
            owner = obj.get("name", "")
            for item in () if owner in names else obj.iter("Property"):
                name = item.get("name", "")
                if name not in _LOOKS and f"{owner}.{name}" not in skipped:
                    digest.update(f"{owner}.{name} {item.get('type')}".encode())
                    digest.update("".join(_content(item, sums)).encode())
    return digest.hexdigest()[:32]


def _content(item: ElementTree.Element, sums: dict[str, int]) -> Iterator[str]:
    """What a property has, with the sums of the files that it names."""
    for element in item:
        yield f"<{element.tag} {sorted(element.attrib.items())} {element.text or ''}>"
        file = element.get("file")
        if file:
            yield f"{sums.get(file)}"
        yield from _content(element, sums)
