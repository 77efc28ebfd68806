# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is painted: strokes and other steps, tools, the pixels they make; no widgets."""
