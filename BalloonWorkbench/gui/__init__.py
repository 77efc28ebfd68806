# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD commands, task panels and view providers; needs FreeCAD's window."""
