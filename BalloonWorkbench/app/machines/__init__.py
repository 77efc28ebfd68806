# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pattern of a document on a machine: its bed, its tool paths."""
