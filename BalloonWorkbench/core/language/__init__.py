# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences in other languages, and the fonts that show them. How numbers are written: core/units.py."""
