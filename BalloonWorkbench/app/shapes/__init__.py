# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines and patterns as FreeCAD's wires, faces and sketches; no values of objects."""
