# The error of figure 6 by samples and by time; `data` is the CSV of tests/bench/closeup, `out` the picture.
set terminal pngcairo size 900, 400 font "DejaVu Sans,10" background "#ffffff"
set output out
set datafile separator ","
set multiplot layout 1, 2
set logscale xy
set grid lc rgb "#dddddd"
set border 3; set tics nomirror
set key top right
set ylabel "RMS error over the mean"
set format y "%g"
set xlabel "samples a pixel"
plot "< grep gonio " . data using 2:4 with linespoints pt 7 ps 0.8 lw 2 lc rgb "#1f5faa" title "gonio", \
     "< grep paper " . data using 2:4 with linespoints pt 6 ps 0.8 lw 2 lc rgb "#c0504d" title "the paper's strategy"
set xlabel "seconds"
plot "< grep gonio " . data using 3:4 with linespoints pt 7 ps 0.8 lw 2 lc rgb "#1f5faa" title "gonio", \
     "< grep paper " . data using 3:4 with linespoints pt 6 ps 0.8 lw 2 lc rgb "#c0504d" title "the paper's strategy"
unset multiplot
