#!/bin/sh
# SPDX-License-Identifier: MIT
# Maps the vertices of the Stanford bunny through a scene, and draws them.
# usage: demo.sh BUILD
set -eu
unset CDPATH
export LC_ALL=C
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../../testdata"
PATH=$build:$PATH

echo '$ cat bunny.json'
cat bunny.json
echo '$ projcalc project bunny.json bunny.xyz >device.xyz'
projcalc project bunny.json bunny.xyz >"$build/device.xyz"
echo '$ sed -n 2,5p device.xyz'
sed -n 2,5p "$build/device.xyz"
echo "$(grep -vc '^#' "$build/device.xyz") points," \
    "and the $(grep -vc '^#' bunny.faces) triangles between them:"
awk -f ../cmd/demo/demo.awk bunny.xyz "$build/device.xyz" bunny.faces
