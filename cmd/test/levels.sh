#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that each installed compiler gives the same bits at each level of optimization,
# with optimization at link time, for this very processor, and where the C++ library or
# strtod takes the place of fast_float and dragonbox.
# usage: levels.sh BUILD [CC...]
set -eu
cd "$(dirname "$0")/../.."
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
top=$1
shift
mkdir -p "$top"
echo 'int main(void) { return 0; }' >"$top/none.c"
[ $# -gt 0 ] || set -- gcc gcc-12 gcc-13 gcc-14 gcc-15 clang

# Returns whether the compiler can make a program for this processor: clang needs a
# linker for -flto, and not every processor is an x86-64-v3. The shell splits the flags.
# shellcheck disable=SC2086
makes() {
	"$1" $2 -o "$top/none" "$top/none.c" 2>/dev/null && "$top/none"
}

# usage: check CC FLAGS PLAIN_NUMBERS
check() {
	# make would take a word with = for a variable
	build=$top/$1$(echo "$2" | tr -d ' =')$3
	make -s -j"$(nproc 2>/dev/null || echo 2)" "BUILD=$build" "CC=$1" \
	    "CXX=$(echo "$1" | sed 's/gcc/g++/; s/clang/clang++/')" \
	    CFLAGS="$2 -g" LDFLAGS="$2" "PLAIN_NUMBERS=$3" "$build/projcalc" \
	    "$build/core/test/compiler_test" "$build/cmd/test/number_test" \
	    "$build/cmd/test/texts_test"
	{
		"$build/core/test/compiler_test" &&
		    "$build/cmd/test/number_test" && "$build/cmd/test/texts_test" &&
		    perl cmd/test/transcripts_test.t "$build" &&
		    perl cmd/test/bits_test.t "$build"
	} >"$top/said" 2>&1 || {
		grep -v '^ok' "$top/said"
		exit 1
	}
}

# gcc is a link to a gcc of some version, which must not be tested twice.
seen=
for cc; do
	file=$(readlink -f "$(command -v "$cc")") || continue
	case $seen in *" $file "*) continue ;; esac
	seen="$seen $file "
	for flags in -O0 -O1 -O2 -O3 '-O2 -flto' '-O3 -flto' '-O2 -funsigned-char' \
	    '-O3 -march=native' '-O3 -march=x86-64-v3'; do
		echo "$cc $flags"
		if makes "$cc" "$flags"; then
			check "$cc" "$flags" ''
		else
			echo "	can't be made here"
		fi
	done
	for plain in 1 2; do
		echo "$cc -O2 PLAIN_NUMBERS=$plain"
		check "$cc" -O2 $plain
	done
done
