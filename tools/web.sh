#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# web.sh [ARGUMENTS]   tries exported pages in a real browser; with arguments of pytest
# Pictures of the pages are in build/web afterwards. Without Chromium it says that nothing was tried.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

OPENBLAS_NUM_THREADS=1 .venv/bin/python -m pytest -q -rs tests/web "$@"
