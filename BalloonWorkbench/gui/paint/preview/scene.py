# SPDX-License-Identifier: LGPL-2.1-or-later
"""The painted balloon and its pattern in the 3D view, as long as they are no document objects."""

from __future__ import annotations

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app.document.arrange import free_shift
from BalloonWorkbench.app.drawings.qt_picture import pixels
from BalloonWorkbench.core.geometry.polyline import bounds, ring
from BalloonWorkbench.core.machines.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.core.tracing.raster import label, neighbours
from BalloonWorkbench.gui.qt import QtCore, QtGui
from BalloonWorkbench.gui.view3d.fit_view import fit_points, view_of

_TEXTURE = 512  # px
_FOIL = (236, 238, 242)  # colour of the film where nothing is painted
_TILT = -35.0  # degrees that the balloon leans back, so that it is seen to be round
_BESIDE = 0.12  # gap to the pattern, of the balloon's width
_CREASE = 0.7  # rad between facets that are shaded as one surface
_AROUND = 1.25  # of what is seen, for the view
_GROWN = 0.1  # change of the size from which the camera follows
_MOVING = 300  # ms that a movement takes
_FRAME = 30  # ms between its pictures
_NEAREST = 3  # vertices of the last balloon between which a new one begins
_SPREAD = (2, 6)  # px of the texture, that paint is carried on beyond its outline, one after the other
_RIM = 2  # px inside the outline that take part: there, paint is half transparent


class Scene:
    """Shows states in the view of a document; `clear` takes everything away.

    From a quick look to the fitted balloon the film moves, and the camera follows, over a moment.
    """

    def __init__(self, document_name: str, parts=None):
        self.document_name, self.parts = document_name, parts
        self._root = None
        self._node = None
        self._look = None
        self._texture = None
        self._size: tuple[float, ...] | None = None
        self._shift = 0.0  # mm to the right, of a new balloon, from what is in the document
        self._moves: list = []  # each takes a part from 0 to 1
        self._clock = QtCore.QElapsedTimer()
        self._timer = QtCore.QTimer()
        self._timer.setInterval(_FRAME)
        self._timer.timeout.connect(self._move)

    def is_shown(self) -> bool:
        return self._node is not None

    def is_moving(self) -> bool:
        """The film is on its way to the state that was shown last."""
        return self._timer.isActive()

    def paint(self, image) -> None:
        """Show what is painted on the balloon that is there."""
        if self._texture is not None:
            _set_texels(self._texture, image)

    def show(self, state, image) -> None:
        """Show a state instead of the last one; image: what is painted."""
        from pivy import coin

        view = view_of(self.document())
        if view is None:
            return
        before, self._look = self._look, state
        if before is not None and state.skins is before.skins and state.contours is before.contours:
            self.paint(image)
            view.redraw()
            return
        self._end()
        node = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style.setValue(coin.SoPickStyle.UNPICKABLE)
        self._texture = painted_texture(coin, image)
        film, points = _balloons(coin, state, self._texture)
        for child in (style, self._place(coin, state), film, _pattern(coin, state)):
            node.addChild(child)
        if before is not None and state.fitted and state.skins is not before.skins:
            self._moves += [
                _film_move(field, begun(skin, last), skin.positions)
                for field, skin, last in zip(points, state.skins, before.skins)
            ]
        if self._node is not None:
            self._root.removeChild(self._node)
        self._root, self._node = view.getSceneGraph(), node
        self._root.addChild(node)
        self._follow(coin, view, state)
        if self._moves:
            self._clock.start()
            self._timer.start()
            self._move()
        else:
            view.redraw()  # together with the canvas: each picture of the whole window takes its time

    def clear(self) -> None:
        """Take the balloon away."""
        self._timer.stop()
        self._moves.clear()
        if self._node is not None and self.document() is not None:
            self._root.removeChild(self._node)
        self._root = self._node = self._size = self._look = self._texture = None
        self._shift = 0.0

    def _follow(self, coin, view, state) -> None:
        """The camera goes where it sees all of a balloon that has become larger or smaller."""
        before = self._size
        if before is None:
            self._look_at(coin, view)
            fit_points(view, _corners(coin, view, self._node), _AROUND)
            self._size = state.size
        elif any(
            abs(now - then) > _GROWN * max(before) for now, then in zip(state.size, before, strict=True)
        ):
            camera = view.getCameraNode()
            then = _frame(camera)
            fit_points(view, _corners(coin, view, self._node), _AROUND)
            now, self._size = _frame(camera), state.size
            if len(then) == len(now):
                self._moves.append(lambda part: _set_frame(camera, then + part * (now - then)))

    def _move(self) -> None:
        """The next picture of a movement."""
        view = view_of(self.document())
        if view is None:
            self._timer.stop()
            return
        part = min(1.0, self._clock.elapsed() / _MOVING)
        for move in self._moves:
            move(part * part * (3.0 - 2.0 * part))
        if part == 1.0:
            self._timer.stop()
            self._moves.clear()
        view.redraw()

    def _end(self) -> None:
        """What is still moving arrives."""
        self._timer.stop()
        for move in self._moves:
            move(1.0)
        self._moves.clear()

    def document(self):
        """The document in the window; None when it is being closed."""
        try:
            return Gui.getDocument(self.document_name)
        except NameError:
            return None

    def _place(self, coin, state):
        """Where the balloon lies that is painted on; a new one beside all that is in the document."""
        place = coin.SoTransform()
        if self.parts is not None:
            at = self.parts.outline.getGlobalPlacement()
            place.translation.setValue(*at.Base)
            place.rotation.setValue(*at.Rotation.Q)
        else:
            seen = np.concatenate([skin.positions[:, :2] for skin in state.skins])
            low, high = bounds(seen)
            if state.contours:
                low[1] -= _BESIDE * state.size[0] + np.ptp(_pattern_points(state)[:, 1])
            low[0], high[0] = low[0] + self._shift, high[0] + self._shift
            self._shift += free_shift(self.document().Document, low.tolist(), high.tolist())
            place.translation.setValue(self._shift, 0.0, 0.0)
        return place

    @staticmethod
    def _look_at(coin, view) -> None:
        camera = view.getCameraNode()
        camera.orientation.setValue(coin.SbRotation(coin.SbVec3f(1, 0, 0), float(np.radians(-_TILT))))


