# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat pieces of film and how they are sealed together; no film data, no mesh making."""
