# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD document objects; needs FreeCAD, works without a screen."""
