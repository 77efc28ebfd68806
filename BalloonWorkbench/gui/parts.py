# SPDX-License-Identifier: LGPL-2.1-or-later
"""From any object of a balloon to all of them."""

from BalloonWorkbench.app.parts import parts_of, patterns  # noqa: F401
