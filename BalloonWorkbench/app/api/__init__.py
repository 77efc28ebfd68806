# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python API: balloons, and what is made of them. BalloonWorkbench offers its functions by name."""
