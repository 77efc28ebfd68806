# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users change in a division: seams merged, cut, moved and drawn over the surface; no proposal."""
