# SPDX-License-Identifier: MIT
# Draws what `stability data` writes, to standard output:
#	gnuplot -e "data='stability.dat'" stability.gp > stability.svg
if (!exists("terminal")) terminal = "svg size 900,1180"
eval "set terminal ".terminal." font 'sans-serif,12' background 'white'"

# x is the power of ten, from left to right; what lies beyond is at the edge.
array Name[13] = ["distance", "up", "wide", "narrow", "unproject", "zoom", \
    "volume", "turns", "squared", "depth", "at", "size", "plane"]
array Title[13] = ["Far from the origin", "Up close to the gaze", \
    "Field of view close to 180°", "Narrow field of view", \
    "From the screen to the world", "Deep zoom in 2D", \
    "Almost parallel projection", "Turned by small rotations", \
    "Turned, then orthonormalized", "Near and far close: depth", \
    "Eye close to what it looks at", "Size of the whole scene", \
    "Points close to the eye plane"]
array Swept[13] = ["distance", "angle between them, radians", \
    "180° less the angle, degrees", "degrees", "far / near", \
    "part of the window in sight", "1 / distance of the eye", \
    "number of turns", "number of turns", "far / near − 1", "distance", \
    "unit of length", "depth of the points"]
array Left[13] = [0, 0, 0, -1, 2, 0, -3, 0, 0, 18, 0, -150, 0]
array Right[13] = [15, -15, -10, -9, 12, -15, -18, 6, 6, -15, -150, 150, -17]
array Step[13] = [5, 5, 5, 2, 5, 5, 3, 2, 2, 10, 50, 100, 5]
array Unit[13] = ["", "", "", "", "units of the world", \
    "", "", "", "", "steps of a 24-bit buffer", "", "", \
    "units in the last place"]

array Way[5] = ["single, matrices composed first", \
    "double, matrices composed first", \
    "double, stage by stage", "double, relative to the eye", "exact"]
set style line 1 lc rgb "#888888" lw 2 dt "." pt -1
set style line 2 lc rgb "#d55e00" lw 1.5 dt "-" pt 4 ps 0.7 pi 2
set style line 3 lc rgb "#009e73" lw 1.5 dt "_." pt 8 ps 0.6 pi 2
set style line 4 lc rgb "#0072b2" lw 1.5 dt "_" pt 13 ps 0.5 pi 2
set style line 5 lc rgb "#000000" lw 3 dt 1 pt -1

set logscale y
set tics nomirror scale 0.5,0 font ",11"
set border 3 lc rgb "#555555"
set format x "10^{%g}"
set format y "10^{%T}"
set xlabel font ",12" offset 0, 0.5
set title font ",13" offset 0, -0.6

# What is lost stands at the top.
at(e) = e < 0 || e > top ? top : e < floor ? floor : e
between(x, a, b) = x < a ? a : x > b ? b : x
beside(x) = between(log10(x), least, most)

set multiplot layout 5, 3 margins 0.065, 0.975, 0.045, 0.935 \
    spacing 0.035, 0.066 title "How far off the image of a point is,\
 in pixels, as the scene gets harder" font ",16"
unset key
do for [i = 1:13] {
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
	# the panels of a row share their y
	unset ytics
	if (i % 3 == 1) {
		set ytics 1e-16, 1e4 nomirror scale 0.5,0 font ",11"
		set ytics add ("lost" top)
	}
	set title Title[i]
	set xlabel Swept[i]
	set label 1 Unit[i] at graph 0.99, 0.06 right font ",11"
	unset arrow
	if (Unit[i] eq "") {
		set arrow from graph 0, first 0.5 to graph 1, first 0.5 \
		    nohead lc rgb "#cc0000" lw 0.7
	}
	set label 2 i == 1 ? "half a pixel" : "" at graph 0.02, first 8 \
	    font ",11" tc rgb "#cc0000"
	plot for [w = 1:5] data index Name[i] \
	    using (beside($1)):(at(column(2 * w + ulps))) \
	    smooth unique with linespoints ls w title ""
}
# The key has the last two cells to itself.
unset title
unset xlabel
unset tics
unset border
unset arrow
unset label
set label 1 "The worst of a few hundred points.\nLost: not a number,\
 mirrored, or on the wrong side of the eye." at graph 0.06, 0.08 font ",12"
set key at graph 0, 1 left top Left reverse samplen 6 spacing 1.3 font ",13"
plot for [w = 1:5] NaN with linespoints ls w title Way[w]
unset multiplot
