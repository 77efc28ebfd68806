#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# test.sh STEP...   steps: lint core app gui
# Runs every step, also after one has failed. Each leaves build/logs/STEP.log, with SUITE after its name if set.
set -uo pipefail
cd "$(dirname "$(realpath "$0")")/.." || exit 1
logs=build/logs
mkdir -p "$logs"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

lint() {
    local failed=0
    .venv/bin/ruff check . || failed=1
    .venv/bin/ruff format --check --quiet . || { echo "Not formatted: run 'make format'." && failed=1; }
    .venv/bin/mypy || failed=1
    .venv/bin/codespell || failed=1
    find BalloonWorkbench/native \( -name '*.cpp' -o -name '*.h' \) -print0 |
        xargs -0r .venv/bin/clang-format --dry-run --Werror || failed=1
    return "$failed"
}

core() {
    # an empty user folder: the user's own addons have no part in the tests
    mkdir -p "$scratch/core"
    # shellcheck disable=SC2086  # several arguments
    FREECAD_USER_HOME=$scratch/core .venv/bin/python -m pytest ${BALLOON_TESTS:-}
}

app() {
    timeout --kill-after=30 1200 tools/in-freecad.sh "$scratch/app" freecadcmd tests/freecad_pytest.py
}

gui() {
    tools/in-window.sh "$scratch/gui" tests/freecad_pytest.py
}

pytest_has_ended() {
    grep -qE '[0-9]+ passed' "$1" || { echo "The process ended before pytest did." && return 1; }
}

# FreeCAD reports an exception in its log and goes on; a test that looked elsewhere would not notice.
freecad_log_is_clean() {
    if grep -nE 'Traceback|During initialization the error|Exception while processing|blocked import' "$1"; then
        echo "FreeCAD reported the errors above (see $1)."
        return 1
    fi
}

result=0
summary=()
for step in "$@"; do
    echo "== $step"
    started=$SECONDS
    log=$logs/$step${SUITE:-}.log
    "$step" </dev/null 2>&1 | tee "$log"
    status=${PIPESTATUS[0]}
    [ "$step" = lint ] || [ "$status" -ne 0 ] || pytest_has_ended "$log" || status=1
    case $step in app | gui) freecad_log_is_clean "$log" || status=1 ;; esac
    counts=$(grep -aoE '[0-9]+ (passed|failed|skipped|errors?)\b.* in [0-9.]+s' "$log" | tail -n 1)
    if [ "$status" -eq 0 ]; then word=ok; else word="FAILED ($status)" result=1; fi
    summary+=("$(printf '%-5s %-12s %4d s  %s' "$step" "$word" $((SECONDS - started)) "$counts")")
done

echo "== summary (logs in $logs)"
printf '%s\n' "${summary[@]}"
exit $result
