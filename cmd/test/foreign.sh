#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that other processors, which are emulated, and another C library give the same
# bits: runs the transcripts and the digests of testdata/bits.sha256 and, for arm64, the
# tests of its vector loops. Programs are linked statically, with cJSON. Needs the
# packages of `make deps foreign`; names and skips what is missing.
# usage: foreign.sh BUILD [NAME...]
set -eu
unset CDPATH
cd "$(dirname "$0")/../.."
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
build=$1
shift
mkdir -p "$build/include"
build=$(cd "$build" && pwd)
cjson=$build/cjson
[ -f "$cjson/cJSON.c" ] || {
	echo "foreign: no source of cJSON in $cjson; make deps foreign" >&2
	exit 1
}
# Headers that musl-gcc does not find by itself.
ln -sfn "$cjson" "$build/include/cjson"
ln -sfn /usr/include/fast_float "$build/include/fast_float"

has() {
	for tool; do
		command -v "$tool" >/dev/null || {
			echo "$name: no $tool here"
			return 1
		}
	done
}

# Runs make for $cc and $cxx with $flags and the targets given.
made() {
	make -s -j"$(nproc 2>/dev/null || echo 2)" "BUILD=$build/$name" "CC=$cc" "CXX=$cxx" \
	    CFLAGS="-O2 -g $flags" CPPFLAGS="-I$build/include" "$@"
}

# Builds the program for $name, and runs the tests with the program under $emulator.
check() {
	dir=$build/$name
	mkdir -p "$dir/emulated"
	"$cc" -O2 -c -o "$dir/cJSON.o" "$cjson/cJSON.c"
	made LDFLAGS=-static LIBS="$dir/cJSON.o -lm" "$dir/projcalc"
	printf '#!/bin/sh\nexec %s "%s/projcalc" "$@"\n' "$emulator" "$dir" \
	    >"$dir/emulated/projcalc"
	chmod +x "$dir/emulated/projcalc"
	echo "$name"
	prove -Q cmd/test/transcripts_test.t cmd/test/bits_test.t :: \
	    "$dir/emulated"
}

# Runs the tests of the vector loops of arm64.
check_loops() {
	tests="$dir/core/test/points_test $dir/core/test/ray_test"
	[ -f /usr/lib/aarch64-linux-gnu/libcmocka.so ] || {
		echo "$name: no libcmocka for it here"
		return
	}
	# The shell must split the list.
	# shellcheck disable=SC2086
	made $tests
	for test in $tests; do
		"$emulator" "$test" >"$dir/said" 2>&1 || {
			cat "$dir/said"
			exit 1
		}
	done
}

tested=
[ $# -gt 0 ] || set -- arm64 s390x riscv64 i386 musl
for name; do
	flags='' emulator=''
	case $name in
	arm64) triplet=aarch64-linux-gnu emulator=qemu-aarch64-static ;;
	i386)
		# SSE2, as the x87 does not round to doubles
		triplet=i686-linux-gnu emulator=qemu-i386-static
		flags='-msse2 -mfpmath=sse'
		;;
	*) triplet=$name-linux-gnu emulator=qemu-$name-static ;;
	esac
	cc=$triplet-gcc cxx=$triplet-g++
	# g++ has the headers of glibc. The C++ files call only functions that musl has
	# too, unless _FORTIFY_SOURCE renames them.
	[ "$name" != musl ] ||
	    cc=musl-gcc cxx=g++ emulator='' flags=-U_FORTIFY_SOURCE
	# shellcheck disable=SC2086
	has "$cc" "$cxx" $emulator || continue
	check
	[ "$name" != arm64 ] || check_loops
	tested=yes
done
[ -n "$tested" ] || {
	echo "foreign: nothing was tested; 'make deps foreign' installs what is" \
	    'missing' >&2
	exit 1
}
