# SPDX-License-Identifier: LGPL-2.1-or-later
"""The painted balloon and its pattern in the 3D view, as long as they are no document objects."""

from __future__ import annotations

import FreeCADGui as Gui
import numpy as np

from BalloonWorkbench.app.qt_picture import pixels
from BalloonWorkbench.core.export.layers import LAYERS
from BalloonWorkbench.core.pattern.pattern import Role
from BalloonWorkbench.gui.qt import QtCore, QtGui

_TEXTURE = 512  # px
_FOIL = (236, 238, 242)  # colour of the film where nothing is painted
_TILT = -35.0  # degrees that the balloon leans back, so that it is seen to be round
_BESIDE = 0.12  # gap to the pattern, of the balloon's width
_CREASE = 0.7  # rad between facets that are shaded as one surface
_AROUND = 1.25  # of what is seen, for the view
_GROWN = 0.1  # change of the size from which the camera follows


class Scene:
    """Shows looks in the view of a document; `clear` takes everything away."""

    def __init__(self, document_name: str):
        self.document_name = document_name
        self._root = None
        self._node = None
        self._size: tuple[float, ...] | None = None

    def is_shown(self) -> bool:
        return self._node is not None

    def show(self, look, image) -> None:
        """Show a look instead of the last one; image: what is painted."""
        from pivy import coin

        view = self._view()
        if view is None:
            return
        node = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style.setValue(coin.SoPickStyle.UNPICKABLE)
        node.addChild(style)
        node.addChild(_balloons(coin, look, image))
        node.addChild(_pattern(coin, look))
        if self._node is not None:
            self._root.removeChild(self._node)
        self._root, self._node = view.getSceneGraph(), node
        self._root.addChild(node)
        before = self._size
        if before is None:
            self._look_at(coin, view)
        if before is None or any(
            abs(now - then) > _GROWN * max(before) for now, then in zip(look.size, before, strict=True)
        ):
            _fit(view, node)
            self._size = look.size
        view.redraw()  # together with the canvas: each picture of the whole window takes its time

    def clear(self) -> None:
        """Take the balloon away."""
        if self._node is not None and self.document() is not None:
            self._root.removeChild(self._node)
        self._root = self._node = self._size = None

    def document(self):
        """The document in the window; None when it is being closed."""
        try:
            return Gui.getDocument(self.document_name)
        except NameError:
            return None

    def _view(self):
        document = self.document()
        view = document.activeView() if document is not None else None
        if view is None or not hasattr(view, "getSceneGraph"):
            views = document.mdiViewsOfType("Gui::View3DInventor") if document is not None else []
            view = views[0] if views else None
        return view

    @staticmethod
    def _look_at(coin, view) -> None:
        camera = view.getCameraNode()
        camera.orientation.setValue(coin.SbRotation(coin.SbVec3f(1, 0, 0), float(np.radians(-_TILT))))


def _fit(view, node) -> None:
    """Let a node fill the view. FreeCAD fits a ball around everything: a narrow view stays half empty."""
    from pivy import coin

    camera, (width, height) = view.getCameraNode(), view.getSize()
    if camera.getTypeId() != coin.SoOrthographicCamera.getClassTypeId() or min(width, height) < 1:
        view.fitAll()
        return
    action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(width, height))
    action.apply(node)
    box = action.getBoundingBox()
    low, high = (np.array(corner.getValue()) for corner in (box.getMin(), box.getMax()))
    turn = _axes(*camera.orientation.getValue().getValue())
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)])
    seen = corners @ turn.T
    across, up, deep = np.ptp(seen, axis=0) * _AROUND
    aspect = width / height
    middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0)) + np.array([0.0, 0.0, deep])
    camera.position.setValue(*(middle @ turn).tolist())
    camera.focalDistance.setValue(float(deep))
    # Coin takes the height for the smaller side of the view
    camera.height.setValue(float(max(across, up * aspect) if aspect < 1.0 else max(up, across / aspect)))


def _axes(x, y, z, w) -> np.ndarray:
    """Right, up and backward of a camera that was turned by a quaternion, as rows."""
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
            [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
            [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def film_nodes(coin, image) -> list:
    """How film looks with a picture on it: what has to stand before its shape."""
    hints = coin.SoShapeHints()
    hints.vertexOrdering.setValue(coin.SoShapeHints.COUNTERCLOCKWISE)
    hints.shapeType.setValue(coin.SoShapeHints.SOLID)
    hints.creaseAngle.setValue(_CREASE)
    material = coin.SoMaterial()
    material.diffuseColor.setValue(1, 1, 1)
    material.ambientColor.setValue(0.35, 0.35, 0.35)
    material.specularColor.setValue(0.5, 0.5, 0.5)
    material.shininess.setValue(0.6)
    texture = coin.SoTexture2()
    texture.image.setValue(coin.SbVec2s(_TEXTURE, _TEXTURE), 3, _texels(image))
    texture.wrapS.setValue(coin.SoTexture2.CLAMP)
    texture.wrapT.setValue(coin.SoTexture2.CLAMP)
    places = coin.SoTextureCoordinateBinding()
    places.value.setValue(coin.SoTextureCoordinateBinding.PER_VERTEX_INDEXED)
    return [hints, material, texture, places]


def _balloons(coin, look, image):
    node = coin.SoSeparator()
    binding = coin.SoNormalBinding()
    binding.value.setValue(coin.SoNormalBinding.PER_VERTEX_INDEXED)
    for child in (*film_nodes(coin, image), binding):
        node.addChild(child)
    for skin in look.skins:
        node.addChild(_skin(coin, skin))
    return node


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
    return node


def _pattern(coin, look):
    """The contours in the colours of the cutter's layers, below the balloon."""
    node = coin.SoSeparator()
    if not look.contours:
        return node
    light = coin.SoLightModel()
    light.model.setValue(coin.SoLightModel.BASE_COLOR)
    style = coin.SoDrawStyle()
    style.lineWidth.setValue(2.0)
    bottom = min(float(skin.positions[:, 1].min()) for skin in look.skins)
    top = max(float(points[:, 1].max()) for _, points in look.contours)
    place = coin.SoTranslation()
    place.translation.setValue(0.0, bottom - top - _BESIDE * look.size[0], 0.0)
    for child in (light, style, place):
        node.addChild(child)
    for role, points in look.contours:
        colour, line = coin.SoBaseColor(), coin.SoLineSet()
        coordinates = coin.SoCoordinate3()
        colour.rgb.setValue(*_layer_colour(role))
        corners = [(x, y, 0.0) for x, y in np.concatenate([points, points[:1]]).tolist()]
        coordinates.point.setValues(0, len(corners), corners)
        line.numVertices.setValue(len(corners))
        for child in (colour, coordinates, line):
            node.addChild(child)
    return node


def _layer_colour(role: str) -> tuple[float, ...]:
    rgb = LAYERS[Role(role)].rgb
    return tuple(int(rgb[i : i + 2], 16) / 255 for i in (1, 3, 5))


def _texels(image) -> bytes:
    """The painting on film, the lowest row first."""
    sheet = QtGui.QImage(_TEXTURE, _TEXTURE, QtGui.QImage.Format_RGB32)
    sheet.fill(QtGui.QColor(*_FOIL))
    painter = QtGui.QPainter(sheet)
    painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
    painter.drawImage(QtCore.QRectF(sheet.rect()), image)
    painter.end()
    return np.ascontiguousarray(pixels(sheet)[::-1, :, :3]).tobytes()
