#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# install-debian-packages.sh [LIST]
# Installs the packages of LIST (debian-packages.txt) that are missing; asks apt only when one is.
set -euo pipefail

list=$(dirname "$(realpath "$0")")/${1:-debian-packages.txt}
mapfile -t packages < <(sed 's/#.*//; /^[[:space:]]*$/d' "$list")

if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system: install what matches these packages, then run make again:" >&2
    echo "${packages[*]}" >&2
    exit 1
fi

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "These packages are missing; install them as root, then run make again:" >&2
        echo "apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y
    -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0)
echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
"${apt[@]}" update
"${apt[@]}" install --no-install-recommends "${missing[@]}"
