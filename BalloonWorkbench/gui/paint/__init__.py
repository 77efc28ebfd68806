# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paint window: strokes on a canvas, the balloon beside it while they are drawn."""
