#!/bin/sh
# Four views of the Stanford bunny in one render target, as an SVG: the wire
# frame between the vertices that --flags finds in the view volume.
# usage: views.sh BUILD OUTPUT.svg
set -eu
export LC_ALL=C
build=$(cd "$1" && pwd)
svg=$2
here=$(cd "$(dirname "$0")/../../testdata" && pwd)
PATH=$build:$PATH
wire=$build/wire
mkdir -p "$wire"

for view in "$here"/views/*.json; do
	projcalc project --flags -d 1 "$view" "$here/bunny.xyz" |
	awk '/^#/ { next }
	    NR == FNR { at[n] = $1 " " $2; in_[n++] = $4 == "in"; next }
	    function edge(a, b) {
		if (in_[a] && in_[b] && !drawn[a, b]++ && !drawn[b, a]++)
			print at[a] "\n" at[b] "\n"
	    }
	    { edge($1, $2); edge($2, $3); edge($3, $1) }' \
	    - "$here/bunny.faces" >"$wire/$(basename "$view" .json)"
done

gnuplot <<END
set terminal svg size 640,480 background "white" font "sans,12"
set output "$svg"
unset key; unset border; unset tics
set margins 0, 0, 0, 0
set xrange [0:640]; set yrange [480:0]
set arrow from 320,0 to 320,480 nohead lc "black"
set arrow from 0,240 to 640,240 nohead lc "black"
set object rectangle from 0,0 to 640,480 fillstyle empty border lc "black"
set label "perspective" at 8,230
set label "top" at 328,230
set label "front" at 8,470
set label "side" at 328,470
plot for [f in system("ls $wire/*")] f with lines lw 0.3 lc "#1f4e79"
END
