# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangulated flat panels: even, mirrored, kept while they stay valid. How panels meet: core/panels."""
