# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies as bags: what panels make a profile of gores, a box, a letter with a side band; nothing inflated."""
