# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of a PDF in real size, and the fonts on them. What stands on a page is decided elsewhere."""
