# SPDX-License-Identifier: LGPL-2.1-or-later
"""The border to readers of other projects, which meet files that nobody foresaw."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from BalloonWorkbench.core.errors import BalloonError, InputError


@contextmanager
def foreign_reader(refusal: Callable[[str], InputError]) -> Iterator[None]:
    """Turns whatever a reader stumbles over into an error that is made from the reader's words."""
    try:
        yield
    except BalloonError:
        raise
    except Exception as error:  # anything may be wrong with a file, and its reader does not foresee all
        reason = " ".join(str(error).split())[:100] or type(error).__name__
        raise refusal(reason) from error
