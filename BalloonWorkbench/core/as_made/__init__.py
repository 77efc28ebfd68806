# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was made beside what was worked out: a photograph over the silhouette, a scan over the cut."""
