# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing files (SVG, DXF, JSON) to lines and loops, within a budget. Pixels are traced in core/tracing."""
