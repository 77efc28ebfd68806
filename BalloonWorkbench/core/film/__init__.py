# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films: elasticity, thickness and weight of the sheet a balloon is made of."""
