# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern correction: the iteration that changes a pattern until its balloon looks like the drawing.

What a design is, and how far a balloon is from its drawing, lies in core/design.
"""
