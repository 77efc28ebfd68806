# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a picture's pixels to outlines: what is drawn, its boundary walked. Vector files: core/readers."""
