# SPDX-License-Identifier: LGPL-2.1-or-later
"""Energies, forces and stiffnesses of the film: of a triangle, of a hinge of the seam and of all of them."""
