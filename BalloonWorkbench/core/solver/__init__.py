# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inflation: tension-field membrane and DKT bending under pressure."""
