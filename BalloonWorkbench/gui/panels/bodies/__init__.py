# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of the balloon's panel for what is made of many panels: a body of gores, a bag, a side band."""
