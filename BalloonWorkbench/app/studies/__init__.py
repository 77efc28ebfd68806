# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants of a balloon in a document: their table, and how each is worked out; running studies is core's."""