def begun(skin, last) -> np.ndarray:
    """Positions (n, 3) of a skin on the surface of the last one, where the same is painted."""
    count, half = len(last.positions) // 2, len(skin.positions) // 2
    away = ((skin.places[:half, None] - last.places[None, :count]) ** 2).sum(axis=2)
    nearest = np.argpartition(away, _NEAREST, axis=1)[:, :_NEAREST]
    weight = 1.0 / (np.take_along_axis(away, nearest, axis=1) + 1e-12)
    weight /= weight.sum(axis=1, keepdims=True)
    return np.concatenate(
        [np.einsum("nk,nki->ni", weight, side[nearest]) for side in np.split(last.positions, [count])]
    )


def _film_move(field, start: np.ndarray, end: np.ndarray):
    """A movement of the film's vertices (n, 3)."""

    def move(part: float) -> None:
        positions = start + part * (end - start)
        field.setValues(0, len(positions), positions.tolist())

    return move


def _frame(camera) -> np.ndarray:
    """What of a camera decides what it shows, but for its direction."""
    height = [camera.height.getValue()] if hasattr(camera, "height") else []
    return np.array([*camera.position.getValue().getValue(), camera.focalDistance.getValue(), *height])


def _set_frame(camera, values: np.ndarray) -> None:
    camera.position.setValue(*values[:3].tolist())
    camera.focalDistance.setValue(float(values[3]))
    if len(values) > 4:
        camera.height.setValue(float(values[4]))


def _corners(coin, view, node) -> np.ndarray:
    """Corners (8, 3) of a box around a node."""
    action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(*view.getSize()))
    action.apply(node)
    box = action.getBoundingBox()
    low, high = (np.array(corner.getValue()) for corner in (box.getMin(), box.getMax()))
    return np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)])


def film_nodes(coin, texture) -> list:
    """How film looks with a texture on it: what has to stand before its shape."""
    hints = coin.SoShapeHints()
    hints.vertexOrdering.setValue(coin.SoShapeHints.COUNTERCLOCKWISE)
    hints.shapeType.setValue(coin.SoShapeHints.SOLID)
    hints.creaseAngle.setValue(_CREASE)
    material = coin.SoMaterial()
    material.diffuseColor.setValue(1, 1, 1)
    material.ambientColor.setValue(0.35, 0.35, 0.35)
    material.specularColor.setValue(0.5, 0.5, 0.5)
    material.shininess.setValue(0.6)
    texture.wrapS.setValue(coin.SoTexture2.CLAMP)
    texture.wrapT.setValue(coin.SoTexture2.CLAMP)
    places = coin.SoTextureCoordinateBinding()
    places.value.setValue(coin.SoTextureCoordinateBinding.PER_VERTEX_INDEXED)
    return [hints, material, texture, places]


