# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane geometry of points, polylines, loops and triangles, each helper once; no balloon, film or file in it.

A line is points (n, 2) in their order. A loop is closed: its last point is joined to its first, which is not
repeated. What runs counter-clockwise has its inside on the left. All of it is NumPy, so that it works where
shapely is missing; shapely stays where areas are joined, cut and offset.
"""
