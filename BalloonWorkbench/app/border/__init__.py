# SPDX-License-Identifier: LGPL-2.1-or-later
"""The border to FreeCAD and to the window: no error passes it, and what the window replaces is here."""
