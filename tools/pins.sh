#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# pins.sh [OPTION...]   writes beside each list requirements*.in the versions and SHA-256 sums of all that it needs,
# for every Python from 3.10 on and every platform; options are those of uv, such as --upgrade
# Without --upgrade what is pinned already keeps its version. Needs uv on PYTHONPATH.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

for list in requirements.in tools/requirements-*.in; do
    options=(--python-version 3.10)
    case $list in
        # these go into .venv, which has the others from Debian
        requirements.in) options+=(--no-emit-package numpy --no-emit-package fonttools --no-emit-package pyparsing) ;;
        *-checks.in) options=(--python-version 3.11 --no-emit-package numpy) ;;
    esac
    echo "$list"
    .venv/bin/python -m uv pip compile --quiet --universal --generate-hashes --only-binary :all: --no-annotate \
        --custom-compile-command "make pins" "${options[@]}" "$@" "$list" --output-file "${list%.in}.txt"
done