def painted_texture(coin, image):
    """A texture node with what is painted on film."""
    texture = coin.SoTexture2()
    _set_texels(texture, image)
    return texture


def _set_texels(texture, image) -> None:
    from pivy import coin

    texture.image.setValue(coin.SbVec2s(_TEXTURE, _TEXTURE), 3, texels(image).tobytes())


def _balloons(coin, state, texture):
    """The film of all balloons, and the field with the positions of each."""
    node, fields = coin.SoSeparator(), []
    binding = coin.SoNormalBinding()
    binding.value.setValue(coin.SoNormalBinding.PER_VERTEX_INDEXED)
    for child in (*film_nodes(coin, texture), binding):
        node.addChild(child)
    for skin in state.skins:
        film, points = _skin(coin, skin)
        node.addChild(film)
        fields.append(points)
    return node, fields


def _skin(coin, skin):
    node = coin.SoSeparator()
    positions, normals = coin.SoCoordinate3(), coin.SoNormal()
    places, faces = coin.SoTextureCoordinate2(), coin.SoIndexedFaceSet()
    positions.point.setValues(0, len(skin.positions), skin.positions.tolist())
    normals.vector.setValues(0, len(skin.normals), skin.normals.tolist())
    places.point.setValues(0, len(skin.places), skin.places.tolist())
    corners = np.concatenate([skin.triangles, np.full((len(skin.triangles), 1), -1)], axis=1).ravel().tolist()
    faces.coordIndex.setValues(0, len(corners), corners)
    for child in (positions, normals, places, faces):
        node.addChild(child)
    return node, positions.point


def _pattern(coin, state):
    """The contours in the colours of the cutter's layers, below the balloon."""
    node = coin.SoSeparator()
    if not state.contours:
        return node
    light = coin.SoLightModel()
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    style = coin.SoDrawStyle()
    style.lineWidth.setValue(2.0)
    bottom = min(float(skin.positions[:, 1].min()) for skin in state.skins)
    top = float(_pattern_points(state)[:, 1].max())
    place = coin.SoTranslation()
    place.translation.setValue(0.0, bottom - top - _BESIDE * state.size[0], 0.0)
    for child in (light, style, place):
        node.addChild(child)
    for role, points in state.contours:
        colour, line = coin.SoBaseColor(), coin.SoLineSet()
        coordinates = coin.SoCoordinate3()
        colour.rgb.setValue(*_layer_colour(role))
        corners = [(x, y, 0.0) for x, y in ring(points).tolist()]
        coordinates.point.setValues(0, len(corners), corners)
        line.numVertices.setValue(len(corners))
        for child in (colour, coordinates, line):
            node.addChild(child)
    return node


def _pattern_points(state) -> np.ndarray:
    return np.concatenate([points for _, points in state.contours])


def _layer_colour(role: str) -> tuple[float, ...]:
    rgb = LAYERS[Role(role)].rgb
    return tuple(int(rgb[i : i + 2], 16) / 255 for i in (1, 3, 5))


def texels(image) -> np.ndarray:
    """The painting on film (n, n, 3), the lowest row first.

    Paint goes on a little beyond its outline: the rim of the film would show half of what lies outside.
    """
    own = QtGui.QImage(_TEXTURE, _TEXTURE, QtGui.QImage.Format_ARGB32_Premultiplied)
    own.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(own)
    painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
    painter.drawImage(QtCore.QRectF(own.rect()), image)
    painter.end()
    labels, _ = label(np.pad(pixels(own)[..., 3] < 128, 1, constant_values=True))
    outside = labels == labels[0, 0]
    for _ in range(_RIM):
        outside = neighbours(outside)
    inside, beyond = _on_foil(own), _on_foil(_spread(own))
    return np.ascontiguousarray(np.where(outside[1:-1, 1:-1, None], beyond, inside)[::-1])


def _spread(image):
    """The image with its paint carried on over what is bare beside it."""
    for reach in _SPREAD:
        below = image.copy()
        painter = QtGui.QPainter(image)
        painter.setCompositionMode(QtGui.QPainter.CompositionMode_DestinationOver)
        for x in (-reach, 0, reach):
            for y in (-reach, 0, reach):
                painter.drawImage(x, y, below)
        painter.end()
    return image


def _on_foil(image) -> np.ndarray:
    """Pixels (h, w, 3) of a transparent image over bare film."""
    sheet = QtGui.QImage(image.size(), QtGui.QImage.Format_RGB32)
    sheet.fill(QtGui.QColor(*_FOIL))
    painter = QtGui.QPainter(sheet)
    painter.drawImage(0, 0, image)
    painter.end()
    return pixels(sheet)[..., :3]
