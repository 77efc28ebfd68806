# SPDX-License-Identifier: LGPL-2.1-or-later
"""Balloons of many panels as they are seen: flat panels, seams by colour, both edges of a seam linked."""
