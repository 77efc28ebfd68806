#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# freecad-root.sh SUITE   ->   prints the folder of a Debian SUITE with its FreeCAD and all that the tests need
# Made once, beside its final name; the name holds a hash of what goes in. Needs root.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

suite=$1
# what the workbench needs anywhere, and what .venv holds on Debian 12
packages=$(sed 's/#.*//; /^[[:space:]]*$/d' tools/debian-packages.txt | paste -sd,)
packages+=,python3-pytest,python3-fonttools,python3-pyparsing,python3-typing-extensions
base=${FREECAD_ROOTS:-/var/cache/freecad-roots}
root=$base/$suite-$({ echo "$suite $packages" && cat requirements.txt "$0"; } | sha256sum | cut -c1-10)

mkdir -p "$base"
exec {lock}>"$root.lock"
flock "$lock" # of two that need the root, one makes it
if [ ! -e "$root/.ready" ]; then
    tools/install-debian-packages.sh debian-packages-matrix.txt >&2
    mirror=$(awk '/^URIs:/ { print $2; exit }' /etc/apt/sources.list.d/*.sources)
    rm -rf --one-file-system "$root.part"
    # a mirror's testing suite may be older than its own date of expiry
    mmdebstrap --quiet --variant=apt --mode=root --components=main \
        --keyring=/usr/share/keyrings/debian-archive-keyring.gpg \
        --aptopt='Acquire::Check-Valid-Until "false"' --aptopt='Acquire::Retries "5"' \
        --dpkgopt=force-unsafe-io --dpkgopt='path-exclude=/usr/share/man/*' \
        --dpkgopt='path-exclude=/usr/share/locale/*' --dpkgopt='path-exclude=/usr/share/doc/*' \
        --include="$packages" "$suite" "$root.part" "$mirror" >&2
    chroot "$root.part" /usr/bin/python3 -m venv --without-pip --system-site-packages /opt/venv
    site=$(echo "$root.part"/opt/venv/lib/python3.*/site-packages)
    # Debian's own pip, which is not in the root, chooses the wheels for the root's Python
    tools/pip-install.sh .venv/bin/python --python-version "$(basename "$(dirname "$site")" | tr -d a-z)" \
        --target "$site" --requirement requirements.txt >&2
    {
        echo /usr/lib/freecad-python3/lib
        printf '/usr/share/freecad/Mod/%s\n' Part Mesh Sketcher
    } >"$site/freecad.pth"
    touch "$root.part/.ready"
    mv "$root.part" "$root"
fi
echo "$root"
