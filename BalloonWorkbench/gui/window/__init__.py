# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own window: tree, selection, macros, preferences, file dialogs, units; no panels of ours."""
