# SPDX-License-Identifier: LGPL-2.1-or-later
"""python -m BalloonWorkbench"""

import sys

from BalloonWorkbench.cli import main

sys.exit(main())
