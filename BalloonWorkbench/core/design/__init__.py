# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs: a pattern with its balloon, how far that is from the drawing, its first pattern, and its size.

The iteration that corrects a pattern lies in core/correction; the film itself in core/solver.
"""
