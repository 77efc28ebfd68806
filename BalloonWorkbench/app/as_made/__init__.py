# SPDX-License-Identifier: LGPL-2.1-or-later
"""A balloon of a document beside a photograph of what was made; what is worked out is in core/as_made."""
