# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: options, commands, what they print; the work itself is core's."""
