# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seams on a closed body, edited with the mouse in the 3D view; the panel beside it is elsewhere."""
