# Pictures side by side with a line of text below each; see ashikhmin_shirley.sh for the variables.
rows = (|name| + columns - 1) / columns
line = 24
gap = 8
total_width = columns * (width + gap) + gap
total_height = rows * (height + line + gap) + gap
set terminal pngcairo size total_width, total_height font "DejaVu Sans,10" background "#ffffff"
set output out
set multiplot
unset border; unset tics; unset key; unset colorbox
do for [i = 1:|name|] {
  row = (i - 1) / columns
  column = (i - 1) % columns
  left = 1.0 * (gap + column * (width + gap)) / total_width
  top = 1 - 1.0 * (gap + row * (height + line + gap)) / total_height
  set lmargin at screen left
  set rmargin at screen left + 1.0 * width / total_width
  set tmargin at screen top
  set bmargin at screen top - 1.0 * height / total_height
  set xrange [-0.5:width - 0.5]; set yrange [-0.5:height - 0.5]
  set label 1 label[i] at screen left + 0.5 * width / total_width, \
    screen top - (height + 0.5 * line) / total_height center
  plot folder . "/" . name[i] . ".png" binary filetype=png with rgbimage
}
unset multiplot
