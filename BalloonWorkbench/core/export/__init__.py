# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of files: DXF, SVG, STL and the preview picture."""
