# SPDX-License-Identifier: LGPL-2.1-or-later
"""Segmentation: where the seams of a target lie, proposed or drawn by the user; nothing laid flat."""
