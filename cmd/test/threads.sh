#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs streams through four threads under the thread sanitizer: points in each
# format, bad lines with and without --keep-going, several sources.
# usage: threads.sh BUILD
set -eu
unset CDPATH
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../../testdata"
PATH=$build:$PATH
export TSAN_OPTIONS=exitcode=66 LC_ALL=C
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Compares the output and messages of four threads with those of one. - is a
# pipe.
check() {
	for jobs in 1 4; do
		status=0
		cat "$tmp/pipe" /dev/null | projcalc "$@" -j $jobs >"$tmp/out$jobs" \
		    2>"$tmp/err$jobs" || status=$?
		echo $status >>"$tmp/err$jobs"
	done
	if ! cmp "$tmp/out1" "$tmp/out4" || ! cmp "$tmp/err1" "$tmp/err4"
	then
		echo "threads.sh: projcalc $*" >&2
		head -n 40 "$tmp/err4" >&2
		exit 1
	fi
}

awk 'BEGIN { for (i = 0; i < 40000; i++) print i % 997, i % 31 - 15, i }' \
    >"$tmp/text"
awk '{ print NR % 9000 == 8999 ? "bad" : $0 }' "$tmp/text" >"$tmp/bad"
{ echo x,y,z; tr ' ' , <"$tmp/text"; } >"$tmp/csv"
sed 's/.*/[&,"a"]/; s/ /,/g' "$tmp/text" >"$tmp/json"
projcalc project -o f64 --to world full.json "$tmp/text" >"$tmp/f64"

cp "$tmp/text" "$tmp/pipe"
{
	sed '/"viewport"/s/$/,/; $d' scene.json
	sed 's/ /, /g; s/.*/ [&]/; 1s/^/"points": [/; 1!s/^/,/' "$tmp/text"
	echo ']}'
} >"$tmp/document"

check project scene.json "$tmp/text" "$tmp/text" '[1,2,3]' "$tmp/text"
check project --flags -p double scene.json "$tmp/text"
check project scene.json "$tmp/text" "$tmp/bad"
check project --keep-going scene.json "$tmp/bad" "$tmp/text"
check project -i csv --columns z,y,x -o json scene.json "$tmp/csv" "$tmp/csv"
check project -i json --visible scene.json "$tmp/json"
check project -i f64 scene.json "$tmp/f64" "$tmp/f64"
check project -i f64 --ray scene.json "$tmp/f64"
check pick --at 320,240 --radius 100 scene.json "$tmp/text" "$tmp/bad"
check fit full.json "$tmp/text"
check project scene.json -
check project --keep-going scene.json "$tmp/bad" - "$tmp/text"
check project "$tmp/document"
check pick --at 320,240 --radius 100 "$tmp/document"
cp "$tmp/f64" "$tmp/pipe"
check project -i f64 scene.json -
