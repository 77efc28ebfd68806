# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines: closed loops of what the user wants to see inflated."""
