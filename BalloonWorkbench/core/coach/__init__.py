# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coach: which parts of a shape will inflate badly, where, and what would mend them."""
