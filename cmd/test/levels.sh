#!/bin/sh
# SPDX-License-Identifier: MIT
# The same bits from both compilers at each level of optimization.
# usage: levels.sh BUILD
set -eu
cd "$(dirname "$0")/../.."
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES

for level in 1 2 3; do
	for compilers in 'gcc g++' 'clang clang++'; do
		cc=${compilers% *}
		build=$1/$cc-$level
		echo "$cc -O$level"
		make -s -j"$(nproc)" "BUILD=$build" "CC=$cc" \
		    "CXX=${compilers#* }" CFLAGS="-O$level -g"
		perl cmd/test/bits_test.t "$build" >"$1/said" ||
		    { grep -v '^ok' "$1/said"; exit 1; }
	done
done
