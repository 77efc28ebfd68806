# SPDX-License-Identifier: LGPL-2.1-or-later
"""From an assembly and a pressure to the balloon at rest: the dimensionless problem and its two solvers."""
