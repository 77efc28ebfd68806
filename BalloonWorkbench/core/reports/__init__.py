# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of finished jobs: all numbers by name and unit, for people and programs; nothing computed."""
