# SPDX-License-Identifier: LGPL-2.1-or-later
"""Newton's iteration to rest in NumPy, its linear systems and when it stops; no elements."""
