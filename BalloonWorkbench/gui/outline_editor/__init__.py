# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor of a traced outline: its nodes over the picture, in a tab; what an edit does is core's."""
