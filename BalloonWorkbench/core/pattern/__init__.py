# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fabrication geometry: contours with a meaning, the air intake, the seal."""
