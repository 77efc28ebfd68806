# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading signatures of macOS: in a file that is made here by Apple's published layout, whole and damaged."""

from __future__ import annotations

import hashlib
import importlib
import struct
from collections.abc import Callable
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
PAGE = 4096


@pytest.fixture
def faults(monkeypatch: pytest.MonkeyPatch) -> Callable[[bytes], list[str]]:
    monkeypatch.syspath_prepend(str(TOOLS))
    return importlib.import_module("macho_signature").signature_faults


def signed(
    size: int = 2 * PAGE + 100, flags: int = 0x2, signs: bool = True, covered: int | None = None
) -> bytes:
    """A Mach-O file of `size` bytes and the signature of all or `covered` bytes: header, command, hashes."""
    covered = size if covered is None else covered
    identifier = b"a.dylib\0"
    pages = -(-covered // PAGE)
    directory_size = 88 + len(identifier) + 32 * pages
    blob_size = 20 + directory_size
    command = struct.pack("<4I", 0x1D if signs else 0x2, 16, size, blob_size)
    header = struct.pack("<8I", 0xFEEDFACF, 0x0100000C, 0, 6, 1, 16, 0, 0)
    body = (header + command + bytes(range(256)) * (size // 256 + 1))[:size]
    directory = struct.pack(
        ">9I4BI",
        0xFADE0C02,
        directory_size,
        0x20400,
        flags,
        88 + len(identifier),
        88,
        0,
        pages,
        covered,
        32,
        2,
        0,
        12,
        0,
    )
    hashes = b"".join(hashlib.sha256(body[at : at + PAGE]).digest() for at in range(0, covered, PAGE))
    return body + (
        struct.pack(">5I", 0xFADE0CC0, blob_size, 1, 0, 20) + directory.ljust(88, b"\0") + identifier + hashes
    )


@pytest.mark.parametrize("size", [PAGE, 2 * PAGE + 100, 100])
def test_a_whole_one_has_no_faults(faults: Callable[[bytes], list[str]], size: int) -> None:
    assert faults(signed(size)) == []


def test_every_changed_byte_of_the_content_is_noticed(faults: Callable[[bytes], list[str]]) -> None:
    content = signed()
    for at in range(48, 2 * PAGE + 100, 97):
        changed = bytearray(content)
        changed[at] ^= 1
        assert faults(bytes(changed)) == [f"page {at // PAGE} was changed after it was signed"]


def test_no_signature_another_one_or_half_of_one_is_noticed(faults: Callable[[bytes], list[str]]) -> None:
    assert faults(signed(signs=False)) == ["it is not signed"]
    assert faults(signed(covered=PAGE)) == ["its signature does not cover the whole file"]
    assert faults(signed(flags=0)) == ["its signature is not an ad-hoc one"]
    assert faults(b"no Mach-O file, but as long as its header")
    content = signed()
    assert all(faults(content[:size]) for size in (0, 10, 40, PAGE, len(content) - 40, len(content) - 1))
    assert faults(content + b"more")
