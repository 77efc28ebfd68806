# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine: arrays in, arrays out, SI units; imports neither FreeCAD nor Qt."""
