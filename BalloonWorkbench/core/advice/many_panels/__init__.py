# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would go badly with a balloon of many panels, by its design and its pattern; no rules of drawings."""
