# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and arcs in place of polylines: fitting, biarcs, curves. Plane geometry: no pattern, no machine."""
