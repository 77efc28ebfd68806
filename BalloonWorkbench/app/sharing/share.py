# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a document in a file for others: 3D model, web page, picture, moving picture."""

from __future__ import annotations

from pathlib import Path

from BalloonWorkbench.app.border import hooks
from BalloonWorkbench.app.drawings.drawing_file import file_of, pixels_of
from BalloonWorkbench.app.sharing.finished_job import finished_job
from BalloonWorkbench.core.errors import ExportError

GLB, PAGE, PICTURE = "glb", "html", "png"
MOVING = ("gif", "mp4")


def write_shared(parts, target, *, ground: str | None = None, blown=()) -> Path:
    """Write a balloon, as it is shown, to a file of the kind that its ending says; returns the file.

    A .glb is a 3D model, a .html one page that turns it and needs no network, a .png a picture, a
    .gif or .mp4 its inflation; what is printed on it is there. ground: of a page or picture, see
    SharingOptions of the core. blown: the core's Blown of the balloon, where the inflation is known.
    Raises ExportError for another ending, what is not up to date and a place that cannot be written,
    MissingPackageError where nothing writes such a file.
    """
    from BalloonWorkbench.core.files.write import write_files

    path = Path(target)
    kind = path.suffix.lower().lstrip(".")
    if kind not in (GLB, PAGE, PICTURE, *MOVING):
        raise ExportError(
            f"{path.name} is no file for the web: let the name end in .glb, .html, .png, .gif or .mp4."
        )
    behind = _ground(ground, kind)
    job, language = finished_job(parts, advised=kind == PAGE), hooks.language()

    def made(progress) -> bytes:
        from BalloonWorkbench.core.shared import animation, sharing

        if kind == GLB:
            return sharing.glb_file(job.balloon, job.title, job.printed)
        if kind == PAGE:
            return sharing.page_file(job.with_numbers(), job.title, job.printed, hooks.say, language, behind)
        if kind == PICTURE:
            return sharing.picture_file(job.balloon, job.printed, behind)
        return animation.animation_file(job.balloon, kind, job.printed, progress, blown)

    content = hooks.run_blocking(f"Writing {path.name}", made)
    write_files(path.parent, {path.name: content})
    return path


def _ground(text, kind: str):
    """What is behind the balloon in a kind of file."""
    from BalloonWorkbench.core.scenes.ground import WHITE, read_ground

    return read_ground(text, WHITE if kind == PICTURE else None, lambda path: pixels_of(file_of(path)))
