# SPDX-License-Identifier: MIT
# Draws a solid in a terminal: its outline, and dots where a lamp shines on it. The
# first file has points, the second the images of the points on a device of 160 x 96
# dots. The third has triangles, each as the numbers of three points, from 0. A
# character has 2 x 4 dots.

# Adds the normal of a triangle to one of its corners. Its length is twice the area.
function add_normal(corner, a, b, c,    i, j, k)
{
	for (i = 0; i < 3; i++) {
		j = (i + 1) % 3
		k = (i + 2) % 3
		normal[corner, i] += \
		    (at[b, j] - at[a, j]) * (at[c, k] - at[a, k]) - \
		    (at[b, k] - at[a, k]) * (at[c, j] - at[a, j])
	}
}

# Returns the light that a point gets from the lamp. The power darkens points with
# little light, so that hollows stand out.
function light(v,    i, nn, nl)
{
	for (i = 0; i < 3; i++) {
		nn += normal[v, i] ^ 2
		nl += normal[v, i] * lamp[i + 1]
	}
	return nl > 0 ? 1.2 * (nl / sqrt(nn)) ^ 2.5 : 0
}

# Sets low and high to the least and the greatest of three numbers, in whole dots from
# 0.
function span(a, b, c)
{
	low = a < b ? (a < c ? a : c) : (b < c ? b : c)
	high = a > b ? (a > c ? a : c) : (b > c ? b : c)
	low = low < 0 ? 0 : int(low)
}

function cross(a, b, x, y)
{
	return (X[b] - X[a]) * (y - Y[a]) - (Y[b] - Y[a]) * (x - X[a])
}

# Stores the depth and light of a triangle at each of its dots, unless a nearer triangle
# is stored there.
function fill(a, b, c,    area, x, y, x1, y1, u, v, z)
{
	if ((area = cross(a, b, X[c], Y[c])) == 0)
		return
	span(Y[a], Y[b], Y[c])
	y1 = high
	for (y = low; y <= y1; y++) {
		span(X[a], X[b], X[c])
		x1 = high
		for (x = low; x <= x1; x++) {
			u = cross(b, c, x + 0.5, y + 0.5) / area
			v = cross(c, a, x + 0.5, y + 0.5) / area
			z = u * Z[a] + v * Z[b] + (1 - u - v) * Z[c]
			if (u < 0 || v < 0 || u + v > 1 || \
			    (x, y) in depth && depth[x, y] <= z)
				continue
			depth[x, y] = z
			bright[x, y] = u * lit[a] + v * lit[b] + \
			    (1 - u - v) * lit[c]
		}
	}
}

# Returns whether the dot x, y, beside a dot of depth z, is background or far behind it.
function beyond(z, x, y)
{
	return !((x, y) in depth) || depth[x, y] - z > 0.02
}

function dot(x, y,    z)
{
	if (!((x, y) in depth))
		return 0
	z = depth[x, y]
	return beyond(z, x - 1, y) || beyond(z, x + 1, y) || \
	    beyond(z, x, y - 1) || beyond(z, x, y + 1) || \
	    bright[x, y] > threshold[y % 4 * 4 + x % 4 + 1]
}

BEGIN {
	split("-0.48 0.82 -0.31", lamp)
	split("0 8 2 10 12 4 14 6 3 11 1 9 15 7 13 5", threshold)
	for (i = 1; i <= 16; i++)
		threshold[i] = (threshold[i] + 0.5) / 16
	split("1 8 2 16 4 32 64 128", bit)
}
/^#/ {
	next
}
FILENAME == ARGV[1] {
	for (i = 0; i < 3; i++)
		at[points + 0, i] = $(i + 1)
	points++
}
FILENAME == ARGV[2] {
	X[vertex + 0] = $1
	Y[vertex + 0] = $2
	Z[vertex + 0] = $3
	vertex++
}
FILENAME == ARGV[3] {
	for (i = 1; i <= 3; i++)
		add_normal($i, $1, $2, $3)
	triangle[triangles++] = $0
}
END {
	for (i = 0; i < points; i++)
		lit[i] = light(i)
	for (i = 0; i < triangles; i++) {
		split(triangle[i], corner)
		fill(corner[1], corner[2], corner[3])
	}
	for (y = 0; y < 96; y += 4) {
		line = ""
		for (x = 0; x < 160; x += 2) {
			dots = 0
			for (i = 0; i < 8; i++)
				dots += bit[i + 1] * dot(x + i % 2, y + int(i / 2))
			# U+2800 + dots in UTF-8
			line = line sprintf("\342%c%c", \
			    160 + int(dots / 64), 128 + dots % 64)
		}
		sub(/(\342\240\200)+$/, "", line)
		print line
	}
}
