# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bags inflated, and their panels corrected until the balloon is what was wanted; no weld, no cut."""
