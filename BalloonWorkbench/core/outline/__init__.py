# SPDX-License-Identifier: LGPL-2.1-or-later
"""Outlines: closed loops of what is to be seen inflated, valid and symmetric. Reading: tracing, readers."""
