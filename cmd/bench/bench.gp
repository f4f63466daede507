# The charts of what bench.sh measured last.
# usage: gnuplot -c bench.gp DATA CHARTS, two directories
set terminal svg size 860,560 font "Helvetica,14" background "white"
set datafile separator "\t"
set border 3
set tics nomirror out
set style textbox opaque noborder fillcolor "white" margins 0.3,0.3
grey = "#808080"
ours = "#000000"

memory = ARG1 . "/memory.tsv"
set output ARG2 . "/speed-accuracy.svg"
set title "A point from world to device: how fast, how exact" font ",16"
set xlabel "nanoseconds a point, in memory"
set ylabel "worst error in device units"
set logscale xy
set xrange [0.3:10]
set xtics (0.3, 0.5, 1, 2, 3, 5, 10)
# What is no number stands above all that are.
none = 1e2
set yrange [1e-15:1e3]
set format y "10^{%T}"
set ytics 1e-14, 100, 1
unset mytics
set ytics add ("nan" none)
error(c) = strcol(c) eq "inf" ? none : column(c)
half = 2.0**-44
set label 1 "the nearest double to a coordinate beyond 512" \
    at 0.31, half offset 0, -0.7 font ",12" textcolor rgb "#404040"
mine(c) = strcol(1)[1:8] eq "projcalc" ? error(c) : NaN
peer(c) = strcol(1)[1:8] eq "projcalc" ? NaN : error(c)
# Where a name stands, so that it meets neither a point nor another name.
left = "projcalc double, projcalc single, GLM double"
right = "projcalc exact, cglm float, Eigen double"
above = "GLM float"
below = "projcalc -t 0.5"
on(names) = strstrt(names, strcol(1)) ? error(4) : NaN
set key at graph 1.08, graph 1 Left reverse samplen 1 spacing 1.2
plot half with lines linecolor rgb grey dashtype 2 notitle, \
    memory using 3:(error(4)):(0):(error(5) - error(4)) with vectors \
    nohead linecolor rgb grey notitle, \
    "" using 3:(on(left)):1 with labels boxed right offset -1.2, 0 notitle, \
    "" using 3:(on(right)):1 with labels boxed left offset 1.2, 0 notitle, \
    "" using 3:(on(above)):1 with labels boxed right offset -1.2, 0.5 notitle, \
    "" using 3:(on(below)):1 with labels boxed offset 0, -1 notitle, \
    "" using 3:(mine(4)) with points pointtype 5 pointsize 0.9 \
    linecolor rgb ours title "projcalc, ordinary scenes", \
    "" using 3:(mine(5)) with points pointtype 4 pointsize 1.3 linewidth 2 \
    linecolor rgb ours title "the same, 1e9 away", \
    "" using 3:(peer(4)) with points pointtype 7 pointsize 0.9 \
    linecolor rgb grey title "others, ordinary scenes", \
    "" using 3:(peer(5)) with points pointtype 6 pointsize 0.9 linewidth 2 \
    linecolor rgb grey title "the same, 1e9 away"

reset
set datafile separator "\t"
rates = ARG1 . "/throughput.tsv"
set output ARG2 . "/throughput.svg"
stats rates using 2 nooutput
set title "Whole programs, text in and text out" font ",16"
set xlabel "million lines of three numbers a second"
set xrange [0:STATS_max * 1.1]
set yrange [STATS_records - 0.4:-0.6]
set border 1
set tics nomirror out
set ytics scale 0
set xtics border
set key off
set lmargin 32
set style fill solid border rgb ours
high = 0.36
mine(c) = strcol(1)[1:8] eq "projcalc" ? column(c) : NaN
peer(c) = strcol(1)[1:8] eq "projcalc" ? NaN : column(c)
plot rates using (0):0:(0):(mine(2)):($0 - high):($0 + high):ytic(1) \
    with boxxyerror linecolor rgb "#202020", \
    "" using (0):0:(0):(peer(2)):($0 - high):($0 + high) \
    with boxxyerror linecolor rgb "#c0c0c0", \
    "" using 2:0:(sprintf("%.2f", $2)) with labels left offset 0.5, 0
