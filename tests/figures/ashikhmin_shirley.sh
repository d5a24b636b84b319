#!/usr/bin/env bash
# The figures of Ashikhmin & Shirley 2000, "An Anisotropic Phong BRDF Model", made by `gonio render`.
#
#   tests/figures/ashikhmin_shirley.sh FOLDER [SPP]
#
# Writes to FOLDER: 1-metal.png (spheres, rd = 0, over nu and nv), 2-brushed.png (a cylinder), 3-polished.png (a sphere from
# three elevations), 4-diffuse.png (Lambertian beside nu = nv = 5), 6-closeup.png (9, 26 and 100 samples a pixel) and
# 6-error.png (its error, with gonio's strategy and with the paper's). SPP is how many samples a pixel the others have (256 if
# left out). With $GONIO_SERVER set, that server does the work.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
gonio=$top/build/bin/gonio
[ $# -ge 1 ] || { sed -n '2,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
out=$1 spp=${2:-256}
command -v gnuplot >/dev/null || { echo "ashikhmin_shirley.sh: gnuplot is missing; docker/install.sh --demo installs it" >&2; exit 1; }
mkdir -p "$out"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# shirley RD RS NU NV
shirley() {
  printf '{"model": "ashikhmin_shirley", "parameters": {"rd": %s, "rs": %s, "nu": %s, "nv": %s}}' "$@"
}

# tile NAME SIZE MATERIAL ARGUMENT...: one picture of a figure.
tile() {
  local name=$1 size=$2 material=$3
  shift 3
  "$gonio" render --quiet --material "$material" --size "$size" -o "$folder/$name.png" "$@"
}

# figure NAME COLUMNS WIDTH HEIGHT: tiles in $tiles, "NAME|LABEL" each, row after row, become one picture.
tiles=()
figure() {
  {
    printf 'out = "%s"; folder = "%s"; columns = %d; width = %d; height = %d\n' "$out/$1" "$folder" "$2" "$3" "$4"
    printf 'array name[%d]; array label[%d]\n' ${#tiles[@]} ${#tiles[@]}
    local i=0
    for tile in "${tiles[@]}"; do
      i=$((i + 1))
      printf 'name[%d] = "%s"; label[%d] = "%s"\n' $i "${tile%%|*}" $i "${tile#*|}"
    done
    cat "$top/tests/figures/tiles.gp"
  } >"$folder/figure.gp"
  gnuplot "$folder/figure.gp"
  tiles=()
  echo "$out/$1"
}

for nv in 10 100 1000 10000; do
  for nu in 10 100 1000 10000; do
    tile "$nu-$nv" 200x200 "$(shirley 0 0.9 $nu $nv)" --light sky --exposure -1 --spp "$spp" --view-elevation 15
    tiles+=("$nu-$nv|n_u = $nu, n_v = $nv")
  done
done
figure 1-metal.png 4 200 200

tile brushed 640x400 "$(shirley 0 0.9 10 100)" --shape cylinder --light sky --spp "$spp" --view-elevation 25
tiles+=("brushed|n_u = 10, n_v = 100")
figure 2-brushed.png 1 640 400

red='[0.5, 0.03, 0.02]'
for elevation in 80 40 5; do
  tile "polished-$elevation" 260x260 "$(shirley "$red" 0.05 400 400)" --light sky --spp "$spp" --view-elevation $elevation
  tiles+=("polished-$elevation|from $elevation°")
done
figure 3-polished.png 3 260 260

tile lambertian 300x300 "{\"model\": \"lambertian\", \"parameters\": {\"rd\": $red}}" --spp "$spp"
tile diffuse 300x300 "$(shirley "$red" 0.05 5 5)" --spp "$spp"
tiles+=("lambertian|Lambertian" "diffuse|n_u = n_v = 5")
figure 4-diffuse.png 2 300 300

for samples in 9 26 100; do
  tile "closeup-$samples" 260x260 "$(shirley 0 0.9 10 100)" --shape cylinder --light sky --sampling surface --spp $samples \
    --view-elevation 25 --zoom 1.6
  tiles+=("closeup-$samples|$samples samples")
done
figure 6-closeup.png 3 260 260

"$top/build/bin/closeup" >"$folder/closeup.csv"
gnuplot -e "data = '$folder/closeup.csv'; out = '$out/6-error.png'" "$top/tests/figures/closeup.gp"
echo "$out/6-error.png"
