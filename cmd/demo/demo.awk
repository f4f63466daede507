# Draws triangles in a terminal. The first file has points in view space, the
# second the same points in a device of 160 x 96 dots, the third triangles, by
# the numbers of their points from 0. A character is 2 x 4 dots; more of them
# are lit where a triangle faces the lamp.

# Sets low and high to the least and largest of three, in whole dots from 0.
function span(a, b, c)
{
	low = a < b ? (a < c ? a : c) : (b < c ? b : c)
	high = a > b ? (a > c ? a : c) : (b > c ? b : c)
	low = low < 0 ? 0 : int(low)
}

# The cosine between a triangle's normal and the direction to the lamp.
function facing(a, b, c,    i, j, k, n, nn, nl)
{
	for (i = 0; i < 3; i++) {
		j = (i + 1) % 3
		k = (i + 2) % 3
		n = (view[b, j] - view[a, j]) * (view[c, k] - view[a, k]) - \
		    (view[b, k] - view[a, k]) * (view[c, j] - view[a, j])
		nn += n * n
		nl += n * lamp[i + 1]
	}
	return nn > 0 ? nl / sqrt(nn) : 0
}

function cross(a, b, x, y)
{
	return (X[b] - X[a]) * (y - Y[a]) - (Y[b] - Y[a]) * (x - X[a])
}

# Draws those dots of a triangle that are nearer than what was drawn there.
function fill(a, b, c, shade,    area, x, y, x1, y1, u, v, z)
{
	if ((area = cross(a, b, X[c], Y[c])) == 0)
		return
	span(Y[a], Y[b], Y[c])
	y1 = high
	for (y = low; y <= y1; y++) {
		span(X[a], X[b], X[c])
		x1 = high
		for (x = low; x <= x1; x++) {
			u = cross(b, c, x, y) / area
			v = cross(c, a, x, y) / area
			z = u * Z[a] + v * Z[b] + (1 - u - v) * Z[c]
			if (u < 0 || v < 0 || u + v > 1 || \
			    (x, y) in depth && depth[x, y] <= z)
				continue
			depth[x, y] = z
			lit[x, y] = shade > threshold[y % 4 * 4 + x % 4 + 1]
		}
	}
}

BEGIN {
	split("-0.48 0.6 -0.64", lamp)
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
		view[points + 0, i] = $(i + 1)
	points++
}
FILENAME == ARGV[2] {
	X[vertex + 0] = $1
	Y[vertex + 0] = $2
	Z[vertex + 0] = $3
	vertex++
}
FILENAME == ARGV[3] {
	fill($1, $2, $3, 0.2 + 0.8 * facing($1, $2, $3))
}
END {
	for (y = 0; y < 96; y += 4) {
		line = ""
		for (x = 0; x < 160; x += 2) {
			dots = 0
			for (i = 0; i < 8; i++)
				if (lit[x + i % 2, y + int(i / 2)])
					dots += bit[i + 1]
			# U+2800 + dots in UTF-8
			line = line sprintf("\342%c%c", \
			    160 + int(dots / 64), 128 + dots % 64)
		}
		sub(/(\342\240\200)+$/, "", line)
		print line
	}
}
