# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tabs beside the 3D view have in common: flat views that zoom; what is shown in them is elsewhere."""
