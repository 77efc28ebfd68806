# SPDX-License-Identifier: LGPL-2.1-or-later
"""python -m BalloonWorkbench"""

import os
import sys

#: NumPy's own threads gain nothing at our sizes, and round otherwise than one does: the same input would not
#: always give the same numbers. The solver has threads of its own.
_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def _start() -> int:
    for number in range(3):  # a file that we open must not get the number of a closed output
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    for name in _THREADS:
        os.environ.setdefault(name, "1")
    try:
        from BalloonWorkbench.cli.command_line import main
    except KeyboardInterrupt:
        return 130
    except ImportError as error:
        return _cannot_start(error)
    return main()


def _cannot_start(error: ImportError) -> int:
    """NumPy is the one package without which nothing begins."""
    from BalloonWorkbench.cli.console import complain
    from BalloonWorkbench.core import packages

    reason = next((told for told in packages.missing() if " numpy " in told), None)
    first = str(error).strip().partition("\n")[0]
    complain(reason or f"A Python package cannot be loaded ({first}). Install it anew.")
    return 2


if __name__ == "__main__":
    sys.exit(_start())
