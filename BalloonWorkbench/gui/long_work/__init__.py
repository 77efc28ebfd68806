# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that takes a while: in a thread, with progress and a stop button; what is worked out is core's."""
