#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# in-root.sh ROOT COMMAND...
# Runs a command in a root of freecad-root.sh, with this repository at the same place, the root's own .venv in
# it and a /tmp of its own. The mounts live in a name space of the command and are gone with it.
set -euo pipefail

export ROOT=$1 REPOSITORY
REPOSITORY=$(dirname "$(dirname "$(realpath "$0")")")
shift
mkdir -p "$REPOSITORY/.venv"
exec unshare --mount --propagation private bash -euc '
    mount -t proc proc "$ROOT/proc"
    mount --rbind /dev "$ROOT/dev"
    mount -t tmpfs tmpfs "$ROOT/tmp"
    mkdir -p "$ROOT$REPOSITORY" "$ROOT/tmp/.X11-unix"
    chmod 1777 "$ROOT/tmp" "$ROOT/tmp/.X11-unix"
    mount --bind "$REPOSITORY" "$ROOT$REPOSITORY"
    mount --bind "$ROOT/opt/venv" "$ROOT$REPOSITORY/.venv"
    exec chroot "$ROOT" /usr/bin/env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root LANG=C.UTF-8 TERM=dumb \
        ${BALLOON_TESTS:+"BALLOON_TESTS=$BALLOON_TESTS"} ${BALLOON_FAULTS:+"BALLOON_FAULTS=$BALLOON_FAULTS"} \
        ${SCREEN:+"SCREEN=$SCREEN"} ${BALLOON_LANGUAGES:+"BALLOON_LANGUAGES=$BALLOON_LANGUAGES"} \
        ${SCREENS:+"SCREENS=$SCREENS"} ${THEMES:+"THEMES=$THEMES"} "SUITE=${SUITE:-}" \
        ${QUICK:+"QUICK=$QUICK"} \
        /bin/bash -c "cd \"\$1\" && shift && exec \"\$@\"" sh "$REPOSITORY" "$@"
' sh "$@"
