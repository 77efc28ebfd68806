# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels of a divided target, inflated and corrected until the balloon lies on it; no weld, no cut."""
