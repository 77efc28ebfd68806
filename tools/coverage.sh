#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# coverage.sh   how much of core and app the tests run; fails below 95 % of core, 85 % of app
set -uo pipefail
cd "$(dirname "$(realpath "$0")")/.." || exit 1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p build/coverage "$scratch/core" "$scratch/app"
export COVERAGE_FILE=$PWD/build/coverage/data
.venv/bin/python -m coverage erase
FREECAD_USER_HOME=$scratch/core .venv/bin/python -m coverage run --parallel-mode -m pytest -q tests/core tests/cli || exit 1
# FreeCAD is started from outside: its own process measures itself, see tests/freecad_pytest.py
BALLOON_COVERAGE=1 timeout --kill-after=30 2400 \
    tools/in-freecad.sh "$scratch/app" freecadcmd tests/freecad_pytest.py || exit 1
.venv/bin/python -m coverage combine --quiet
result=0
for part in core:95 app:85; do
    .venv/bin/python -m coverage report --include="BalloonWorkbench/${part%:*}/*" --fail-under="${part#*:}" \
        --skip-covered --sort=cover | tee "build/coverage/${part%:*}.txt" | tail -n 25 || result=1
done
exit $result
