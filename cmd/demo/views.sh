#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws four views of the Utah teapot in one image, as an SVG. The camera of each
# view is moved back until all vertices and a margin fit. Triangles are drawn from the
# farthest to the nearest, so that nearer triangles hide those behind.
# usage: views.sh BUILD OUTPUT.svg
set -eu
unset CDPATH
export LC_ALL=C
build=$(cd "$1" && pwd)
svg=$2
case $svg in /*) ;; *) svg=$PWD/$svg ;; esac
cd "$(dirname "$0")/../../testdata"
PATH=$build:$PATH

# Prints the triangles of scene $1 that face the eye: their corners go clockwise, as y
# points down. The units are tenths of a pixel; a device unit has $2 of them.
triangles() {
	sed '1s/$/ "margin": 0.08,/' "$1" | projcalc fit - teapot.xyz |
	    projcalc project - teapot.xyz |
	    awk '
		/^#/ {
			next
		}
		NR == FNR {
			x[n + 0] = int(k * $1 + 0.5)
			y[n + 0] = int(k * $2 + 0.5)
			z[n++] = $3
			next
		}
		{
			x1 = x[$2] - x[$1]
			y1 = y[$2] - y[$1]
			x2 = x[$3] - x[$2]
			y2 = y[$3] - y[$2]
			if (x1 * y2 > x2 * y1)
				printf "%.9f M%d %dl%d %d %d %dz\n",
				    z[$1] + z[$2] + z[$3],
				    x[$1], y[$1], x1, y1, x2, y2
		}' k="$2" - teapot.faces |
	    sort -rn | sed 's/[^ ]* \(.*\)/<path d="\1"\/>/'
}

{
	echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 480">'
	echo '<rect width="640" height="480" fill="white" stroke="black"/>'
	echo '<g transform="scale(.1)" fill="white" stroke="#1f4e79"' \
	    'stroke-width="3" stroke-linejoin="round">'
	echo '<g transform="translate(0 240)">'
	triangles demo.json 20
	echo '</g>'
	for view in top front side; do
		triangles views/$view.json 10
	done
	echo '</g>'
	echo '<path d="M320 0v480M0 240h640" stroke="black"/>'
	echo '<g font-family="sans-serif" font-size="12">'
	echo '<text x="8" y="230">perspective</text>'
	echo '<text x="328" y="230">top</text>'
	echo '<text x="8" y="470">front</text>'
	echo '<text x="328" y="470">side</text>'
	echo '</g></svg>'
} >"$svg"
