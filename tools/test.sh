#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# test.sh STEP...   steps: lint core app gui; engine: the part of core that other versions are tried with;
# users: plays users on screens of SCREENS with THEMES, and leaves their pictures in build/users
# QUICK: without the tests that are marked as slow; those that should be are told at the end.
# Runs every step, also after one has failed: lint alone, the others beside the last one. Each leaves
# build/logs/STEP.log, with SUITE after its name if set.
set -uo pipefail
cd "$(dirname "$(realpath "$0")")/.." || exit 1
logs=build/logs
mkdir -p "$logs"
scratch=$(mktemp -d)
# the linear algebra of one step takes no processor from the step beside it
export OPENBLAS_NUM_THREADS=1
[ -z "${QUICK:-}" ] || export PYTEST_ADDOPTS="-m 'not slow' --durations=10 --durations-min=4"
trap 'jobs -p | xargs -r kill 2>/dev/null; rm -rf "$scratch"' EXIT

lint() {
    local failed=0
    .venv/bin/ruff check . || failed=1
    .venv/bin/ruff format --check --quiet . || { echo "Not formatted: run 'make format'." && failed=1; }
    .venv/bin/mypy || failed=1
    .venv/bin/codespell || failed=1
    find BalloonWorkbench/native benchmarks tests/native \( -name '*.c' -o -name '*.cpp' -o -name '*.h' \) -print0 |
        xargs -0r .venv/bin/clang-format --dry-run --Werror || failed=1
    # at most 80 lines and 15 paths a function
    .venv/bin/lizard -l cpp -L 80 -C 15 -w BalloonWorkbench/native benchmarks tests/native || failed=1
    return "$failed"
}

core() {
    # an empty user folder: the user's own addons have no part in the tests
    mkdir -p "$scratch/core"
    # shellcheck disable=SC2086  # several arguments
    FREECAD_USER_HOME=$scratch/core .venv/bin/python -m pytest ${BALLOON_TESTS:-}
}

engine() {
    # shellcheck disable=SC2046  # several arguments
    BALLOON_TESTS=${BALLOON_TESTS:-$(grep -v '^#' tools/engine-tests.txt | paste -sd' ')} core
}

# The tests of a step: those of BALLOON_TESTS; or of its list, with a FreeCAD that has one; or all.
tests_of() {
    local list=tools/$1-tests${SUITE:-}.txt
    if [ -n "${BALLOON_TESTS:-}" ]; then
        echo "$BALLOON_TESTS"
    elif [ -e "$list" ]; then
        grep -v '^#' "$list" | paste -sd' '
    else
        echo "tests/$1"
    fi
}

app() {
    BALLOON_TESTS=$(tests_of app) timeout --kill-after=30 3600 \
        tools/in-freecad.sh "$scratch/app" freecadcmd tests/freecad_pytest.py
}

gui() {
    BALLOON_TESTS=$(tests_of gui) tools/in-window.sh "$scratch/gui" tests/freecad_pytest.py
}

users() {
    local screen theme failed=0
    for screen in ${SCREENS:-1366x768 1920x1080}; do
        for theme in ${THEMES:-light dark}; do
            echo "== $screen, $theme"
            mkdir -p "$scratch/users-$screen-$theme"
            .venv/bin/python tests/users/theme.py "$theme" >"$scratch/users-$screen-$theme/user.cfg"
            # 96 dots per inch: a pixel of the screen is one of Qt's
            BALLOON_TESTS=${BALLOON_TESTS:-tests/users} SCREEN=$screen THEME=$theme QT_FONT_DPI=96 \
                tools/in-window.sh "$scratch/users-$screen-$theme" tests/freecad_pytest.py || failed=1
        done
    done
    return $failed
}

pytest_has_ended() {
    grep -qaE '[0-9]+ (passed|failed|errors?)\b.* in [0-9.]+s' "$1"
}

# FreeCAD reports an exception in its log and goes on; a test that looked elsewhere would not notice.
freecad_log_is_clean() {
    if grep -nE 'Traceback|During initialization the error|Exception while processing|blocked import' "$1"; then
        echo "FreeCAD reported the errors above (see $1)."
        return 1
    fi
}

# The screen that is made for the window has died, as it can on a machine that is short of memory.
screen_was_lost() {
    ! pytest_has_ended "$1" && grep -qa '^The screen was lost' "$1"
}

# Run one step: its log, and its line of the summary.
check() {
    local step=$1 log=$logs/$1${SUITE:-}.log started=$SECONDS status counts word=ok early=
    "$step" </dev/null 2>&1 | tee "$log"
    status=${PIPESTATUS[0]}
    if screen_was_lost "$log"; then
        echo "Once more, with a new screen."
        "$step" </dev/null 2>&1 | tee "$log"
        status=${PIPESTATUS[0]}
    fi
    if [ "$step" != lint ] && ! pytest_has_ended "$log"; then
        early="  the process ended with $status before pytest did, after: $(grep -a . "$log" | tail -n 3 | cut -c -200 | paste -sd'|')"
        [ "$status" -ne 0 ] || status=1
    fi
    case $step in app | gui | users) freecad_log_is_clean "$log" || status=1 ;; esac
    counts=$(grep -aoE '[0-9]+ (passed|failed|skipped|errors?)\b.* in [0-9.]+s' "$log" | paste -sd';')
    [ "$status" -eq 0 ] || word="FAILED ($status)"
    printf '%-5s %-12s %4d s  %s\n' "$step" "$word" $((SECONDS - started)) "$counts" >"$scratch/$step.summary"
    [ -z "$early" ] || echo "$early" >>"$scratch/$step.summary"
    grep -aE '^(FAILED|ERROR) ' "$log" | cut -c -300 | sed 's/^/  /' >>"$scratch/$step.summary"
    return "$status"
}

result=0
declare -A beside=()
for step in "$@"; do
    if [ "$step" = lint ] || [ "$step" = "${!#}" ]; then
        echo "== $step"
        check "$step" || result=1
    else
        # a window waits for a third of its time
        echo "== $step, beside the last: see $logs/$step${SUITE:-}.log"
        check "$step" >/dev/null &
        beside[$step]=$!
    fi
done
for step in "$@"; do
    [ -n "${beside[$step]:-}" ] || continue
    wait "${beside[$step]}" && continue
    result=1
    echo "== $step"
    tail -n 60 "$logs/$step${SUITE:-}.log"
done

echo "== summary (logs in $logs)"
for step in "$@"; do cat "$scratch/$step.summary"; done
exit $result
