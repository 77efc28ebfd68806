# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of the 3D view: film, maps, legends, marks, handles; the view providers are in gui itself."""
