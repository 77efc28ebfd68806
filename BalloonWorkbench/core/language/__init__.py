# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences in other languages. How numbers are written: core/units.py; fonts: core/pages."""
