# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths as files: DXF, SVG, HPGL, LightBurn, PDF. What is cut and in which order is decided before."""
