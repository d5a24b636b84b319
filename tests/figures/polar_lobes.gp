# Draws BRDF lobes in the plane of incidence. polar_lobes.sh sets out, folder and, one entry per lobe: array name (the
# label), array at (the angle in degrees at which its leader touches the curve), arrays label_x and label_y (where the
# label stands, in decades from the centre). folder/N.dat holds lobe N: theta_o in degrees, f in 1/sr.
#
# The radius is logarithmic, so that a mirror-like lobe and a diffuse one can both be read.
set angles degrees
low = -3              # log10 f at the centre
rings = 5             # decades, one ring each
radius(f) = f > 10 ** low ? log10(f) - low : 0
colours = "#0072B2 #D55E00 #009E73 #CC79A7 #E69F00 #56B4E9"

# Where the leaders touch; before any range is set, as statistics leave out what is outside of it.
array touch[|at|]
do for [k = 1:|at|] {
  stats sprintf("%s/%d.dat", folder, k) using (abs($1 - at[k]) < 0.051 ? $2 : NaN) nooutput
  touch[k] = radius(STATS_max)
}

set terminal pngcairo size 1600, 760 enhanced font "DejaVu Sans,17" linewidth 1.5 background rgb "white"
set output out
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set size ratio -1
set xrange [-1.6 * rings : 1.6 * rings]
set yrange [-0.2 * rings : 1.32 * rings]
unset border; unset tics; unset key

grey = "#D4D4D4"
small = "DejaVu Sans,13"
do for [ring = 1:rings] {
  set object circle at 0, 0 size ring arc [0:180] nowedge fillstyle empty border lc rgb grey lw 0.8 back
  do for [side in "-1 1"] {
    set label gprintf("10^{%T}", 10.0 ** (low + ring)) at side * ring, -0.17 center font small tc rgb "#606060"
  }
}
do for [spoke = -75:75:15] {
  set arrow from 0, 0 to rings * sin(spoke), rings * cos(spoke) nohead lc rgb grey lw 0.5 back
  set label sprintf("%d°", abs(spoke)) at (rings + 0.25) * sin(spoke), (rings + 0.25) * cos(spoke) center \
      font small tc rgb "#606060"
}
set arrow from -rings * 1.04, 0 to rings * 1.04, 0 nohead lc rgb "#404040" lw 1.2 front
set label "{/:Italic f} in 1/sr, one ring a decade" at 0, -0.55 center font "DejaVu Sans,15" tc rgb "#404040"

set label "BRDF lobes in the plane of incidence, along the brushing; light at " . sprintf("%g°", angle_i) . "; green channel" \
    at 0, 1.22 * rings center font "DejaVu Sans,19"

# wi points to the light; the mirror direction is dashed.
set arrow from 0, 0 to -rings * 0.97 * sin(angle_i), rings * 0.97 * cos(angle_i) \
    filled size 0.2, 16 lc rgb "#202020" lw 2.6 front
set label "ω_i" at -rings * 0.93 * sin(angle_i) + 0.22, rings * 0.93 * cos(angle_i) + 0.1 \
    font "DejaVu Sans,20" front
set arrow from 0, 0 to rings * sin(angle_i), rings * cos(angle_i) nohead lc rgb "#909090" lw 1 dt (12, 8) back

do for [k = 1:|at|] {
  colour = word(colours, k)
  set arrow from touch[k] * sin(at[k]), touch[k] * cos(at[k]) to label_x[k], label_y[k] nohead \
      lc rgb colour lw 1 front
  if (label_x[k] < 0) {
    set label name[k] at label_x[k] - 0.1, label_y[k] right tc rgb colour front
  } else {
    set label name[k] at label_x[k] + 0.1, label_y[k] left tc rgb colour front
  }
}
plot for [k = 1:|at|] sprintf("%s/%d.dat", folder, k) \
    using (radius($2) * sin($1)):(radius($2) * cos($1)) with lines lw 2.4 lc rgb word(colours, k)
