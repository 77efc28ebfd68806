# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nesting: panels laid out on a roll or on sheets of film. What lies on a pattern: core/pattern."""
