# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mending: one closed body out of the triangles of any mesh, or one sentence about where it cannot be."""
