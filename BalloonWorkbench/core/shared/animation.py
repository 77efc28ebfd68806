# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflation of a job's balloons, with what is printed on them, as a moving picture."""

from __future__ import annotations

import io
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.bag_job import FinishedBags
from BalloonWorkbench.core.errors import Cancelled, MissingPackageError
from BalloonWorkbench.core.job import Balloon, blown_up
from BalloonWorkbench.core.scenes.ground import WHITE, laid_on
from BalloonWorkbench.core.scenes.mesh_picture import meshes_picture
from BalloonWorkbench.core.scenes.surface_mesh import SurfaceMesh
from BalloonWorkbench.core.shared.sharing import Printed, surfaces
from BalloonWorkbench.core.solver.dynamics.animation import Frame
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.tracing.raster import opencv
from BalloonWorkbench.core.types import Progress, no_progress, part_of

GIF, MP4 = "gif", "mp4"
#: Frames from flat to rest, for how many the balloon is shown at rest, and how many there are a second.
_FRAMES, _REST, _RATE = 40, 30, 20
_SIZE = (480, 400)
_BLOWN = 0.5  # of the progress, when all frames are known
_NO_MP4 = "Nothing here writes an MP4: choose a GIF, or install opencv-python-headless with pip."

#: Pixels (height, width, 3) of a picture, red first.
Pixels = NDArray[np.uint8]
#: A balloon at rest and the frames of its inflation.
Blown = tuple[Inflation, tuple[Frame, ...]]


def animation_file(
    balloon: Balloon | FinishedBags,
    kind: str,
    artwork: Printed | None = None,
    progress: Progress = no_progress,
    blown: Sequence[Blown] = (),
) -> bytes:
    """All balloons of a job blown up from flat film side by side, on white; kind: GIF or MP4.

    blown  each at rest and its frames, as many of each, where they are known: on any mesh of its panels
    Raises what `shown` and inflate_in_time raise, MissingPackageError where nothing writes such a file,
    Cancelled when progress says stop.
    """
    write = _gif() if kind == GIF else _mp4()
    blown = blown or _blown(balloon, part_of(progress, 0.0, _BLOWN))
    make = surfaces(_at_rest(balloon, blown), artwork)
    scenes = [
        _all(
            make(
                [
                    replace(rest, positions=frames[number].positions, lower=frames[number].lower)
                    for rest, frames in blown
                ]
            )
        )
        for number in range(len(blown[0][1]))
    ]
    places = [mesh.positions for meshes in (scenes[0], scenes[-1]) for mesh in meshes]
    box = np.array(
        [
            np.min([each.min(axis=0) for each in places], axis=0),
            np.max([each.max(axis=0) for each in places], axis=0),
        ]
    )
    pictures = []
    for number, meshes in enumerate(scenes):
        if not progress(_BLOWN + (1.0 - _BLOWN) * number / len(scenes), "drawing"):
            raise Cancelled("The moving picture was stopped.")
        pictures.append(laid_on(meshes_picture(meshes, *_SIZE, box), WHITE))
    return write(pictures)


def _blown(balloon: Balloon | FinishedBags, progress: Progress) -> list[Blown]:
    inflations = [design.inflation for design in balloon.designs]
    return [*blown_up(inflations, balloon.settings.film, _FRAMES, progress)]


def _at_rest(balloon: Any, blown: Sequence[Blown]) -> Any:
    """The job with these balloons; a Balloon or FinishedBags: their parts are replaced alike."""
    parts = [
        replace(part, design=replace(part.design, inflation=rest))
        for part, (rest, _) in zip(balloon.parts, blown, strict=True)
    ]
    return replace(balloon, parts=tuple(parts))


def _all(meshes: Sequence[Sequence[SurfaceMesh]]) -> list[SurfaceMesh]:
    return [mesh for each in meshes for mesh in each]


def _gif() -> Callable[[Sequence[Pixels]], bytes]:
    """What writes one in the colours of the balloon at rest, over and over."""
    try:
        from PIL import Image  # type: ignore[import-untyped]
    except ImportError as error:
        raise MissingPackageError("A GIF needs Pillow: install it with pip install pillow.") from error

    def write(pictures: Sequence[Pixels]) -> bytes:
        last = Image.fromarray(pictures[-1]).quantize(256)
        images = [Image.fromarray(each).quantize(palette=last, dither=Image.Dither.NONE) for each in pictures]
        beat = 1000 // _RATE
        file = io.BytesIO()
        images[0].save(
            file,
            format="GIF",
            save_all=True,
            append_images=images[1:],
            duration=[beat] * (len(images) - 1) + [beat * _REST],
            loop=0,
        )
        return file.getvalue()

    return write


def _mp4() -> Callable[[Sequence[Pixels]], bytes]:
    package = opencv()
    if package is None:
        raise MissingPackageError(_NO_MP4)

    def write(pictures: Sequence[Pixels]) -> bytes:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "inflation.mp4"
            code = package.VideoWriter_fourcc(*"mp4v")
            writer = package.VideoWriter(str(file), code, float(_RATE), _SIZE)
            for picture in [*pictures, *[pictures[-1]] * _REST]:
                writer.write(np.ascontiguousarray(picture[..., ::-1]))
            writer.release()
            if not file.exists() or not file.stat().st_size:
                raise MissingPackageError(_NO_MP4)
            return file.read_bytes()

    return write
