#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that the sources in a release's tarball build, test, install, uninstall
# and pack themselves, also under umask 077.
# usage: dist.sh BUILD NAME
set -eu
unset CDPATH
tarball=$(cd "$1" && pwd)/$2.tar.gz
check=$(cd "$1" && pwd)/distcheck
source=$check/$2
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
umask 077

rm -rf "$check"
mkdir -p "$check"
tar -xzf "$tarball" -C "$check"
cd "$source"
make BUILD=build test
make -s BUILD=build DESTDIR="$check/root" PREFIX=/usr install
perl cmd/test/examples_test.t "$check/root/usr/bin" >"$check/examples" || {
	grep -v '^ok' "$check/examples"
	exit 1
}
test -z "$(find "$check/root/usr" ! -perm -444)"
make -s BUILD=build DESTDIR="$check/root" PREFIX=/usr uninstall
test -z "$(find "$check/root" -type f)"
make -s BUILD=build dist
cmp "$tarball" "build/$2.tar.gz"
rm -rf "$check"
