# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tool makes of one contour: kerf, knife, start, tabs. Order of all contours, lead-ins: machines."""
