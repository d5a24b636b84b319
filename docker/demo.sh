#!/usr/bin/env bash
# From a machine with nothing installed to real answers: installs, builds, starts goniod, has four materials evaluated for
# a million pairs of directions each through the command line, draws their lobes, fits models to the measured one, and charts
# speed against accuracy. Takes some minutes the first time.
#
#   docker/demo.sh [RESULTS]       RESULTS: a folder for what is made, default out/demo
#
# A measured material comes from $GONIO_DATA (the folder that holds merl/npf.bin) where that is; else one is generated.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  -h | --help) sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
mkdir -p "${1:-$top/out/demo}"
results=$(cd "${1:-$top/out/demo}" && pwd)
cd "$top"

pairs=1000000
seed=2024
step() { printf '\n== %s\n' "$*"; }
fail() { printf 'demo.sh: %s\n' "$*" >&2; exit 1; }

# The server and its socket go away however this script ends.
run_folder=$(mktemp -d)
server=
finish() {
  local status=$?
  trap - EXIT
  if [ -n "$server" ]; then
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
  fi
  rm -rf "$run_folder"
  exit $status
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

step "1. Install what is missing (docker/packages.txt)"
docker/install.sh --build --demo

step "2. Build (release; the log is in $results/build.log)"
if ! { cmake --preset release && cmake --build --preset release --target goniod gonio make_merl; } >"$results/build.log" 2>&1; then
  tail -n 30 "$results/build.log" >&2
  fail "the build failed; the end of its log is above"
fi
bin=$top/build/bin
"$bin/gonio" --version
"$bin/goniod" --version

step "3. Materials and pairs"
materials=$results/materials
rm -rf "$materials"
mkdir -p "$materials"
cp tests/data/materials/*.json "$materials"
data=${GONIO_DATA:-}
if [ -r "$data/merl/npf.bin" ]; then
  measured=yellow-phenolic
  label="yellow phenolic\\n{/*0.8 measured}"
  GONIO_DATA=$data "$bin/make_merl" "$results/$measured.binary" "$measured"
  echo "$measured: measured, from $data/merl"
else
  measured=glossy-example
  label="glossy example\\n{/*0.8 table in the MERL layout}"
  "$bin/make_merl" "$results/$measured.binary"
  echo "$measured: generated, as \$GONIO_DATA names no folder with merl/npf.bin"
fi
tests/data/make_pairs.py "$pairs" "$seed" "$results/pairs.npy"
echo "$pairs pairs of directions (seed $seed): $results/pairs.npy"

step "4. Start goniod on a UNIX socket"
export GONIO_SERVER=unix:$run_folder/goniod.sock
"$bin/goniod" --listen "$GONIO_SERVER" --materials "$materials" 2>"$results/goniod.log" &
server=$!
for ((tries = 0; ; ++tries)); do
  "$bin/gonio" models >"$results/models.txt" 2>"$run_folder/models.err" && break
  kill -0 "$server" 2>/dev/null || { cat "$results/goniod.log" >&2; fail "goniod ended; its log is above"; }
  [ $tries -lt 100 ] || { cat "$run_folder/models.err" >&2; fail "goniod does not answer"; }
  sleep 0.1
done
cat "$results/models.txt"
# The measured material is sent to the server, which stores it in its folder.
"$bin/gonio" put "$measured" "$results/$measured.binary"

step "5. Evaluate $pairs pairs of each material"
# Reads the line that `gonio evaluate -v` reports on stderr into a row of the table.
row() { # NAME FILE
  sed -n -E 's/^gonio: ([0-9]+) pairs x ([0-9]+) channels in ([0-9.]+) s \(([^ ]+) M pairs\/s\); kernels ([0-9.]+) s; ([a-z0-9]+), [a-z]+, relative error <= ([^ ]+) .*/\1 \3 \4 \5 \6 \7/p' "$2" |
    awk -v name="$1" '{ printf "%-22s %9d %8.3f %12.1f %16.2f   %-9s %s\n", name, $1, $2, $3, $4 * 1e9 / $1, $5, $6; found = 1 }
                      END { exit !found }'
}
table=$results/summary.txt
printf '%-22s %9s %8s %12s %16s   %-9s %s\n' material pairs seconds "M pairs/s" "kernel ns/pair" isa "error bound" >"$table"
for material in brushed-metal copper aluminium "$measured"; do
  "$bin/gonio" evaluate --material "$material" --pairs "$results/pairs.npy" -o "$results/$material.npy" -v --quiet 2>"$run_folder/report" ||
    { cat "$run_folder/report" >&2; fail "gonio could not evaluate $material; its message is above"; }
  row "$material" "$run_folder/report" >>"$table" || { cat "$run_folder/report" >&2; fail "no report for $material"; }
  echo "$material: $results/$material.npy"
done
# The same as a table for people: a small grid with its angles.
"$bin/gonio" evaluate --material copper --grid theta_i=0:80:9,theta_o=0:85:18,phi_o=0/90/180 --deg --with-input \
  -o "$results/copper-grid.csv"
echo "copper over a grid of angles: $results/copper-grid.csv"

step "6. Draw the lobes"
tests/figures/polar_lobes.sh "$results/polar_lobes.png" "$measured" "$label"
echo "$results/polar_lobes.png"

step "7. Fit models to $measured, on the server, and compare"
"$bin/gonio" fit --data "$measured" --model cook_torrance,ggx,phong_mix -o "$results/fitted.json" \
  --report "$results/fit.json" --report "$results/fit.md"
echo
"$bin/gonio" compare --reference "$results/$measured.binary" --material "$results/fitted.json" \
  --slices "$results/fit_slices.png" --render "$results/fit_spheres.png"
echo "all that is known of the fits: $results/fit.md; the best beside what is measured: $results/fit_slices.png, $results/fit_spheres.png"

step "8. Chart speed against accuracy, on the server"
"$bin/gonio" chart --quick -o "$results/chart" --data "$measured"

step "9. What was done"
cat "$table"
echo
echo "seconds: one gonio evaluate, reading and writing its files included; kernel: the server's BRDF code alone, summed over its threads"
echo "results: $results"
