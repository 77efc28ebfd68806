# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets: closed bodies that a balloon is to fill: read, repaired, and divided into panels by anybody."""
