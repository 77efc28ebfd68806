# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags: flat panels and the seams between their edges, read, checked and meshed; nothing inflated."""
