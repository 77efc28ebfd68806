# SPDX-License-Identifier: LGPL-2.1-or-later
"""What making a balloon takes: weight, lift, safe pressure, cost. How it is made: core/assembly_sheet."""
