# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that tells how to make a balloon. Its numbers come from core/making."""
