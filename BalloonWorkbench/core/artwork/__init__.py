# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures carried to the pattern, so that they look right inflated. Previews: core/pictures."""
