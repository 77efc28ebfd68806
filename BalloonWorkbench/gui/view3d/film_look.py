# SPDX-License-Identifier: LGPL-2.1-or-later
"""What films look like: foil mirrors a bright room, clear film is seen through, paper is dull."""

from __future__ import annotations

from functools import cache

import numpy as np

_SIZE = 128  # px of the picture that foil mirrors
_SEAM_SHADE = 0.45  # of the film's colour
_SEAM_WIDTH = 1.5  # px
# ambient, diffuse and specular light that comes back, and how sharp a reflection is
_LIGHT = {
    "foil": (1.00, 1.00, 0.00, 0.0),
    "clear": (0.60, 1.00, 1.00, 0.9),
    "paper": (0.55, 0.95, 0.00, 0.1),
    "matt": (0.45, 1.00, 0.15, 0.3),
}


class FilmLook:
    """Nodes that say how film looks: `film` goes before its shape, `seam` before the seam's line."""

    def __init__(self):
        from pivy import coin

        self.film, self.seam = coin.SoGroup(), coin.SoGroup()
        self._material, self._colour = coin.SoMaterial(), coin.SoBaseColor()
        self._mirror = coin.SoGroup()
        self.film.addChild(self._material)
        self.film.addChild(self._mirror)
        plain, width = coin.SoLightModel(), coin.SoDrawStyle()
        plain.model.setValue(coin.SoLightModel.BASE_COLOR)
        width.lineWidth.setValue(_SEAM_WIDTH)
        for child in (plain, width, self._colour):
            self.seam.addChild(child)

    def show(self, kind: str, colour, opacity: float) -> None:
        """Take the look of a film: a kind of core/film/film.py, its colour (r, g, b) from 0 to 1, opacity."""
        from pivy import coin

        ambient, diffuse, specular, shininess = _LIGHT[kind]
        for field, share in (
            (self._material.ambientColor, ambient),
            (self._material.diffuseColor, diffuse),
        ):
            field.setValue(*(share * part for part in colour))
        self._material.specularColor.setValue(specular, specular, specular)
        self._material.shininess.setValue(shininess)
        self._material.transparency.setValue(1.0 - opacity)
        self._colour.rgb.setValue(*(_SEAM_SHADE * part for part in colour))
        self._mirror.removeAllChildren()
        if kind != "foil":
            return
        self._material.diffuseColor.setValue(1.0, 1.0, 1.0)  # the picture has the colour
        texture, around, plain = coin.SoTexture2(), coin.SoTextureCoordinateEnvironment(), coin.SoLightModel()
        texture.image.setValue(coin.SbVec2s(_SIZE, _SIZE), 3, _room(tuple(colour)))
        texture.wrapS.setValue(coin.SoTexture2.CLAMP)
        texture.wrapT.setValue(coin.SoTexture2.CLAMP)
        plain.model.setValue(coin.SoLightModel.BASE_COLOR)
        for child in (plain, texture, around):
            self._mirror.addChild(child)


@cache
def _room(colour: tuple[float, float, float]) -> bytes:
    """What a ball of foil mirrors in a bright room: a light ceiling, a darker floor, two windows."""
    x, y = np.meshgrid(*2 * [np.linspace(-1.0, 1.0, _SIZE)])
    height = np.sqrt(np.maximum(1.0 - x**2 - y**2, 0.0))
    # the ray that comes back along z after the mirror with normal (x, y, height)
    ray = np.stack([2.0 * height * x, 2.0 * height * y, 2.0 * height**2 - 1.0])
    up = ray[1]
    light = 0.90 + 0.20 * np.tanh(2.0 * up) - 0.18 * np.exp(-((up + 0.35) ** 2) / 0.05)
    light *= 1.0 - 0.40 * np.clip(-ray[2], 0.0, 1.0)  # darker to the edge, where the wall behind is seen
    windows = np.zeros_like(light)
    for centre, width, power in (((-0.55, 0.62, 0.55), 0.06, 0.85), ((0.65, 0.35, 0.65), 0.03, 0.55)):
        direction = np.array(centre) / np.linalg.norm(centre)
        away = 1.0 - np.tensordot(direction, ray, axes=1)
        windows += power / (1.0 + np.exp((away - width) / 0.012))
    rgb = light[..., None] * np.array(colour) + np.clip(windows, 0.0, 1.0)[..., None]
    return (255.0 * np.clip(rgb, 0.0, 1.0)).astype(np.uint8).tobytes()
