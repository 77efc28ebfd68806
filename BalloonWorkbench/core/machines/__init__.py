# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cutters get of a pattern: toolpaths, order, kerf and knife, checks. File formats: machines/writers."""
