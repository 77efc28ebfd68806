# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films and fillings: elasticity, thickness, weight, buoyancy. How film deforms: core/solver."""
