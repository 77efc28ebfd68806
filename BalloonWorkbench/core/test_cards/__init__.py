# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cards on which two settings of a tool are tried, and the machine file with those of the best field.

What lies on a card, its files, what is kept of it. How a tool moves: core/machines.
"""
