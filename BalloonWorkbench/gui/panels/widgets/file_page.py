# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of an object that may come from a file."""

from __future__ import annotations

import os

from BalloonWorkbench.gui.panels.widgets.fields import PropertyPage
from BalloonWorkbench.gui.panels.widgets.file_row import FileRow
from BalloonWorkbench.gui.qt import translate
from BalloonWorkbench.gui.window import macro_recorder


class FilePage(PropertyPage):
    """Keeps a file of the user in a property of the object; a page puts `file` where it belongs.

    prop  name of that property; take_in: copies a file at a path into it, raises OSError
    """

    def __init__(self, obj, file: FileRow, prop: str, take_in):
        super().__init__(obj)
        self.file, self._prop, self._take_in = file, prop, take_in
        file.show_name(os.path.basename(getattr(obj, prop)))
        file.chosen.connect(self.choose)

    def choose(self, path: str) -> None:
        """Take a file."""
        try:
            self._take_in(self.obj, path)
        except OSError:
            self.refused.emit(translate("There is no file {}: check the name and the folder.").format(path))
            return
        macro_recorder.came_from(self.obj, path, self._prop)
        self.file.show_name(os.path.basename(path))
        self.changed.emit()

    def finish_typing(self) -> None:
        super().finish_typing()
        self.file.take()

    def release(self) -> None:
        self.file.release()
        super().release()
