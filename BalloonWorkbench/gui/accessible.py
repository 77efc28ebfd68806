# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names that screen readers say; no balloon in it."""

from __future__ import annotations

import re

from BalloonWorkbench.gui.qt import QtWidgets

_FIELDS = (
    QtWidgets.QLineEdit,
    QtWidgets.QComboBox,
    QtWidgets.QAbstractSpinBox,
    QtWidgets.QAbstractSlider,
    QtWidgets.QAbstractItemView,
)
_TAGS = re.compile(r"<[^>]*>")


def name_field(widget, name: str) -> None:
    """Name the first field in a widget, itself among them, unless it has a name."""
    fields = [each for each in (widget, *widget.findChildren(QtWidgets.QWidget)) if isinstance(each, _FIELDS)]
    if fields and not fields[0].accessibleName():
        fields[0].setAccessibleName(_TAGS.sub("", name))


def sign_button(sign: str, tip: str):
    """A button with a sign in place of words, or for an icon where the sign is empty; its tip names it."""
    button = QtWidgets.QToolButton()
    button.setText(sign)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    return button
