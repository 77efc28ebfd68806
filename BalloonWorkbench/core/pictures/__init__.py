# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a finished job: the shaded balloon and the preview. Prints for the film are in core/artwork."""
