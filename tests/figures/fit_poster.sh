#!/usr/bin/env bash
# Spheres as measured, and as fitted with Phong's lobe, Blinn and Phong's, and the mixture of Nielsen, Frisvad, Conradsen &
# Aanaes 2014, "Addressing Grazing Angle Reflections in Phong Models": four materials of the MERL database in one directional
# light, from the front (steep incidence) and from behind (grazing incidence). Made by `gonio fit`, `render` and `compare`.
#
#   tests/figures/fit_poster.sh FOLDER [SPP]
#
# Writes to FOLDER: fit_poster.png, fit_poster.md (the errors by zone of angles) and each fit's material and report. SPP is how
# many samples a pixel the spheres have (64 if left out). The materials come from $GONIO_DATA, the folder that holds
# merl/npf.bin.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$top/build/bin
[ $# -ge 1 ] || { sed -n '2,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
out=$1 spp=${2:-64}
command -v gnuplot >/dev/null || { echo "fit_poster.sh: gnuplot is missing; docker/install.sh --demo installs it" >&2; exit 1; }
export GONIO_DATA=${GONIO_DATA:-$top/../shared/data}
[ -r "$GONIO_DATA/merl/npf.bin" ] || { echo "fit_poster.sh: \$GONIO_DATA names no folder with merl/npf.bin" >&2; exit 1; }
unset GONIO_SERVER
mkdir -p "$out"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

size=176
models=(phong blinn_phong phong_mix)
titles=("Phong" "Blinn–Phong" "mixture")
steep=(--light-theta 60 --light-phi -110)
grazing=(--light-theta 72 --light-phi 118)

# tile NAME MATERIAL LIGHT...: one sphere.
tile() {
  local name=$1 material=$2
  shift 2
  "$bin/gonio" render --quiet --material "$material" --size ${size}x$size --spp "$spp" --background 0 -o "$folder/$name.png" "$@"
}

tiles=()
table=$out/fit_poster.md
printf '| material | model | L1, both angles up to 80° | L1, above 80° | log, up to 80° | log, above 80° |\n|---|---|---|---|---|---|\n' >"$table"
for material in two-layer-silver violet-rubber nickel red-fabric2; do
  file=$folder/$material.binary
  "$bin/make_merl" "$file" "$material"
  fits=()
  for model in "${models[@]}"; do
    fit=$out/$material-$model
    "$bin/gonio" fit --quiet --data "$file" --model "$model" -o "$fit.json" --report "$fit.md"
    fits+=("$fit.json")
  done
  # Name, then L1, RMSE, LOG and CBRT, each for all, up to 80 degrees and above.
  "$bin/gonio" compare --reference "$file" --material "${fits[@]}" | grep -F .json |
    awk -v material="$material" '{ model = $1; sub(/^.*-/, "", model); sub(/\.json$/, "", model)
      printf "| %s | `%s` | %s | %s | %s | %s |\n", material, model, $3, $4, $9, $10 }' >>"$table"
  for light in steep grazing; do
    declare -n arguments=$light
    tile "$material-$light" "$file" "${arguments[@]}"
    tiles+=("$material-$light|$material, measured")
    for i in "${!models[@]}"; do
      tile "$material-$light-$i" "${fits[i]}" "${arguments[@]}"
      tiles+=("$material-$light-$i|${titles[i]}")
    done
  done
done

{
  printf 'out = "%s"; folder = "%s"; columns = 8; width = %d; height = %d\n' "$out/fit_poster.png" "$folder" $size $size
  printf 'array name[%d]; array label[%d]\n' ${#tiles[@]} ${#tiles[@]}
  i=0
  for tile in "${tiles[@]}"; do
    i=$((i + 1))
    printf 'name[%d] = "%s"; label[%d] = "%s"\n' $i "${tile%%|*}" $i "${tile#*|}"
  done
  cat "$top/tests/figures/tiles.gp"
} >"$folder/figure.gp"
gnuplot "$folder/figure.gp"
echo "$out/fit_poster.png"
cat "$table"
