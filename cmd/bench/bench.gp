# SPDX-License-Identifier: MIT
# The charts of what bench.pl measured last.
# usage: gnuplot -c bench.gp DATA CHARTS, two directories
data = ARG1 . "/"
array Kind[3] = ["ours", "double", "float"]
array Title[3] = ["projcalc", "others in double", "others in float"]
array Hollow[3] = [4, 6, 8]

# A panel of 690 x 240, in which names.pl has placed the names, below y pixels of
# a picture that is so high.
axes = 'load data . name . ".gp"; \
set lmargin at screen 85 / 800.0; \
set rmargin at screen 775 / 800.0; \
set tmargin at screen 1 - y / high; \
set bmargin at screen 1 - (y + 240) / high; \
set label 2 title at graph 0, 1 offset 0, 1'
half = 2.0**-44
is(kind, c) = strcol(1) eq kind ? column(c) : NaN
on(side, c) = column(4) == side ? column(c) : NaN
names = '"" index 1 using 2:(on(1, 3)):1 with labels left notitle, \
    "" index 1 using 2:(on(0, 3)):1 with labels center notitle, \
    "" index 1 using 2:(on(-1, 3)):1 with labels right notitle'
points = 'half with lines linestyle 4 dashtype 2 notitle, \
    for [k = 1:3] data . name . ".tsv" index 0 using 2:(is(Kind[k], 3)) \
    with points linestyle k title Title[k]'

frame = 'set datafile separator "\t"; \
set style line 1 linecolor rgb "#000000" pointtype 5 pointsize 0.8; \
set style line 2 linecolor rgb "#0072b2" pointtype 7 pointsize 0.7; \
set style line 3 linecolor rgb "#d55e00" pointtype 9 pointsize 0.8; \
set style line 4 linecolor rgb "#909090" linewidth 1; \
set border 3 linecolor rgb "#606060"; \
set tics nomirror out textcolor rgb "#404040"; \
set logscale xy; \
set format y "10^{%T}"; \
set ytics 1e-15, 1000; \
unset mxtics; \
unset mytics; \
set xlabel "nanoseconds a point, CPU" offset 0, 0.4; \
set ylabel "worst error in pixels" offset 1; \
set key at screen 0.97, screen 1 - 45 / high right top horizontal \
    Left reverse samplen 1'

high = 865.0
set terminal svg size 800,high font "Helvetica,13" background "white"
set output ARG2 . "/programs.svg"
set multiplot title "Whole programs, from the world to the device" font ",16"
@frame
name = "text"
title = "Lines of three numbers, one thread; " . \
    "loop, GLM, cglm and Eigen with fast\\_float and std::to\\_chars"
y = 95
@axes
plot @points, @names
unset key
name = "binary"
title = "Binary points, one thread; " . \
    "loop, GLM, cglm and Eigen with fread and fwrite"
y = 425
@axes
plot @points, @names

reset
set datafile separator "\t"
unset key
unset xtics
set border 2 linecolor rgb "#606060"
set label 2 "Two threads against one, exact: million points a second, wall" \
    at screen 85 / 800.0, screen 1 - 742 / high
set ytics scale 0 nomirror
set lmargin at screen 180 / 800.0
set rmargin at screen 720 / 800.0
set tmargin at screen 1 - 755 / high
set bmargin at screen 10 / high
set xrange [0:*]
set yrange [3.6:-0.6]
# One thread is even, two are odd.
bar = '($0 - 0.35):($0 + 0.35)'
threads(n) = int($0) % 2 + 1 == n ? column(2) : NaN
plot data . "threads.tsv" using (0):0:(0):(threads(1)):@bar:ytic(1) \
    with boxxyerror fillstyle solid noborder linecolor rgb "#000000", \
    "" using (0):0:(0):(threads(2)):@bar \
    with boxxyerror fillstyle pattern 5 linecolor rgb "#707070", \
    "" using 2:0:(sprintf("%.1f", column(2))) with labels left offset 0.6, 0
unset multiplot

high = 380.0
set terminal svg size 800,high font "Helvetica,13" background "white"
set output ARG2 . "/memory.svg"
reset
set multiplot title "In memory, from the world to the device, one thread" \
    font ",16"
@frame
set label 3 "hollow: scenes 1e9 away from the origin, where floats have no room" \
    at graph 0.99, 0.96 right font ",11" textcolor rgb "#404040"
name = "memory"
title = ""
y = 75
@axes
plot @points, data . name . ".tsv" index 0 \
    using 2:3:(0):($4 - $3) with vectors nohead linestyle 4 notitle, \
    for [k = 1:3] "" index 0 using 2:($4 == $3 ? NaN : is(Kind[k], 4)) \
    with points linestyle k pointtype Hollow[k] notitle, \
    @names
unset multiplot
