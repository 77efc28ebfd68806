# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the flat pieces of a balloon lie beside each other when the user has moved, turned or mirrored them,
and what they snap to. What is cut of them: core/pattern, core/bag_pattern; sheets of film: core/nesting."""
