# SPDX-License-Identifier: LGPL-2.1-or-later
"""The air intake of a pattern: its kinds, its place, its neck, the film valve in it."""
