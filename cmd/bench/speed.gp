# SPDX-License-Identifier: MIT
# Draws the chart of the last measurement of bench.pl, to standard output.
# usage: gnuplot -c speed.gp DATA, a directory
data = ARG1 . "/"
array Kind[4] = ["ours", "double", "float", "wide"]
array Key[4] = ["projcalc", "others in double", "in float", "in wider types"]
array Hollow[4] = [4, 6, 8, 12]
array Name[3] = ["text", "binary", "memory"]
array Title[3] = ["Programs, lines of three numbers", \
    "Programs, binary: loops in place; libraries with fread and write", \
    "Points in memory"]

# Panels have 690 x 260 pixels; names.pl has placed the names in them.
high = 1120.0
set terminal svg size 800,high font "Helvetica,13" background "white"
set datafile separator "\t"
set style line 1 linecolor rgb "#000000" pointtype 5 pointsize 0.8
set style line 2 linecolor rgb "#0072b2" pointtype 7 pointsize 0.7
set style line 3 linecolor rgb "#d55e00" pointtype 9 pointsize 0.8
set style line 4 linecolor rgb "#007a50" pointtype 13 pointsize 0.9
set style line 5 linecolor rgb "#b0b0b0" linewidth 1
set border 3 linecolor rgb "#606060"
set tics nomirror out textcolor rgb "#404040"
set logscale xy
set format y "10^{%T}"
set ytics 1e-15, 1000
unset mxtics
unset mytics
set xlabel "nanoseconds a point, CPU, one thread" offset 0, 0.5
set ylabel "worst error in pixels" offset 1
set lmargin at screen 85 / 800.0
set rmargin at screen 775 / 800.0
set key at screen 0.97, screen 1 - 48 / high right top horizontal \
    Left reverse samplen 1
set label 3 "lower left is better:\nfaster, and nearer to the truth" \
    at graph 0.06, 0.68 left textcolor rgb "#404040"
set arrow 3 from graph 0.055, 0.6 to graph 0.02, 0.5 linecolor rgb "#404040"
set label 5 "each panel has a scale of its own for the time" \
    at graph 0.06, 0.49 left font ",11" textcolor rgb "#404040"
set label 4 "half a unit in the last place: no double is nearer" \
    at graph 0.99, first 2.0**-44 offset 0, -0.6 right font ",11" \
    textcolor rgb "#404040"

is(kind, c) = strcol(1) eq kind ? column(c) : NaN
set multiplot title "From the world to the device: speed against accuracy" \
    font ",16"
do for [i = 1:3] {
	name = data . Name[i]
	top = 100 + 350 * (i - 1)
	load name . ".gp"
	set tmargin at screen 1 - top / high
	set bmargin at screen 1 - (top + 260) / high
	set label 2 Title[i] at graph 0, 1 offset 0, 1
	if (Name[i] eq "memory") {
		set label 6 "hollow: the same in scenes 1e9\naway, for which floats have\nno room" \
		    at graph 0.99, 0.62 right font ",12" textcolor rgb "#404040"
	}
	far(k) = column(4) == column(3) ? NaN : is(Kind[k], 4)
	plot 2.0**-44 with lines linestyle 5 dashtype 2 notitle, \
	    name . ".tsv" index 0 using 2:3:(0):($4 - $3) with vectors nohead \
	    linestyle 5 notitle, \
	    for [k = 1:4] "" index 0 using 2:(is(Kind[k], 3)) \
	    with points linestyle k title Key[k], \
	    for [k = 1:4] "" index 0 using 2:(far(k)) \
	    with points linestyle k pointtype Hollow[k] notitle, \
	    for [k = 1:4] "" index 1 using 3:(is(Kind[k], 4)):2 with labels \
	    font ",12" textcolor linestyle k notitle
	unset key
	unset label 3
	unset label 5
	unset arrow
}
unset multiplot
