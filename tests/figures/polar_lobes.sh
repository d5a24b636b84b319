#!/usr/bin/env bash
# Draws the lobes of several materials in the plane of incidence, evaluated by the command line.
#
#   tests/figures/polar_lobes.sh OUT.png [MEASURED [LABEL]]
#
# The materials are those of tests/data/materials and a measured one, MEASURED. With $GONIO_SERVER set, all of them are
# asked for by name; without, they are read from their files (MEASURED is a MERL .binary, made here if it is left out).
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$top/build/bin
[ $# -ge 1 ] || { sed -n '2,7s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
out=$1
measured=${2:-}
label=${3:-glossy example\\n{/*0.8 table in the MERL layout\}}
command -v gnuplot >/dev/null || { echo "polar_lobes.sh: gnuplot is missing; docker/install.sh --demo installs it" >&2; exit 1; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ -z "$measured" ]; then
  measured=$folder/example.binary
  "$bin/make_merl" "$measured"
fi

material() { if [ -n "${GONIO_SERVER:-}" ]; then echo "$1"; else echo "$top/tests/data/materials/$1.json"; fi; }
angle_i=45
lobe=0
# lobe MATERIAL LABEL AT X Y: where the label's leader touches the curve (degrees), and where the label stands (decades).
lobe() {
  lobe=$((lobe + 1))
  # Along the brushing: phi = 90 degrees. f is the green channel, or the only one.
  "$bin/gonio" evaluate --material "$1" --grid "theta_i=$angle_i,phi_i=270,theta_o=-89.9:89.9:1799,phi_o=90" --deg \
    --format csv --with-input --quiet |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; f = at["f_1"] ? at["f_1"] : at["f_0"] }
             NR > 1 { print $at["theta_o"], $f }' >"$folder/$lobe.dat"
  printf 'name[%d] = "%s"; at[%d] = %s; label_x[%d] = %s; label_y[%d] = %s\n' \
    "$lobe" "$2" "$lobe" "$3" "$lobe" "$4" "$lobe" "$5" >>"$folder/lobes.gp"
}
lobe "$(material brushed-metal)" 'brushed metal\n{/*0.8 Ashikhmin–Shirley}' 57 5.3 2.2
lobe "$(material copper)" 'copper\n{/*0.8 GGX}' 45 4.7 4.0
lobe "$(material aluminium)" 'aluminium\n{/*0.8 Cook–Torrance}' 10 0.8 4.2
lobe "$measured" "$label" -75 -5.3 0.9
lobe "$(material white)" 'white\n{/*0.8 Lambertian}' -60 -4.9 2.4

{
  printf 'out = "%s"; folder = "%s"; angle_i = %s\n' "$out" "$folder" "$angle_i"
  printf 'array name[%d]; array at[%d]; array label_x[%d]; array label_y[%d]\n' $lobe $lobe $lobe $lobe
  cat "$folder/lobes.gp" "$top/tests/figures/polar_lobes.gp"
} >"$folder/all.gp"
gnuplot "$folder/all.gp"
