#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that other processors, which are emulated, another C library, and WebAssembly
# under node give the same bits: runs the transcripts and the digests of
# testdata/bits.sha256 and, for arm64, the tests of its vector loops; and tries the page
# in a browser. Programs are linked statically, with cJSON. Needs the packages of `make
# deps foreign`; names and skips what is missing.
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
	    CFLAGS="-O2 -g $flags" CPPFLAGS="-I$build/include" PKG_CONFIG=false "$@"
}

# Makes "$dir/emulated/projcalc" run a command.
emulate() {
	mkdir -p "$dir/emulated"
	printf '#!/bin/sh\nexec %s "$@"\n' "$1" >"$dir/emulated/projcalc"
	chmod +x "$dir/emulated/projcalc"
	echo "$name"
}

# Builds the program for $name, and runs the tests with the program under $emulator.
check() {
	dir=$build/$name
	mkdir -p "$dir"
	"$cc" -O2 -c -o "$dir/cJSON.o" "$cjson/cJSON.c"
	made LDFLAGS=-static LIBS="$dir/cJSON.o -lm" "$dir/projcalc"
	emulate "$emulator \"$dir/projcalc\""
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

# The transcripts that node cannot do.
not_by_node='
json-strings: its arguments are UTF-8, so that other bytes in them are lost
escaped-name: the same
stdin-closed: it opens /dev/null in place of a stream that is closed
scenes-many-files: it needs more than 12 files itself'

# Runs the tests with the program that `make npm` packs, and npx with the package.
check_node() {
	dir=$build/node
	rm -rf "$dir"
	mkdir -p "$dir"
	make -s npm "BUILD=${build%/*}" >"$dir/made"
	package=$(tail -n 1 "$dir/made")
	cp "${build%/*}/$package" "$dir"
	tar -xzf "$dir/$package" -C "$dir"
	emulate "node \"$dir/package/projcalc.js\""
	perl cmd/test/transcripts_test.t "$dir/emulated" >"$dir/said" 2>"$dir/why" || true
	tail -n 1 "$dir/said" | grep -q '^1\.\.'
	echo "$not_by_node" | sed -n 's/:.*/$/; s/^./: &/p' >"$dir/names"
	sed 's/^\(.*:[0-9]*: [^:]*\):.*/\1/' "$dir/said" | grep '^not ok' |
	    grep -v -f "$dir/names" >"$dir/failed" && {
		cat "$dir/failed" "$dir/why"
		exit 1
	}
	echo "transcripts: $(grep -c '^ok' "$dir/said"), and $(wc -l <"$dir/names")" \
	    "that node cannot do:$not_by_node"
	prove -Q cmd/test/bits_test.t :: "$dir/emulated"
	said=$(cd "$dir" && echo 22 32 | npm_config_cache=$dir/cache npx --offline --yes \
	    "./$package" w2n '{"center": [20, 30], "width": 10, "height": 10}' -)
	[ "$said" = '0.4 0.4' ] || {
		echo "npx: said $said"
		exit 1
	}
}

check_page() {
	make -s wasm "BUILD=${build%/*}"
	echo "$name: $(wc -c <"${build%/*}/wasm/projcalc.html") bytes"
	[ "$(wc -c <"${build%/*}/wasm/projcalc.html")" -lt 450000 ]
	node cmd/test/page.js "${build%/*}/wasm/projcalc.html" "$build/page"
}

tested=
[ $# -gt 0 ] || set -- arm64 s390x riscv64 i386 musl node page
for name; do
	flags='' emulator=''
	case $name in
	node | page)
		[ "$name" = page ] || has npm || continue
		has emcc node || continue
		[ "$name" = node ] || has chromium || continue
		"check_$name"
		tested=yes
		continue
		;;
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
