#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# in-freecad.sh USER_FOLDER COMMAND...
# Runs a command with FreeCAD's user folder at USER_FOLDER, where this workbench is installed by a link and
# the packages of .venv stand where FreeCAD's Addon Manager would put them. Nothing of the user's own is touched.
set -euo pipefail

root=$(dirname "$(dirname "$(realpath "$0")")")
mkdir -p "$1/Mod" "$1/home" "$1/run"
chmod 700 "$1/run"
user=$(realpath "$1")
shift

[ -e "$user/user.cfg" ] || cp "$root/tests/user.cfg" "$user/user.cfg"
ln -sfn "$root" "$user/Mod/BalloonWorkbench"
site=$("$root/.venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
ln -sfn "$site" "$user/AdditionalPythonPackages"

export FREECAD_USER_HOME=$user HOME=$user/home
export QTWEBENGINE_DISABLE_SANDBOX=1 # FreeCAD's start page would end the program when root starts it
[ -n "${XDG_RUNTIME_DIR:-}" ] || export XDG_RUNTIME_DIR=$user/run
# one thread of linear algebra, so that the last bits do not depend on the machine's processors
export OPENBLAS_NUM_THREADS=1
exec "$@"
