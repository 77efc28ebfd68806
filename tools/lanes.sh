#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# lanes.sh <LIST   runs the commands of a list in its order, one more at a time than there are processors: those with a
# window wait for a third of their time. Lines of NAME SECONDS COMMAND...
# A command that takes longer than its seconds is ended. Each leaves build/logs/NAME.log. All are run, also after
# one has failed; what failed is told at the end, and fails this.
set -uo pipefail
cd "$(dirname "$(realpath "$0")")/.." || exit 1
logs=build/logs
mkdir -p "$logs"
scratch=$(mktemp -d)
trap 'jobs -p | xargs -r kill 2>/dev/null; rm -rf "$scratch"' EXIT

run() {
    local name=$1 limit=$2 started=$SECONDS status=0 word=ok
    shift 2
    # a session of its own: what FreeCAD or a screen leave behind after the limit is found in it
    setsid --wait bash -c 'echo $$ >"$0" && exec timeout --kill-after=30 "$@"' "$scratch/$name" "$limit" "$@" \
        >"$logs/$name.log" 2>&1 </dev/null || status=$?
    case $status in
        0) ;;
        124 | 137)
            word="FAILED: ended after $limit s"
            pkill -KILL --session "$(cat "$scratch/$name")"
            ;;
        *) word="FAILED ($status)" ;;
    esac
    [ "$status" -eq 0 ] || echo "$name" >>"$scratch/failed"
    printf '%4d s  %-14s %s, took %d s\n' "$SECONDS" "$name" "$word" $((SECONDS - started))
}

running=0
most=$(($(nproc) + 1))
while read -r name limit command; do
    if [ "$running" -ge "$most" ]; then
        wait -n
        running=$((running - 1))
    fi
    # shellcheck disable=SC2086  # a command and its arguments
    run "$name" "$limit" $command &
    running=$((running + 1))
done
wait

[ -e "$scratch/failed" ] || exit 0
while read -r name; do
    echo "== $name failed; the end of $logs/$name.log:"
    tail -n 80 "$logs/$name.log"
done <"$scratch/failed"
echo "FAILED: $(paste -sd' ' "$scratch/failed")"
exit 1
