# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons in 3D with what is printed on them, as GLB files and pictures. Bare meshes: core/results."""
