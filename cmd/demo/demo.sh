#!/bin/sh
# SPDX-License-Identifier: MIT
# Maps the vertices of the Utah teapot through a scene, and draws them.
# usage: demo.sh BUILD
set -eu
unset CDPATH
export LC_ALL=C
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../../testdata"
PATH=$build:$PATH

echo '$ cat demo.json'
cat demo.json
echo '$ projcalc project demo.json teapot.xyz >device.xyz'
projcalc project demo.json teapot.xyz >"$build/device.xyz"
echo '$ sed -n 2,5p device.xyz'
sed -n 2,5p "$build/device.xyz"
echo "$(grep -vc '^#' "$build/device.xyz") points," \
    "and the $(grep -vc '^#' teapot.faces) triangles between them:"
awk -f ../cmd/demo/demo.awk teapot.xyz "$build/device.xyz" teapot.faces
