# SPDX-License-Identifier: LGPL-2.1-or-later
"""The patterns of many panels: weld, cut, marks that match, order of assembly; nothing inflated."""
