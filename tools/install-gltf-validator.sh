#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs Khronos' glTF validator into build/gltf-tools, as tools/gltf/package-lock.json has it: only with its sum.
# Where that does not work, it says so and the tests leave it out.
set -euo pipefail
cd "$(dirname "$(realpath "$0")")/.."

target=build/gltf-tools
cmp -s tools/gltf/package-lock.json "$target/made-from" && exit 0
# other packages of Node.js bring npm with them, and do not go with Debian's
command -v npm >/dev/null || tools/install-debian-packages.sh debian-packages-gltf.txt || true
rm -rf "$target"
mkdir -p "$target"
cp tools/gltf/package.json tools/gltf/package-lock.json tools/gltf/.npmrc "$target"
if npm ci --prefix "$target" --silent; then
    cp tools/gltf/package-lock.json "$target/made-from"
else
    echo "NOT TRIED: GLB files with the glTF validator, which npm could not install." >&2
fi
