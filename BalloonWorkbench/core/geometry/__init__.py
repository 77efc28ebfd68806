# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane geometry of points, polylines, loops and triangles, each helper once; no balloon, film or file in it.

A line is points (n, 2) in their order. A loop is closed: its last point is joined to its first, which is not
repeated. What runs counter-clockwise has its inside on the left. NumPy does all of it; shapely, where it is
there, joins, cuts and offsets areas, and finds what is near among very much.
"""
