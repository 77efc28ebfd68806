# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that a user names: what is wrong with one is told in a sentence."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.core.errors import InputError


def read_user_file(path: Path, most: int) -> bytes:
    """The first bytes of a file, so many at most. InputError where there is none, or it cannot be read."""
    try:
        with path.open("rb") as file:
            return file.read(most)
    except FileNotFoundError:
        raise InputError(f"There is no file '{path}'. Check the name and the folder.") from None
    except OSError as error:
        raise InputError(
            f"'{path}' cannot be read ({error.strerror}). Check the name and its access."
        ) from None


def read_whole(path: Path, most: int) -> bytes:
    """The content of a file; InputError as above, and where it is empty or has more bytes than that."""
    data = read_user_file(path, most + 1)
    if len(data) > most:
        raise InputError(f"'{path.name}' is larger than {most >> 20} MB. Make it simpler.")
    if not data:
        raise InputError(f"'{path.name}' is empty. Choose another file.")
    return data
