# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command test-card: settings of a tool are tried, and those of the best field kept."""
