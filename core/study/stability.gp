# SPDX-License-Identifier: MIT
# Draws what `stability data` writes, to standard output:
#	gnuplot -e "data='stability.dat'" stability.gp > stability-all.svg
#	gnuplot -e "data='stability.dat'; panels='distance, up'" stability.gp
# draws only these panels.

# x is the power of ten of the severity; the value beyond the last is drawn at
# the edge.
Panels = 17
array Name[Panels] = ["distance", "up", "wide", "narrow", "zoom", "volume", \
    "turns", "squared", "at", "size", "unproject", "back", "normal depth", \
    "reversed depth", "depth", "plane", "tiles"]
array Title[Panels] = ["Far from the origin", "Up close to the gaze", \
    "Field of view close to 180°", "Narrow field of view", \
    "Deep zoom in 2D", "Almost parallel projection", \
    "Turned by small rotations", "Turned, then orthonormalized", \
    "Eye close to what it looks at", "Size of the whole scene", \
    "From the screen to the world", "To the world, far from its origin", \
    "Depth over distance", "Reversed depth over distance", \
    "Near and far close: depth", "Points close to the eye plane", \
    "Off-axis tiles of a wall"]
array Swept[Panels] = ["distance", "angle between them, radians", \
    "180° less the angle, degrees", "degrees", \
    "part of the window in sight", "1 / distance of the eye", \
    "number of turns", "number of turns", "distance", "unit of length", \
    "far / near", "distance", "distance / near", "distance / near", \
    "far / near − 1", "depth of the points", "size of a tile"]
array Left[Panels] = [0, 0, 0, -1, 0, -3, 0, 0, 0, -150, 2, 0, 0, 0, 18, 0, 0]
array Right[Panels] = [15, -18, -10, -9, -15, -18, 6, 6, -150, 150, 12, 15, \
    15, 15, -15, -17, -15]
array Step[Panels] = [5, 5, 5, 2, 5, 3, 2, 2, 50, 100, 5, 5, 5, 5, 10, 5, 5]
array Unit[Panels] = ["", "", "", "", "", "", "", "", "", "", \
    "units of the world", "units of the world", "parts of the distance", \
    "parts of the distance", "steps of a 24-bit buffer", \
    "units in the last place", ""]
# What to do. The errors in the panel show what it says of projcalc.
array Remedy[Panels] = ["any -p; elsewhere subtract the eye first", \
    "any -p; parallel: give another up", \
    "any -p; elsewhere edges, not an angle", \
    "the default; -p double keeps 0.01 pixels", \
    "any -p keeps a thousandth of a pixel", \
    "any -p; elsewhere take w = 1 − z / eye z", \
    "any -p; elsewhere one turn, modulo 360°", \
    "any -p; elsewhere one turn, modulo 360°", \
    "any -p; elsewhere doubles, not floats", \
    "any -p; elsewhere doubles, not floats", \
    "the default; elsewhere doubles, a larger near", \
    "the default; --to view keeps all digits", \
    "reverse\\_z keeps all digits; or a larger near", \
    "none is needed: keep reverse\\_z", \
    "the default; elsewhere a larger far", \
    "the default; elsewhere clip at a larger near", \
    "the default; -p double for tiles above 10^{-12}"]
# Where the exact results are large, the nearest double is far from them.
rises(i) = Name[i] eq "back" || Name[i] eq "normal depth"

array Way[8] = ["textbook, float, composed", \
    "textbook, double, composed", "textbook, double, by stages", \
    "textbook, double, from the eye", \
    "textbook, double, inverse by LU", \
    "projcalc -p single", "projcalc -p double", "projcalc, exact"]
set style line 1 lc rgb "#cc79a7" lw 2 dt "." pt -1
set style line 2 lc rgb "#d55e00" lw 1.5 dt "-" pt 4 ps 0.7 pi 2
set style line 3 lc rgb "#009e73" lw 1.5 dt "_." pt 8 ps 0.6 pi 2
set style line 4 lc rgb "#0072b2" lw 1.5 dt "_" pt 13 ps 0.5 pi 2
set style line 5 lc rgb "#7b3294" lw 1.5 dt "-" pt 1 ps 0.6 pi 2
set style line 6 lc rgb "#aaaaaa" lw 2 dt 1 pt -1
set style line 7 lc rgb "#666666" lw 2 dt 1 pt -1
set style line 8 lc rgb "#000000" lw 3 dt 1 pt -1
# The way LU is drawn only for maps from the device, as the others invert
# nothing.
shown(i, w) = w != 5 || Name[i] eq "unproject" || Name[i] eq "back"

