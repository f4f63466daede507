#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs one example of each command under valgrind, without AVX-512, which
# valgrind lacks.
# usage: valgrind.sh BUILD
set -eu
unset CDPATH
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../../testdata"
PATH=$build:$PATH
PROJCALC_CPU=baseline
grep -q avx2 /proc/cpuinfo && PROJCALC_CPU=avx2
export PROJCALC_CPU

check() {
	valgrind -q --error-exitcode=99 "$build/projcalc" "$@" >/dev/null || {
		echo "valgrind.sh: projcalc $*" >&2
		exit 1
	}
}

flat='{"window":{"center":[1,2],"width":3,"height":4},
"device":{"width":640,"height":480}}'
lens='"near":1,"far":10,"width":2,"height":1}'

check lookat -o json points.json
check persp "{$lens"
check ortho "{$lens" '[[1,2,3],[4,5,6]]'
check oblique "{\"kind\":\"cabinet\",$lens"
check volume '{"half_width":1,"half_height":1,"z_near":1,"z_far":9}'
for command in w2n n2d w2d d2w; do
	check "$command" "$flat" '[[1,2],[3,4]]'
done
check project -j 2 full.json teapot.xyz
check project --flags --digits 5 -o csv scene.json teapot.xyz
check project -p single -o f64 scene.json teapot.xyz
check project -o json scene.json teapot.xyz
check project --ray scene.json '[[1,2],[3,4]]'
check trace scene.json teapot.xyz
check pick --at 320,240 --radius 99 scene.json teapot.xyz
check pick --scenes --at 320,240 --radius 99 "$(cat scene.json scene.json)" teapot.xyz
check fit scene.json teapot.xyz
check inspect scene.json
check draw demo.json teapot.obj
check draw --text --lines --names demo.json teapot.obj inputs/three-points.txt
check help --json
