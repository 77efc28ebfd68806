# SPDX-License-Identifier: LGPL-2.1-or-later
"""What shows a balloon of a document to others, as files; how these are made is core's (core/shared)."""