set logscale y
set tics nomirror scale 0.5,0 font ",11"
set border 3 lc rgb "#555555"
set format x "10^{%g}"
set format y "10^{%T}"
set xlabel font ",12" offset 0, 0.5
set ylabel font ",12" offset 1.5
set title font ",13" offset 0, -0.6

# A lost image is drawn at the top.
at(e) = e < 0 || e > top ? top : e < floor ? floor : e
between(x, a, b) = x < a ? a : x > b ? b : x
beside(x) = x > 0 ? between(log10(x), least, most) : least

# Sizes are in pixels. The key has the last cell to itself, or a strip of its own below
# full rows.
if (!exists("panels")) panels = ""
is_chosen(i) = panels eq "" || strstrt(", ".panels.", ", ", ".Name[i].", ") > 0
count = 0
do for [i = 1:Panels] { count = count + is_chosen(i) }
rows = (count + 2) / 3
strip = count % 3 == 0 ? 105 : 0
width = 900.0
below = 55.0 + strip
above = 90.0
high = above + below + 150 * rows + 104 * (rows - 1)
eval sprintf("set terminal svg size %d,%d font 'sans-serif,12' background 'white'", \
    width, high)
set multiplot layout rows, 3 margins 0.085, 0.975, below / high, 1 - above / high \
    spacing 0.075, 104 / high title "How far off the image of a point is \
as the scene gets harder" font ",16"
unset key
do for [i = 1:Panels] {
	if (!is_chosen(i)) { continue }
	ulps = Name[i] eq "plane" ? 1 : 0
	floor = ulps ? 1e-4 : 1e-17
	top = ulps ? 1e20 : 1e7
	least = Left[i] < Right[i] ? Left[i] : Right[i]
	most = Left[i] < Right[i] ? Right[i] : Left[i]
	set xrange [Left[i]:Right[i]]
	set yrange [floor:top]
	set xtics Step[i]
	if (Name[i] eq "depth") { set xtics add ("∞" 18) }
	if (Name[i] eq "volume") { set xtics add ("10^{-300}" -18) }
	if (Name[i] eq "up") { set xtics add ("0" -18) }
	set ytics floor * 10, 1e4 nomirror scale 0.5,0 font ",11"
	set ytics add ("lost" top)
	set title Title[i] offset 0, 0.3
	set xlabel Swept[i]
	unset arrow
	unset label
	set label Remedy[i] at graph 0.5, 1 center offset 0, 0.7 font ",11" \
	    tc rgb "#00603c"
	if (Unit[i] eq "") {
		set ylabel "pixels" tc rgb "#555555"
		set arrow from graph 0, first 0.5 to graph 1, first 0.5 \
		    nohead lc rgb "#cc0000" lw 0.7
	} else {
		set ylabel "{/:Bold ".Unit[i]."}" tc rgb "#000000"
	}
	if (i == 1) {
		set label "half a pixel" at graph 0.02, first 8 \
		    font ",11" tc rgb "#cc0000"
	}
	if (rises(i)) {
		set label "no double is nearer" at graph 0.98, 0.06 right \
		    font ",11"
	}
	if (Name[i] eq "up") {
		set label "parallel:\nrefused" at first -17.7, first 1e-9 \
		    right font ",11"
		set arrow from first -18, first 1e-13 to first -18, first 1e-4 \
		    nohead ls 8 dt "."
	}
	plot for [w = 1:8] data index Name[i] using (beside($1)):(shown(i, w) ? \
	    at(column(2 * w + ulps)) : NaN) \
	    smooth unique with linespoints ls w title ""
}
unset title
unset xlabel
unset ylabel
unset tics
unset border
unset arrow
unset label
set lmargin at screen strip ? 0.085 : 0.68
set rmargin at screen 0.99
set tmargin at screen (strip ? strip + 5.0 : 220.0) / high
set bmargin at screen 5.0 / high
lines = strip ? "composed: one product of all matrices. The worst of a few \
hundred points. Lost: not a number, mirrored, or on the wrong side of the eye." : \
    "composed: one product of all matrices.\nThe worst of a few hundred \
points.\nLost: not a number, mirrored, or on\nthe wrong side of the eye."
set label lines at graph (strip ? 0.005 : 0.03), strip ? 0.3 : 0.31 font ",11"
set key at graph 0, 1.03 left top Left reverse maxrows (strip ? 3 : 8) samplen 4 \
    spacing 1.05 font ",11"
plot for [w = 1:8] NaN with linespoints ls w title Way[w]
unset multiplot
