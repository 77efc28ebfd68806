# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures on the flat pieces of a pattern, where the pattern lays them: its print, results as colours."""

from __future__ import annotations

from BalloonWorkbench.app.engine import film_result
from BalloonWorkbench.app.engine.bag_result import has_many_panels

#: Pixels of all prints together, and dots per inch that are enough: on a screen, on paper.
SCREEN, PAPER = (6e6, 60.0), (4e7, 300.0)


def of_shares(pattern, pieces, shares) -> dict:
    """The FlatPicture on each piece by its number, for the shares (m, 3) of a core's ColourMap."""
    import numpy as np

    from BalloonWorkbench.core.results.flat_maps import flat_map

    assembly, _ = film_result.shape(pattern.Balloon)
    if assembly.mirror:
        (panel,) = assembly.panels
        flat, count = panel.rest_positions, len(panel.triangles)
        below = shares[count:, ::-1]  # its triangles run the other way
        front, back = (flat_map(flat, panel.triangles, own) for own in (shares[:count], below))
        return {0: front, 1: back.mirrored().moved(_back_shift(pattern, pieces))}
    counts = [len(panel.triangles) for panel in assembly.panels]
    own = np.split(shares, np.cumsum(counts)[:-1])
    made = _bag_patterns(pattern)
    return {
        piece: flat_map(
            assembly.panels[number].rest_positions, assembly.panels[number].triangles, own[number]
        ).moved(shift)
        for piece, (number, shift) in enumerate(zip(made.panels, made.shifts, strict=True))
    }


def of_print(artwork, pieces, enough=SCREEN) -> dict:
    """The FlatPicture on each piece by its number of what an artwork prints, as fine as SCREEN or PAPER need;
    raises what `printing` does."""
    from BalloonWorkbench.app import artwork as prints
    from BalloonWorkbench.app.border import hooks

    pattern = artwork.Pattern
    size = sum(piece.pattern.size[0] * piece.pattern.size[1] for piece in pieces.pieces)
    make = prints.printing(artwork, _dpi(artwork.Resolution, size, *enough))
    front, back = hooks.run_blocking(f"Drawing {artwork.Label}", lambda progress: make())
    if not has_many_panels(pattern.Balloon):
        shift = _back_shift(pattern, pieces)
        return {0: _picture(front), 1: _picture(back).moved(shift)}
    whole, made = _picture(front), _bag_patterns(pattern)
    return {
        piece: _part(whole, laid.bounds, shift - printed)
        for piece, (laid, shift, printed) in enumerate(
            zip(made.patterns, made.shifts, _print_shifts(artwork), strict=True)
        )
    }


def _bag_patterns(pattern):
    from BalloonWorkbench.app.pattern import bag_patterns

    return bag_patterns(pattern)


def _dpi(resolution: float, area: float, pixels: float, enough: float) -> float:
    """Dots per inch with which films of that area [m2] have no more pixels than that."""
    from BalloonWorkbench.core.units import INCH

    return max(20.0, min(resolution, enough, INCH * (pixels / area) ** 0.5))


def _back_shift(pattern, pieces):
    """How far the back lies from the front's mirror image about the y axis (2,) m."""
    from BalloonWorkbench.core.pattern.placement import back_of

    return pieces.pieces[1].pattern.bounds[0] - back_of(pieces.pieces[0].pattern).bounds[0]


def _print_shifts(artwork) -> list:
    """How far each panel lies on the sheet that is printed from its own frame (2,) m."""
    from BalloonWorkbench.app.engine.panel_prints import finished
    from BalloonWorkbench.app.properties.quantities import metres
    from BalloonWorkbench.core.products import panels_to_print

    laid, _ = panels_to_print(finished(artwork.Pattern).parts, metres(artwork.Bleed))
    return [shift for _, shift in laid]


def _picture(sheet):
    import numpy as np

    from BalloonWorkbench.core.results.flat_maps import FlatPicture

    return FlatPicture(sheet.pixels, sheet.origin, sheet.origin + np.array(sheet.size))


def _part(whole, box, shift):
    """What of a picture that is moved by a shift (2,) m lies in a box of corners (2,) m."""
    import numpy as np

    from BalloonWorkbench.core.results.flat_maps import FlatPicture

    height, width = whole.pixels.shape[:2]
    pixel = (whole.high - whole.low) / (width, height)
    low, high = (corner - shift - whole.low for corner in box)
    left, bottom = np.maximum(np.floor(low / pixel).astype(int), 0)
    right, top = np.minimum(np.ceil(high / pixel).astype(int), (width, height))
    corner = whole.low + shift + pixel * (left, bottom)
    return FlatPicture(
        whole.pixels[height - top : height - bottom, left:right],
        corner,
        corner + pixel * (right - left, top - bottom),
    )
