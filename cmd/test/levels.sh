#!/bin/sh
# The same bits from each compiler that is here, at each level of optimization, with
# optimization at link time, and for this very processor.
# usage: levels.sh BUILD
set -eu
cd "$(dirname "$0")/../.."
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
mkdir -p "$1"
echo 'int main(void) { return 0; }' >"$1/none.c"

# Whether a program for this processor can be made so: clang wants a linker for
# -flto, and not every processor is an x86-64-v3. The shell is to split the flags.
# shellcheck disable=SC2086
makes() {
	"$2" $3 -o "$1/none" "$1/none.c" 2>/dev/null && "$1/none"
}

check() {
	build=$1/$2$(echo "$3" | tr -d ' ')
	make -s -j"$(nproc)" "BUILD=$build" "CC=$2" \
	    "CXX=$(echo "$2" | sed 's/gcc/g++/; s/clang/clang++/')" \
	    CFLAGS="$3 -g" LDFLAGS="$3" "$build/projcalc" \
	    "$build/core/test/compiler_test"
	{
		"$build/core/test/compiler_test" &&
		    perl cmd/test/transcripts_test.t "$build" &&
		    perl cmd/test/bits_test.t "$build"
	} >"$1/said" 2>&1 || {
		grep -v '^ok' "$1/said"
		exit 1
	}
}

# gcc itself is a link to one of the others.
seen=
for cc in gcc gcc-12 gcc-13 gcc-14 gcc-15 clang; do
	file=$(readlink -f "$(command -v "$cc")") || continue
	case $seen in *" $file "*) continue ;; esac
	seen="$seen $file "
	for flags in -O0 -O1 -O2 -O3 '-O2 -flto' '-O3 -flto' \
	    '-O3 -march=native' '-O3 -march=x86-64-v3'; do
		echo "$cc $flags"
		if makes "$1" "$cc" "$flags"; then
			check "$1" "$cc" "$flags"
		else
			echo "	can't be made here"
		fi
	done
done
