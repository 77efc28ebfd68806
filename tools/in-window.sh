#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# in-window.sh USER_FOLDER SCRIPT
# Runs a script in FreeCAD's window, without a screen and with FreeCAD's user folder at USER_FOLDER.
# SCREEN is the size of the screen that is made for it, such as 1366x768; 1920x1080 without it.
set -euo pipefail

# a number of the screen that is our own: roots see each other's screens, but not which numbers are taken
exec env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 XDG_RUNTIME_DIR= \
    timeout --kill-after=30 4700 \
    xvfb-run --auto-servernum --server-num=$((100 + $$ % 30000)) --server-args="-screen 0 ${SCREEN:-1920x1080}x24 -noreset" \
    bash -c '
        "$0" "$1" freecad "$2" && exit
        status=$?
        kill -0 $(cat "/tmp/.X${DISPLAY#:}-lock") 2>/dev/null || printf "\nThe screen was lost.\n"
        exit "$status"
    ' "$(dirname "$(realpath "$0")")/in-freecad.sh" "$1" "$2"
