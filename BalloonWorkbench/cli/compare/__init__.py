# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command compare, as it is typed and as it runs; what it works out is in core/as_made."""
