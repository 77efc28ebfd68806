# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proxies that store nothing: the state of a document object is in its properties."""

from __future__ import annotations


class Stateless:
    """Base of all proxies; FreeCAD asks these methods what to save beside the properties."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # FreeCAD 0.20 asks for these names
    __getstate__ = dumps
    __setstate__ = loads
