# SPDX-License-Identifier: LGPL-2.1-or-later
"""The balloon beside the canvas while it is painted: quick and full designs, shown in the 3D view."""
