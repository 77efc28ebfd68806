# SPDX-License-Identifier: LGPL-2.1-or-later
"""Artwork: pictures carried to the pattern, so that they look right on the inflated balloon."""
