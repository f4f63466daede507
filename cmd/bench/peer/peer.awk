# SPDX-License-Identifier: MIT
# Multiplies points by a 4x4 matrix for row vectors, and divides by w.
# usage: mawk -f peer.awk MATRIX POINTS
NR == 1 { a1 = $1; a2 = $2; a3 = $3; a4 = $4; next }
NR == 2 { b1 = $1; b2 = $2; b3 = $3; b4 = $4; next }
NR == 3 { c1 = $1; c2 = $2; c3 = $3; c4 = $4; next }
NR == 4 { d1 = $1; d2 = $2; d3 = $3; d4 = $4; next }
{
	x = $1
	y = $2
	z = $3
	w = x * a4 + y * b4 + z * c4 + d4
	printf "%.17g %.17g %.17g\n", (x * a1 + y * b1 + z * c1 + d1) / w,
	    (x * a2 + y * b2 + z * c2 + d2) / w,
	    (x * a3 + y * b3 + z * c3 + d3) / w
}
