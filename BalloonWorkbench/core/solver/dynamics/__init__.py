# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflation in time by Newmark's method, and frames of it; equilibrium alone is beside."""
