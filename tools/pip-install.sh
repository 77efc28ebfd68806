#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# pip-install.sh PYTHON ARGUMENT...   pip install of whole lists: only files with the sums that a list holds, no builds
set -euo pipefail
exec "$1" -m pip install --quiet --disable-pip-version-check --no-deps --only-binary=:all: --require-hashes "${@:2}"
