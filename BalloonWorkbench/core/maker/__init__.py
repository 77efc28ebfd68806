# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a maker wants to know: film, weld, weight, lift, safe pressure, cost."""
