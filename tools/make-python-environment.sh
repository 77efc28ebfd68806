#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Makes .venv: Debian's Python with its packages, those of requirements.txt and tools/requirements-checks.txt, and
# FreeCAD importable. Does nothing when .venv was made from the same lists, Python and FreeCAD.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

python=/usr/bin/python3 # the one that FreeCAD and the distribution's packages belong to

# FreeCAD's library, and the folders of the modules that its Part, Mesh and Sketcher import from.
# They come after .venv's own packages and share no name with a module of Python, Debian or ours.
freecad_paths() {
    local library module
    for library in /usr/lib/freecad-python3/lib /usr/lib/freecad/lib; do
        [ -e "$library/FreeCAD.so" ] || continue
        echo "$library"
        for module in Part Mesh Sketcher; do
            [ ! -d "/usr/share/freecad/Mod/$module" ] || echo "/usr/share/freecad/Mod/$module"
        done
        return
    done
}

paths=$(freecad_paths)
lists=(requirements.txt tools/requirements-checks.txt)
wanted=$({ "$python" --version && cat "${lists[@]}" "$0" && echo "$PWD $paths"; } | sha256sum)
[ "$(cat .venv/made-from 2>/dev/null)" != "$wanted" ] || exit 0

echo "Making the Python environment in .venv"
# pip's script names its interpreter by its full path: it fails when the folder was moved
.venv/bin/pip --version >/dev/null 2>&1 || "$python" -m venv --clear --system-site-packages .venv
tools/pip-install.sh .venv/bin/python "${lists[@]/#/--requirement=}"
site=$(.venv/bin/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
echo "$paths" >"$site/freecad.pth"
[ -n "$paths" ] || echo "FreeCAD was not found: documents cannot be saved from the command line" >&2
echo "$wanted" >.venv/made-from
