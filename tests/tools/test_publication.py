# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's Addon Manager and its index read of us: package.xml and the entry for the index.

The index checks its entries against AddonCatalog.schema.json of FreeCAD/AddonManager (branch dev,
2026-07-22); `faults` below states what that file asks. The rules for package.xml are those of FreeCAD's Addon
Academy.
"""

from __future__ import annotations

import importlib
import json
import re
from pathlib import Path
from urllib.parse import urlsplit
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = ElementTree.parse(ROOT / "package.xml").getroot()
REPOSITORY = MANIFEST.find("{*}url[@type='repository']")
INDEX = json.loads((ROOT / "tools" / "addon-index-entry.json").read_text(encoding="utf-8"))
(ENTRY,) = INDEX["BalloonWorkbench"]

_TEXTS = {"freecad_min", "freecad_max", "repository", "git_ref", "zip_url", "note", "branch_display_name"}
_NUMBER = r"(0|[1-9]\d*)"
_VERSION = re.compile(rf"{_NUMBER}\.{_NUMBER}\.{_NUMBER}(-[\da-zA-Z.-]+)?(\+[\da-zA-Z.-]+)?")


def faults(entry: dict[str, object]) -> list[str]:
    """What the schema of FreeCAD's index has against an entry."""
    found = [f"{key} is unknown" for key in entry.keys() - _TEXTS - {"curated"}]
    found += [f"{key} is no text" for key in entry.keys() & _TEXTS if not isinstance(entry[key], str)]
    found += ["curated is neither true nor false"] if not isinstance(entry.get("curated", True), bool) else []
    for key in entry.keys() & {"freecad_min", "freecad_max"}:
        found += [f"{key} is no version"] if not _VERSION.fullmatch(str(entry[key])) else []
    for key in entry.keys() & {"repository", "zip_url"}:
        found += [f"{key} is no address"] if not urlsplit(str(entry[key])).scheme else []
    if "zip_url" not in entry and not {"repository", "git_ref"} <= entry.keys():
        found.append("it leads nowhere")
    if "git_ref" not in entry and "branch_display_name" not in entry:
        found.append("it has no name to choose it by")
    return found


def test_index_entry_is_as_the_index_wants() -> None:
    assert set(INDEX) == {"BalloonWorkbench"}
    assert not faults(ENTRY)


@pytest.mark.parametrize(
    "change",
    [
        {"git_ref": None},
        {"freecad_min": "0.20"},
        {"freecad_min": 20},
        {"curated": "no"},
        {"repository": "film-balloon"},
        {"version": "0.1.0"},
        {
            "repository": None,
            "git_ref": None,
            "zip_url": "https://x.example/x.zip",
            "branch_display_name": None,
        },
    ],
)
def test_a_wrong_entry_is_noticed(change: dict[str, object]) -> None:
    assert faults({key: value for key, value in {**ENTRY, **change}.items() if value is not None})


def test_index_and_manifest_say_the_same() -> None:
    assert REPOSITORY is not None
    assert (ENTRY["repository"], ENTRY["git_ref"]) == (REPOSITORY.text, REPOSITORY.get("branch"))
    assert ENTRY["freecad_min"] == MANIFEST.findtext("{*}freecadmin")


def test_every_way_installs_into_the_same_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the index the folder has the entry's name, by an own repository the last part of its address."""
    monkeypatch.syspath_prepend(str(ROOT / "tools"))
    release = importlib.import_module("release")
    assert REPOSITORY is not None
    assert {*INDEX, str(REPOSITORY.text).rpartition("/")[2]} == {release.ADDON}


def test_branch_is_the_one_that_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "tools"))
    assert f"refs/heads/{ENTRY['git_ref']}" == importlib.import_module("release_branch").BRANCH


def test_manifest_is_fit_for_the_index() -> None:
    tags = [element.tag.rpartition("}")[2] for element in MANIFEST]
    required = {"name", "version", "date", "description", "maintainer", "license", "icon", "url", "content"}
    assert required <= set(tags)
    assert "freecadmax" not in {element.tag.rpartition("}")[2] for element in MANIFEST.iter()}
    assert (MANIFEST.get("format"), MANIFEST.tag) == (
        "1",
        "{https://wiki.freecad.org/Package_Metadata}package",
    )
    assert re.fullmatch(r"\d+\.\d+\.\d+", str(MANIFEST.findtext("{*}version")))
    assert all(
        re.fullmatch(r"\S+@\S+\.\S+", str(each.get("email"))) for each in MANIFEST.findall("{*}maintainer")
    )
    kinds = {"website", "bugtracker", "repository", "readme", "documentation", "discussion"}
    addresses = MANIFEST.findall("{*}url")
    assert all(each.get("type") in kinds and str(each.text).startswith("https://") for each in addresses)
    assert {"repository", "readme"} <= {each.get("type") for each in addresses}
    depends = MANIFEST.findall("{*}content/{*}workbench/{*}depend")
    assert depends == MANIFEST.findall(".//{*}depend")  # anywhere else they are not read
    assert {each.get("type") for each in depends} <= {"python", "internal", "addon"}
    tags_of_it = [str(each.text) for each in MANIFEST.findall(".//{*}tag")]
    assert 3 <= len(tags_of_it) <= 7
    assert all(tag == tag.lower() for tag in tags_of_it)


def test_one_address() -> None:
    """Whatever names our address names the one of package.xml; when it changes there, none is left behind."""
    assert REPOSITORY is not None
    address, email = str(REPOSITORY.text), str(MANIFEST.find("{*}maintainer").get("email"))
    wrong = []
    for path in [
        *ROOT.glob("*.*"),
        *ROOT.glob("docs/*.md"),
        *ROOT.glob(".github/**/*.yml"),
        *ROOT.glob("tools/*"),
        *ROOT.glob("resources/*.json"),
    ]:
        if path.is_file():
            text = path.read_text(encoding="utf-8").replace(address, "").replace(email, "")
            wrong += [f"{path.name}: {each}" for each in re.findall(r"\S*film-balloon\.example\S*", text)]
    assert not wrong
    named = [path for path in ("README.md", "docs/install.md") if address in (ROOT / path).read_text()]
    assert named == ["README.md", "docs/install.md"]
