# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet that is painted on: mouse, tablet, zoom, what lies over the painting; not what is painted."""
