# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the signature inside a library for macOS fits its content, as Apple's processors check it.

The linker signs ad hoc: no certificate, but the SHA-256 of each page. A library that was changed after it was
linked, by `strip` for one, has wrong ones, and the process that loads it is killed.
"""

from __future__ import annotations

import hashlib
import struct

_MACHO_64 = 0xFEEDFACF
_LC_CODE_SIGNATURE = 0x1D
_SUPER_BLOB = 0xFADE0CC0
_CODE_DIRECTORY = 0xFADE0C02
_SHA_256 = 2
_AD_HOC = 0x2


def signature_place(content: bytes) -> tuple[int, int] | None:
    """Offset and size of the signature in a Mach-O file of one architecture, or None."""
    magic, _, _, _, commands = struct.unpack_from("<5I", content)
    if magic != _MACHO_64:
        raise ValueError("it is no 64 bit Mach-O file")
    at = 32
    for _ in range(commands):
        command, size = struct.unpack_from("<2I", content, at)
        if command == _LC_CODE_SIGNATURE:
            return struct.unpack_from("<2I", content, at + 8)
        at += size
    return None


def _code_directory(content: bytes, start: int) -> int:
    """Where the code directory begins."""
    magic, _, count = struct.unpack_from(">3I", content, start)
    if magic == _SUPER_BLOB:
        for number in range(count):
            _, offset = struct.unpack_from(">2I", content, start + 12 + 8 * number)
            if struct.unpack_from(">I", content, start + offset)[0] == _CODE_DIRECTORY:
                return start + offset
    raise ValueError("it has a signature without a code directory")


def signature_faults(content: bytes) -> list[str]:
    """What macOS on Apple's processors has against the signature of a Mach-O file."""
    try:
        place = signature_place(content)
        if place is None:
            return ["it is not signed"]
        start, size = place
        directory = _code_directory(content, start)
        flags, hashes, _, _, pages, limit = struct.unpack_from(">6I", content, directory + 12)
        length, kind, _, shift = struct.unpack_from(">4B", content, directory + 36)
    except (struct.error, ValueError) as error:
        return [str(error)]
    found = [] if flags & _AD_HOC else ["its signature is not an ad-hoc one"]
    if (kind, length) != (_SHA_256, hashlib.sha256().digest_size):
        return [*found, f"its signature has hashes of kind {kind}"]
    if limit != start or start + size != len(content):
        found.append("its signature does not cover the whole file")
    if pages != -(-limit >> shift):
        found.append(f"its signature has {pages} pages")
    for page in range(pages):
        begin = page << shift
        digest = hashlib.sha256(content[begin : min(begin + (1 << shift), limit)]).digest()
        at = directory + hashes + page * length
        if content[at : at + length] != digest:
            found.append(f"page {page} was changed after it was signed")
    return found
