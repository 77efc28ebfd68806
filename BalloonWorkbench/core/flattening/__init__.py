# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a divided target laid flat, with seams that are equally long on both sides; nothing inflated."""
