#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a table in markdown: how many cores one process can keep busy. Its threads take
# turns only in writing, and in reading a pipe. The number of cores is the CPU time of
# all threads, divided by that of the writes or of the reads, whichever is longer, in
# the fastest of seven runs.
# usage: feed.sh BUILD SCENE TEXT F64
set -eu
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
scene=$2 text=$3 f64=$4
out=$build/bench/feed
PATH=$build:$PATH
mkdir -p "$out"
cc -O1 -shared -fPIC -o "$out/shim.so" "$here/feed/shim.c"

# usage: row FROM TO COMMAND, in which p is the program
row() {
	rm -f "$out/times"
	for _ in 1 2 3 4 5 6 7; do
		eval "$3"
	done
	sort -g "$out/times" | awk -F '\t' -v from="$1" -v to="$2" 'NR == 1 {
		serial = $2 > $3 ? $2 : $3
		printf "| %s | %s | %.3f | %.3f | %.3f | %.0f |\n", from, to,
		    $1, $2, $3, $1 / serial
	}'
}

p() {
	FEED=$out/times LD_PRELOAD=$out/shim.so projcalc project "$@"
}

cat <<'EOF'
| from | to | CPU seconds | to read in turn | to write | cores fed |
|---|---|--:|--:|--:|--:|
EOF
row 'file of text' pipe "p '$scene' '$text' | cat >/dev/null"
row 'file of text' file "p '$scene' '$text' >'$out/image'"
row 'pipe of text' pipe "cat '$text' | p '$scene' - | cat >/dev/null"
row 'file of f64' pipe "p -i f64 '$scene' '$f64' | cat >/dev/null"
row 'pipe of f64' pipe "cat '$f64' | p -i f64 '$scene' - | cat >/dev/null"
rm -f "$out/image"
