# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inflation of a job's balloons, with what is printed on them, as a moving picture."""

from __future__ import annotations

import io
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from BalloonWorkbench.core.bag_job import FinishedBags
from BalloonWorkbench.core.errors import MissingPackageError
from BalloonWorkbench.core.job import Balloon, blown_up
from BalloonWorkbench.core.products import Artwork
from BalloonWorkbench.core.scenes.mesh_picture import meshes_picture
from BalloonWorkbench.core.scenes.surface_mesh import SurfaceMesh
from BalloonWorkbench.core.shared.sharing import shown
from BalloonWorkbench.core.solver.dynamics.animation import Frame
from BalloonWorkbench.core.solver.inflation import Inflation
from BalloonWorkbench.core.tracing.raster import opencv
from BalloonWorkbench.core.types import Progress, no_progress

GIF, MP4 = "gif", "mp4"
#: Frames from flat to rest, for how many the balloon is shown at rest, and how many there are a second.
_FRAMES, _REST, _RATE = 40, 30, 20
_SIZE = (480, 400)
_PAPER = 255
_NO_MP4 = "This OpenCV writes no MP4: take --animation gif, or install opencv-python-headless with pip."

#: Pixels (height, width, 3) of a picture, red first.
Pixels = NDArray[np.uint8]


def animation_file(
    balloon: Balloon | FinishedBags,
    kind: str,
    artwork: Artwork | None = None,
    progress: Progress = no_progress,
) -> bytes:
    """All balloons of a job blown up from flat film side by side, on white; kind: GIF or MP4.

    Raises what `shown` and inflate_in_time raise, MissingPackageError where nothing writes such a file.
    """
    blown = [
        *blown_up([design.inflation for design in balloon.designs], balloon.settings.film, _FRAMES, progress)
    ]
    scenes = [_meshes(balloon, blown, number, artwork) for number in range(_FRAMES)]
    places = [mesh.positions for meshes in (scenes[0], scenes[-1]) for mesh in meshes]
    box = np.array(
        [
            np.min([each.min(axis=0) for each in places], axis=0),
            np.max([each.max(axis=0) for each in places], axis=0),
        ]
    )
    pictures = [_on_white(meshes, box) for meshes in scenes]
    return (_gif if kind == GIF else _mp4)(pictures)


def _meshes(
    balloon: Any,  # a Balloon or FinishedBags: their parts are replaced alike
    blown: Sequence[tuple[Inflation, tuple[Frame, ...]]],
    number: int,
    artwork: Artwork | None,
) -> list[SurfaceMesh]:
    """All surfaces of a frame."""
    parts = []
    for part, (rest, frames) in zip(balloon.parts, blown, strict=True):
        then = replace(rest, positions=frames[number].positions, lower=frames[number].lower)
        parts.append(replace(part, design=replace(part.design, inflation=then)))
    seen = shown(replace(balloon, parts=tuple(parts)), "", artwork)
    return [mesh for meshes in seen.values() for mesh in meshes]


def _on_white(meshes: Sequence[SurfaceMesh], box: NDArray[np.float64]) -> Pixels:
    picture = meshes_picture(meshes, *_SIZE, box)
    share = picture[..., 3:]
    return np.rint(255.0 * share * picture[..., :3] + _PAPER * (1.0 - share)).astype(np.uint8)


def _gif(pictures: Sequence[Pixels]) -> bytes:
    """In the colours of the balloon at rest, over and over."""
    try:
        from PIL import Image  # type: ignore[import-untyped]
    except ImportError as error:
        raise MissingPackageError("A GIF needs Pillow: install it with pip install pillow.") from error
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


def _mp4(pictures: Sequence[Pixels]) -> bytes:
    package = opencv()
    if package is None:
        raise MissingPackageError(_NO_MP4)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "inflation.mp4"
        writer = package.VideoWriter(str(file), package.VideoWriter_fourcc(*"mp4v"), float(_RATE), _SIZE)
        for picture in [*pictures, *[pictures[-1]] * _REST]:
            writer.write(np.ascontiguousarray(picture[..., ::-1]))
        writer.release()
        if not file.exists() or not file.stat().st_size:
            raise MissingPackageError(_NO_MP4)
        return file.read_bytes()
