# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fabrication geometry: contours with a role, seal, cut, marks, labels. Files of them: core/machines."""
