# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a balloon and its boxes: drawing, film, pattern, simulation, result."""
