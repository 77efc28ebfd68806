#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# pythons.sh [VERSION...]   the engine with other versions of Python (3.10, 3.12), each with packages of its own
# and as on another processor: linear algebra rounds otherwise there, and no test may hang on that.
# A Python is looked for on PATH and among those of pyenv; one that is not there is told. 3.11 is that of .venv,
# matrix.sh has 3.13 and 3.14. Each leaves build/logs/core-VERSION.log.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

list=tools/requirements-pythons.txt
mapfile -t tests < <(grep -v '^#' tools/engine-tests.txt)
declare -A processor=([3.10]=Prescott [3.12]=SandyBridge) # names of OpenBLAS
versions=("$@")
[ ${#versions[@]} -gt 0 ] || versions=(3.10 3.12)

python_of() {
    local found
    for found in "$(command -v "python$1" || true)" "${PYENV_ROOT:-$HOME/.pyenv}/versions/$1".*/bin/python; do
        if [ -x "$found" ] && "$found" -c 'import venv' 2>/dev/null; then
            echo "$found"
            return
        fi
    done
    return 1
}

# the other processor has work of its own
export OPENBLAS_NUM_THREADS=1
result=0
mkdir -p build/logs
for version in "${versions[@]}"; do
    if ! python=$(python_of "$version"); then
        echo "== core with Python $version: there is none here, nothing was tried"
        continue
    fi
    echo "== core with $("$python" --version)"
    home=build/python/$version
    wanted="$("$python" --version) $(sha256sum "$list")"
    if [ "$(cat "$home/made-from" 2>/dev/null)" != "$wanted" ]; then
        "$python" -m venv --clear "$home"
        tools/pip-install.sh "$home/bin/python" --requirement "$list"
        echo "$wanted" >"$home/made-from"
    fi
    OPENBLAS_CORETYPE=${processor[$version]:-} "$home/bin/python" -m pytest -q -o cache_dir=build/pytest ${BALLOON_TESTS:-"${tests[@]}"} </dev/null 2>&1 |
        tee "build/logs/core-$version.log" | tail -n 12 || result=1
done
exit $result
