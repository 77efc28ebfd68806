#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# matrix.sh STEP...   the steps of test.sh, one after the other, with the FreeCAD of other Debian releases
# SUITES="trixie forky": trixie has FreeCAD 1.0 with Qt 5, forky 1.1 with Qt 6. Needs root.
# Each leaves build/logs/STEP-SUITE.log.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

result=0
for suite in ${SUITES:-trixie forky}; do
    if ! root=$(tools/freecad-root.sh "$suite"); then
        echo "NOT TRIED: FreeCAD of $suite; its root could not be made here."
        continue
    fi
    echo "== $suite: $(chroot "$root" dpkg-query -W -f '${Package} ${Version}' freecad-python3)"
    for step in "$@"; do
        SUITE=-$suite tools/in-root.sh "$root" tools/test.sh "$step" || result=1
    done
done
exit $result
