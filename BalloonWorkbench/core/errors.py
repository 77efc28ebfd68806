# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors a user can meet. Each text says what happened and what to do."""

from pathlib import Path


class BalloonError(Exception):
    """Base of every failure that a user can cause or repair."""


class InputError(BalloonError):
    """The input file, sketch or value cannot be used as it is."""


class PictureError(InputError):
    """No shape can be found in the picture."""


class OutlineError(InputError):
    """The outline is open, crosses itself, is empty or too thin."""


class MarksError(InputError):
    """Registration marks do not fit round a print, or a print is too large for its machine."""


class AssemblyError(InputError):
    """The panels and seams of a balloon do not fit together."""


class MeshError(BalloonError):
    """The outline cannot be triangulated at the wanted size.

    place  (x, y) [m] of the part that is in the way, where it is one
    """

    def __init__(self, text: str, place: tuple[float, float] | None = None) -> None:
        super().__init__(text)
        self.place = place


class SolverError(BalloonError):
    """The simulation cannot go on, not even with its last good state."""


class ExportError(BalloonError):
    """A file cannot be written."""


class MissingPackageError(BalloonError):
    """A package that this step needs is not installed."""


class FetchError(BalloonError):
    """What was to come from the network did not come, or is not what it should be; nothing was changed."""


class Cancelled(BalloonError):
    """The user stopped the work; nothing was changed."""


class ProgramFault(BalloonError):
    """Something nobody foresaw: a fault of the program, not of the user.

    file  where its details are, None where they could not be written
    """

    def __init__(self, text: str, file: Path | None = None) -> None:
        super().__init__(text)
        self.file = file
