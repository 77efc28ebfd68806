# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat pieces of a pattern in a tab beside the 3D view: looked at, picked, measured; never changed."""
