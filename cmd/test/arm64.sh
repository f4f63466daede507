#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds for arm64 and runs that under qemu: the tests of the vector loops, the
# transcripts and the digests of testdata/bits.sha256. Wants what `make deps-all`
# installs.
# usage: arm64.sh [BUILD]
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/arm64}
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
tests="$build/core/test/points_test $build/core/test/ray_test"

# The shell is to split the list.
# shellcheck disable=SC2086
make -s "BUILD=$build" CC=aarch64-linux-gnu-gcc CXX=aarch64-linux-gnu-g++ \
    "$build/projcalc" $tests
for test in $tests; do
	qemu-aarch64-static "$test"
done
mkdir -p "$build/emulated"
program=$(cd "$build" && pwd)/projcalc
cat >"$build/emulated/projcalc" <<END
#!/bin/sh
exec qemu-aarch64-static '$program' "\$@"
END
chmod +x "$build/emulated/projcalc"
exec prove cmd/test/transcripts_test.t cmd/test/bits_test.t :: "$build/emulated"
